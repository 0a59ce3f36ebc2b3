// Single scattering, front to back: L = integral of T_cam sigma_s p E T_light ds, one sample per pixel and dispatch, averaged into the
// target. Overlapping volumes are marched together; the step is the smallest of those active. The march ends at the nearest solid, which
// adds T_cam albedo / pi SUM E cos T_light. What emits adds its radiance per metre to the source, and lights nothing.
// Variant constants: ACTIVE (volumes of an overlap kept in registers), OVERFLOW (1: there may be more; they are visited one by one),
// LIGHTS (their number, or 0: lightCount), SOLIDS (1: there are some to draw), SHAPES, DEPTH (1: no light, but the mean
// depth of what scatters), EMISSION (1: some volumes emit, and it counts), RESUME (1: a sample may take several dispatches,
// lib/resume.glsl) and those of lib/light_transmittance.glsl.
#include "lib/volume.glsl"
#include "lib/tiles.glsl"
#include "lib/light_transmittance.glsl"
#include "lib/random.glsl"
#include "lib/phase.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = IMAGE_TARGET) uniform image2D target;
uniform ivec2 regionOrigin, regionEnd, size;
uniform vec3 eye, right, up, back;  // right and up are scaled to half the picture at distance 1
uniform float pixelAngle;           // footprint [m] of a pixel per metre of distance
uniform float stepScale;
uniform int lightCount, sampleIndex, samples;  // at least one light (a black one, if need be)
uniform int solidCount;                        // drawn: the first ones

// Scattering per unit length and solid angle of volume v: sigma_s p.
vec3 scattering(vec4 albedo, vec4 medium, float cosine) { return medium.w * (albedo.rgb * medium.rgb) * phaseHg(cosine, albedo.w); }

#if EMISSION
// Radiance that volume v's table (factor and all) adds per metre; nothing of a medium.
vec3 emission(VolumeRay ray, vec4 factor, vec4 table) { return ray.extinction < 0.0 ? factor.rgb * table.rgb : vec3(0.0); }
#endif

#if RESUME
// What light l sends to p, black where that is counted already or has to wait for the next dispatch.
vec3 arrivingIfDue(int l, vec3 p, bool inMedium, out vec3 towards) {
  vec3 arriving = vec3(0.0);
  towards = vec3(0.0);
  if (lightIsDue(l)) {
    arriving = lightArriving(l, p, inMedium, towards);
    if (!paused) state.light = l + 1;
  }
  return paused ? vec3(0.0) : arriving;
}
#endif

#if SOLIDS
// Radiance [W/(m^2 sr)] that solid s sends back from its point p.
vec3 reflected(int s, vec3 p, vec3 normal, float t) {
  vec3 off = p + solidClearance(s, p, normal, t) * normal, sum = vec3(0.0);
  int l = 0;
  do {
    vec3 towards;
#if RESUME
    vec3 arriving = arrivingIfDue(l, off, false, towards);
#else
    vec3 arriving = lightArriving(l, off, false, towards);
#endif
    sum += arriving * max(dot(normal, towards), 0.0);
    ++l;
  } while (l < lightCount);
  return sum * solidAlbedo(s) / 3.14159265358979;
}
#endif

void main() {
  ivec2 pixel = regionOrigin + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, regionEnd))) return;
  vec3 r = pixelSample(pixel, sampleIndex, samples);
  vec2 ndc = (vec2(pixel) + r.xy) / vec2(size) * 2.0 - 1.0;
  vec3 d = normalize(ndc.x * right - ndc.y * up - back);
  ivec2 range = tileRange(pixel);

  VolumeRay rays[ACTIVE];
  vec4 albedo[ACTIVE];
  vec4 media[ACTIVE];  // at the sample: factor of the albedo, sigma_t
  float T = 1.0, t = 0.0, next = 0.0;
  vec3 L = vec3(0.0);  // with DEPTH: sums of weight and depth, and of weight
#if DEPTH
  float forward = -dot(d, back);
#endif
  bool inMedia = range.x < range.y;
#if RESUME
  int slot = (pixel.y - regionOrigin.y) * (regionEnd.x - regionOrigin.x) + pixel.x - regionOrigin.x;
  if (dispatchIndex > 0) state = states[slot];
  if (state.phase == kFinished) return;
  L = state.seen.rgb, T = state.seen.a, t = state.t;
  inMedia = inMedia && state.phase == kInMedia;
#endif
#if SOLIDS
  int solid;
  vec3 normal;
  float end = nearestSolid(solidCount, eye, d, solid, normal);
#else
  const float end = kNoHit;
#endif
  while (inMedia) {
    SPEND(stretchCost);
    // Who is active just after t, and until when does that stay so?
    next = 1e30;
    int count = 0, rest = range.y;
    float ds = 1e30;
    for (int item = range.x; item < range.y; ++item) {
      int v = tileItem(item);
      float footprint = pixelAngle * t;
      VolumeRay ray;
      vec2 hit = enterVolume(v, eye, d, levelFor(v, footprint), ray);
      bool ahead = hit.x < hit.y && hit.y > t, inside = ahead && hit.x <= t;
      next = ahead ? min(next, inside ? hit.y : hit.x) : next;
      ds = inside ? min(ds, stepFor(v, footprint)) : ds;
      for (int k = 0; k < ACTIVE; ++k) {
        if (inside && count == k) {
          rays[k] = ray;
          albedo[k] = albedoOf(v);
        }
      }
      rest = inside && count == ACTIVE ? min(rest, item) : rest;
      count += inside ? 1 : 0;
    }
    if (next >= 1e30) break;
#if SOLIDS
    next = min(next, end);
#endif
    if (count > 0) {
      ds *= stepScale;
      int n = int(clamp(ceil((next - t) / ds), 1.0, float(CAMERA_MOST_STEPS)));
      ds = (next - t) / float(n);
      int i = 0;
#if RESUME
      i = state.step;
#endif
      do {
        // On to the next sample with something in it.
        float sigma, at;
#if EMISSION
        vec3 glow;
#endif
        do {
          at = t + (float(i) + r.z) * ds;
          float empty = 1e30;
          for (int k = 0; k < ACTIVE; ++k) empty = k < count ? min(empty, emptyUntil(rays[k], at)) : empty;
#if OVERFLOW
          empty = rest < range.y ? at : empty;
#endif
          int to = stepAtOrBehind(i, empty, t, r.z, ds);
          sigma = 0.0;
#if EMISSION
          glow = vec3(0.0);
#endif
          for (int k = 0; k < ACTIVE; ++k) {
            media[k] = k < count && to == i ? mediumAt(rays[k], at) : vec4(vec3(1.0), 0.0);
            sigma += media[k].w;
#if EMISSION
            glow += k < count && to == i ? emission(rays[k], albedo[k], media[k]) : vec3(0.0);
#endif
          }
#if OVERFLOW
          for (int item = rest; item < range.y; ++item) {
            VolumeRay ray;
            vec2 hit = enterVolume(tileItem(item), eye, d, levelFor(tileItem(item), pixelAngle * t), ray);
            if (hit.x <= t && hit.y > t) {
              vec4 here = mediumAt(ray, at);
              sigma += here.w;
#if EMISSION
              glow += emission(ray, albedoOf(tileItem(item)), here);
#endif
            }
          }
#endif
#if EMISSION
          // Where nothing scatters no light is looked up: the step's emission passes as it is.
          L += sigma <= 0.0 ? T * ds * glow : vec3(0.0);
          glow = sigma <= 0.0 ? vec3(0.0) : glow;
#endif
#if RESUME
          state.step = i;
#endif
          i = max(to, i + 1);
          SPEND(stepCost);
#if RESUME
        } while (sigma <= 0.0 && i < n && !mustPause());
        if (sigma <= 0.0) foundNothing(i, n);
        SPEND(sampleCost);
#else
        } while (sigma <= 0.0 && i < n);
#endif

#if !DEPTH
        vec3 p = eye + at * d, source = vec3(0.0);
#if LIGHTS
        for (int l = 0; l < LIGHTS; ++l) {  // unrolled: offsets into the uniform block are constants
#else
        int l = 0;
        do {
#endif
          vec3 towards;
#if RESUME
          vec3 arriving = arrivingIfDue(l, p, true, towards);
#else
          vec3 arriving = lightArriving(l, p, true, towards);
#endif
          // Light travels along -towards and is scattered into -d: the cosine between the two directions of travel.
          float cosine = dot(towards, d);
          vec3 factor = vec3(0.0);
          for (int k = 0; k < ACTIVE; ++k) factor += k < count ? scattering(albedo[k], media[k], cosine) : vec3(0.0);
#if OVERFLOW
          for (int item = rest; item < range.y; ++item) {
            VolumeRay ray;
            vec2 hit = enterVolume(tileItem(item), eye, d, levelFor(tileItem(item), pixelAngle * t), ray);
            if (hit.x <= t && hit.y > t) factor += scattering(albedoOf(tileItem(item)), mediumAt(ray, at), cosine);
          }
#endif
          source += factor * arriving;
#if LIGHTS
        }
#else
          ++l;
        } while (l < lightCount);
#endif
#endif
#if EMISSION
#if RESUME
        source += paused ? vec3(0.0) : glow;  // with the step's last light
#else
        source += glow;
#endif
#endif
        float step = exp(-sigma * ds);
#if DEPTH
        L.xy += T * (1.0 - step) * vec2(at * forward, 1.0);
#else
        // Exact over the step for a constant source and extinction.
        L += T * (sigma * ds < 1e-4 ? ds * (1.0 - 0.5 * sigma * ds) : (1.0 - step) / max(sigma, 1e-30)) * source;
#endif
#if RESUME
        if (!paused) {
          T *= step;
          state.step = i, state.light = 0;
          paused = mustPause() && i < n && T >= 1e-4;
        }
      } while (i < n && T >= 1e-4 && !paused);
#else
        T *= step;
      } while (i < n && T >= 1e-4);
#endif
    }
#if RESUME
    if (!paused) {
      t = next;
      state.step = 0;
      paused = mustPause() && T >= 1e-4 && t < end;
    }
    inMedia = !paused && T >= 1e-4 && t < end;
  }
  state.phase = paused ? kInMedia : kAtSolid;
#else
    t = next;
    inMedia = T >= 1e-4 && t < end;
  }
#endif
  if (T < 1e-4) T = 0.0;
#if SOLIDS
#if DEPTH
#define OF_SOLID vec3(end * forward, 1.0, 0.0)
#else
#define OF_SOLID reflected(solid, eye + end * d, normal, end)
#endif
#if RESUME
  SPEND(sampleCost);
  if (end < kNoHit && T > 0.0 && !paused) {
    L += T * OF_SOLID;
    T = paused ? T : 0.0;
  }
#else
  if (end < kNoHit && T > 0.0) {
    L += T * OF_SOLID;
    T = 0.0;
  }
#endif
#endif
#if RESUME
  state.seen = vec4(L, T);
  state.t = t;
  if (!paused) state.phase = kFinished;
  states[slot] = state;
  if (paused) {
    atomicAdd(unfinished, 1);
    return;
  }
#endif
  vec4 before = sampleIndex == 0 ? vec4(0.0) : imageLoad(target, pixel);
#if DEPTH
  // Weights are averaged, depths by their weights: a pixel half covered is as far away as what covers it.
  if (any(isnan(L)) || any(isinf(L))) L = vec3(0.0);
  float weight = before.a * float(sampleIndex), all = weight + L.y;
  float depth = all > 0.0 ? (before.r * weight + L.x) / all : 0.0;
  imageStore(target, pixel, vec4(vec3(depth), all / float(sampleIndex + 1)));
#else
  vec4 now = vec4(L, 1.0 - T);
  if (any(isnan(now)) || any(isinf(now))) now = vec4(0.0);
  imageStore(target, pixel, before + (now - before) / float(sampleIndex + 1));
#endif
}
