// How far shadow maps are off in what a picture shows: marches camera rays as view/volume_render does, pixel centres and step midpoints,
// and at each sample with extinction asks both lights of each pair, 2 i with its map and 2 i + 1 with ray-marched truth.
// Adds to `errors` (SUM w dT, SUM |dT|, the dT of largest magnitude, number of samples) and to `transmittances` (SUM w T, SUM w T true,
// SUM w, 0), w: how much of the sample is seen. A solid behind the media has its say in the picture (w, dT), but is no sample of them.
// Variant constants: ACTIVE, OVERFLOW, SOLIDS, RESUME as in view/volume_render, SHAPES and those of lib/light_transmittance.glsl.
#include "shared/compare.h"
#include "lib/light_transmittance.glsl"
#include "lib/tiles.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = IMAGE_ERROR) uniform image2D errors;
layout(rgba32f, binding = IMAGE_TRANSMITTANCE) uniform image2D transmittances;
layout(std430, binding = BIND_ERROR_BINS) buffer Bins { uint bins[ERROR_BINS]; };
uniform ivec2 regionOrigin, regionEnd, size;
uniform vec3 eye, right, up, back;  // right and up are scaled to half the picture at distance 1
uniform float pixelAngle, stepScale;
uniform int pairCount, solidCount;

vec4 error, transmittance;

void addPair(int i, vec3 p, float weight, float facing, bool inMedium) {
  int l = 2 * i;
  Incidence in_ = unshadowed(l, p);
  float reached = solidVisibility(l, p, in_.towards, in_.distance) * facing;
  if (reached <= 0.0 || all(lessThanEqual(in_.irradiance, vec3(0.0)))) return;
#if RESUME
  if (!lightIsDue(l + 1)) return;
  if (lightIsDue(l)) {
    state.seen.x = lightTransmittanceTowards(l, p, in_.towards, in_.distance, inMedium);
    state.light = paused ? l : l + 1;
    if (paused) return;
  }
  float mapped = state.seen.x, truth = lightTransmittanceTowards(l + 1, p, in_.towards, in_.distance, inMedium);
  state.light = paused ? l + 1 : l + 2;
  if (paused) return;
#else
  float mapped = lightTransmittanceTowards(l, p, in_.towards, in_.distance, inMedium), truth = lightTransmittanceTowards(l + 1, p, in_.towards, in_.distance, inMedium);
#endif
  float d = mapped - truth, magnitude = abs(d);
  transmittance += weight * reached * vec4(mapped, truth, 1.0, 0.0);
  error.x += weight * reached * d;
  if (!inMedium) return;
  error.y += magnitude;
  error.z = magnitude > abs(error.z) ? d : error.z;
  error.w += 1.0;
  const float kBinsPerDecade = float(ERROR_BINS - 1) / ERROR_DECADES;
  int bin = magnitude < ERROR_LEAST ? 0 : 1 + int(kBinsPerDecade * log2(magnitude / ERROR_LEAST) / log2(10.0));
  atomicAdd(bins[min(bin, ERROR_BINS - 1)], 1u);
}

void addAll(vec3 p, float weight) {
  for (int i = 0; i < pairCount; ++i) addPair(i, p, weight, 1.0, true);
}

#if SOLIDS
float nearestSolid(vec3 o, vec3 d, out int solid, out vec3 normal) {
  float nearest = kNoHit;
  solid = 0;
  normal = -d;
  for (int s = 0; s < solidCount; ++s) {
    vec3 n;
    float t = hitSolid(s, o, d, 0.0, n);
    if (t >= nearest) continue;
    nearest = t, solid = s, normal = n;
  }
  return nearest;
}

void addSurface(int s, vec3 p, vec3 normal, float t, float weight) {
  vec3 off = p + solidClearance(s, p, normal, t) * normal;
  for (int i = 0; i < pairCount; ++i) addPair(i, off, weight, max(dot(normal, unshadowed(2 * i, off).towards), 0.0), false);
}
#endif

void main() {
  ivec2 pixel = regionOrigin + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, regionEnd))) return;
  vec2 ndc = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  vec3 d = normalize(ndc.x * right - ndc.y * up - back);
  ivec2 range = tileRange(pixel);
  error = imageLoad(errors, pixel);
  transmittance = imageLoad(transmittances, pixel);

  VolumeRay rays[ACTIVE];
  float T = 1.0, t = 0.0, next = 0.0;
  bool inMedia = range.x < range.y;
#if RESUME
  int slot = (pixel.y - regionOrigin.y) * (regionEnd.x - regionOrigin.x) + pixel.x - regionOrigin.x;
  if (dispatchIndex > 0) state = states[slot];
  if (state.phase == kFinished) return;
  T = state.seen.a, t = state.t;
  inMedia = inMedia && state.phase == kInMedia;
#endif
#if SOLIDS
  int solid;
  vec3 normal;
  float end = nearestSolid(eye, d, solid, normal);
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
      for (int k = 0; k < ACTIVE; ++k)
        if (inside && count == k) rays[k] = ray;
      rest = inside && count == ACTIVE ? min(rest, item) : rest;
      count += inside ? 1 : 0;
    }
    if (next >= 1e30) break;
    next = min(next, end);
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
        do {
          at = t + (float(i) + 0.5) * ds;
          float empty = 1e30;
          for (int k = 0; k < ACTIVE; ++k) empty = k < count ? min(empty, emptyUntil(rays[k], at)) : empty;
#if OVERFLOW
          empty = rest < range.y ? at : empty;
#endif
          int to = stepAtOrBehind(i, empty, t, 0.5, ds);
          sigma = 0.0;
          for (int k = 0; k < ACTIVE; ++k) sigma += k < count && to == i ? sigmaAt(rays[k], at) : 0.0;
#if OVERFLOW
          for (int item = rest; item < range.y; ++item) {
            VolumeRay ray;
            vec2 hit = enterVolume(tileItem(item), eye, d, levelFor(tileItem(item), pixelAngle * t), ray);
            if (hit.x <= t && hit.y > t) sigma += sigmaAt(ray, at);
          }
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

        float step = exp(-sigma * ds);
        if (sigma > 0.0) addAll(eye + at * d, T * (1.0 - step));
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
  SPEND(sampleCost);
#else
    t = next;
    inMedia = T >= 1e-4 && t < end;
  }
#endif
#if SOLIDS
#if RESUME
  if (!paused)
#endif
  if (end < kNoHit && T >= 1e-4) addSurface(solid, eye + end * d, normal, end, T);
#endif
#if RESUME
  state.seen.a = T;
  state.t = t;
  if (!paused) state.phase = kFinished;
  states[slot] = state;
  if (paused) atomicAdd(unfinished, 1);
#endif
  imageStore(errors, pixel, error);
  imageStore(transmittances, pixel, transmittance);
}
