// Single scattering, front to back: L = integral of T_cam sigma_s p E T_light ds, one sample per pixel and dispatch, averaged into the
// target. Overlapping volumes are marched together; the step is the smallest of those active.
#include "lib/volume.glsl"
#include "lib/tiles.glsl"
#include "lib/shadow_map.glsl"
#include "lib/random.glsl"
#include "lib/phase.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = IMAGE_TARGET) uniform image2D target;
layout(std430, binding = BIND_SHADOW_ITEMS) readonly buffer ShadowItems { int shadowItems[]; };
uniform ivec2 regionOrigin, regionEnd, size;
uniform vec3 eye, right, up, back;  // right and up are scaled to half the picture at distance 1
uniform float pixelAngle;           // footprint [m] of a pixel per metre of distance
uniform float stepScale;
uniform int lightCount, sampleIndex, samples;

const int kActive = 6;  // volumes of an overlap kept in registers; more are visited one by one
int activeVolume[kActive];
LocalRay activeRay[kActive];
int activeLevel[kActive];

float lightTau(int i, vec3 p) {
  int kind = lights[i].shadow.x;
#if LIGHT_KINDS & 2
  if (kind == SHADOW_EXTINCTION) return lookupTau(i, p);
#endif
#if LIGHT_KINDS & 4
  if (kind == SHADOW_RAY_MARCH) {
    float tau = 0.0;
    for (int k = 0; k < lights[i].items.z && tau < 30.0; ++k)
      tau += opticalDepth(shadowItems[lights[i].items.y + k], p, lights[i].towards.xyz, lights[i].extent.y);
    return tau;
  }
#endif
  return 0.0;
}

// In-scattered radiance per unit length of one volume: sigma_s p E summed over the lights needs E T per light once, so it is computed
// by the caller; this is the volume's factor.
vec3 scatterFactor(int v, float sigma, float cosine) { return sigma * volumes[v].albedo.rgb * phaseHg(cosine, volumes[v].albedo.w); }

void main() {
  ivec2 pixel = regionOrigin + ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, regionEnd))) return;
  vec3 r = pixelSample(pixel, sampleIndex, samples);
  vec2 ndc = (vec2(pixel) + r.xy) / vec2(size) * 2.0 - 1.0;
  vec3 d = normalize(ndc.x * right - ndc.y * up - back);
  ivec2 range = tileRange(pixel);

  float T = 1.0;
  vec3 L = vec3(0.0);
  float t = 0.0;
  for (int guard = 0; guard < 65536; ++guard) {
    // Who is active just after t, and until when does that stay so?
    float next = 1e30;
    int count = 0, lastStored = range.y;
    bool overflow = false;
    float ds = 1e30;
    for (int item = range.x; item < range.y; ++item) {
      int v = tileItems[item];
      LocalRay lr = localRay(v, eye, d);
      vec2 hit = intersectVolume(v, lr);
      if (hit.x >= hit.y || hit.y <= t) continue;
      if (hit.x > t) {
        next = min(next, hit.x);
        continue;
      }
      next = min(next, hit.y);
      float footprint = pixelAngle * t;
      ds = min(ds, stepFor(v, footprint));
      if (count < kActive) {
        activeVolume[count] = v;
        activeRay[count] = lr;
        activeLevel[count] = levelFor(v, footprint);
        ++count;
      } else if (!overflow) {
        overflow = true;
        lastStored = item;
      }
    }
    if (next >= 1e30) break;
    if (count == 0) {
      t = next;
      continue;
    }
    ds *= stepScale;
    int n = int(clamp(ceil((next - t) / ds), 1.0, 8192.0));
    ds = (next - t) / float(n);
    float start = t;
    for (int i = 0; i < n;) {
      float at = start + (float(i) + r.z) * ds;
      float sigma = 0.0, skip = 1e30;
      float sigmas[kActive];
      for (int k = 0; k < kActive; ++k) {
        if (k >= count) break;
        float skipTo;
        sigmas[k] = sigmaOnRay(activeVolume[k], activeRay[k], at, activeLevel[k], skipTo);
        sigma += sigmas[k];
        skip = min(skip, skipTo);
      }
      if (overflow) {
        skip = at;
        for (int item = lastStored; item < range.y; ++item) {
          int v = tileItems[item];
          LocalRay lr = localRay(v, eye, d);
          vec2 hit = intersectVolume(v, lr);
          float unused;
          if (hit.x < at && hit.y > at) sigma += sigmaOnRay(v, lr, at, levelFor(v, pixelAngle * start), unused);
        }
      }
      if (sigma > 0.0) {
        vec3 p = eye + at * d;
        float step = exp(-sigma * ds);
        vec3 source = vec3(0.0);
        for (int l = 0; l < lightCount; ++l) {
          // Light travels along -towards; scattering into -d: cosine between the two directions of travel.
          float cosine = dot(lights[l].towards.xyz, d);
          vec3 factor = vec3(0.0);
          for (int k = 0; k < kActive; ++k) {
            if (k >= count) break;
            if (sigmas[k] > 0.0) factor += scatterFactor(activeVolume[k], sigmas[k], cosine);
          }
          if (overflow) {
            for (int item = lastStored; item < range.y; ++item) {
              int v = tileItems[item];
              LocalRay lr = localRay(v, eye, d);
              vec2 hit = intersectVolume(v, lr);
              float unused;
              if (hit.x < at && hit.y > at)
                factor += scatterFactor(v, sigmaOnRay(v, lr, at, levelFor(v, pixelAngle * start), unused), cosine);
            }
          }
          source += factor * lights[l].emitted.rgb * exp(-lightTau(l, p));
        }
        // Exact over the step for a constant source and extinction.
        float weight = sigma * ds < 1e-4 ? ds * (1.0 - 0.5 * sigma * ds) : (1.0 - step) / sigma;
        L += T * weight * source;
        T *= step;
        if (T < 1e-4) break;
      }
      i = max(i + 1, int(min((skip - start) / ds + 1.0 - r.z, 1e6)));
    }
    if (T < 1e-4) break;
    t = next;
  }
  if (T < 1e-4) T = 0.0;
  vec4 now = vec4(L, 1.0 - T);
  if (any(isnan(now)) || any(isinf(now))) now = vec4(0.0);
  vec4 before = sampleIndex == 0 ? vec4(0.0) : imageLoad(target, pixel);
  imageStore(target, pixel, before + (now - before) / float(sampleIndex + 1));
}
