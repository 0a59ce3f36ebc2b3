// Reading shadow maps out of the store: texels for those who build on them, lookupTau for those who shade.
// Variant constants: METRIC_FLOATS and BASIS_FLOATS (largest of the lights present), STORES (bit per STORE_* kind in use).
#pragma once
#include "shared/bindings.h"
#include "shared/records.h"
#include "lib/metric.glsl"

layout(std430, binding = BIND_LIGHTS) readonly buffer LightBuffer { LightRecord lights[]; };
layout(binding = UNIT_SHADOW_FLOAT) uniform sampler2DArray shadowFloat;
layout(binding = UNIT_SHADOW_HALF) uniform sampler2DArray shadowHalf;
layout(binding = UNIT_SHADOW_UNORM) uniform sampler2DArray shadowUnorm;

vec4 fetchBlock(BlockRecord b, ivec2 texel, int layer) {
  ivec3 p = ivec3(b.place.xy + clamp(texel, ivec2(0), ivec2(b.place.z - 1)), b.place.w + layer);
#if STORES == 1
  return texelFetch(shadowFloat, p, 0);
#else
  if (b.kind.x == STORE_FLOAT) return texelFetch(shadowFloat, p, 0);
  if (b.kind.x == STORE_HALF) return texelFetch(shadowHalf, p, 0);
  return texelFetch(shadowUnorm, p, 0);
#endif
}

// The metric that coefficient texel `texel` was built with: the metric's texel at its centre.
void loadMetric(int light, ivec2 texel, out float m[METRIC_FLOATS]) {
  BlockRecord b = lights[light].metric;
  ivec2 t = ivec2((vec2(texel) + 0.5) * (float(b.place.z) / float(lights[light].coefficients.place.z)));
  for (int i = 0; i < METRIC_FLOATS; i += 4) {
    vec4 v = i < 4 * b.kind.y ? fetchBlock(b, t, i / 4) : vec4(1.0);
    for (int j = 0; j < 4 && i + j < METRIC_FLOATS; ++j) m[i + j] = v[j];
  }
}

void addCoefficients(int light, ivec2 texel, float weight, inout float c[BASIS_FLOATS]) {
  BlockRecord b = lights[light].coefficients;
  for (int i = 0; i < BASIS_FLOATS; i += 4) {
    if (i >= 4 * b.kind.y) break;
    vec4 v = weight * fetchBlock(b, texel, i / 4);
    for (int j = 0; j < 4 && i + j < BASIS_FLOATS; ++j) c[i + j] += v[j];
  }
}

// Optical depth between the light and a world position. Coefficients interpolate only within one metric: where the four texels have
// the same number of intervals their metrics and coefficients are blended and evaluated once; where they differ (silhouettes) each is
// evaluated by its own metric and transmittance is blended.
float lookupTau(int light, vec3 world) {
  LightRecord l = lights[light];
  vec3 q = (l.lightFromWorld * vec4(world, 1.0)).xyz;
  if (any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0))) || q.z <= 0.0) return 0.0;
  float x = min(q.z, 1.0);
  vec2 f = q.xy * float(l.coefficients.place.z) - 0.5;
  ivec2 base = ivec2(floor(f));
  vec2 w = f - vec2(base);
  int metric = l.shadow.w, basis = l.shadow.y, n = l.shadow.z;

  float m[METRIC_FLOATS];
  float mixed[METRIC_FLOATS];
  for (int i = 0; i < METRIC_FLOATS; ++i) mixed[i] = 0.0;
  bool same = true;
  if (metric != METRIC_NONE) {
    int count = 0;
    for (int tap = 0; tap < 4; ++tap) {
      ivec2 o = ivec2(tap & 1, tap >> 1);
      float weight = (o.x == 1 ? w.x : 1.0 - w.x) * (o.y == 1 ? w.y : 1.0 - w.y);
      loadMetric(light, base + o, m);
      for (int i = 0; i < METRIC_FLOATS; ++i) mixed[i] += weight * m[i];
      if (metric == METRIC_INTERVAL) {
        int here = intervalCount(m);
        if (tap == 0) count = here;
        same = same && here == count;
      }
    }
    if (same && metric == METRIC_INTERVAL && count == 0) return 0.0;
  }
  float c[BASIS_FLOATS];
  if (same) {
    for (int i = 0; i < BASIS_FLOATS; ++i) c[i] = 0.0;
    for (int tap = 0; tap < 4; ++tap) {
      ivec2 o = ivec2(tap & 1, tap >> 1);
      addCoefficients(light, base + o, (o.x == 1 ? w.x : 1.0 - w.x) * (o.y == 1 ? w.y : 1.0 - w.y), c);
    }
    return basisTau(basis, n, c, metricU(metric, l.items.x, mixed, x));
  }
  float transmittance = 0.0;
  for (int tap = 0; tap < 4; ++tap) {
    ivec2 o = ivec2(tap & 1, tap >> 1);
    float weight = (o.x == 1 ? w.x : 1.0 - w.x) * (o.y == 1 ? w.y : 1.0 - w.y);
    loadMetric(light, base + o, m);
    for (int i = 0; i < BASIS_FLOATS; ++i) c[i] = 0.0;
    addCoefficients(light, base + o, 1.0, c);
    transmittance += weight * exp(-basisTau(basis, n, c, metricU(metric, l.items.x, m, x)));
  }
  return -log(max(transmittance, 1e-30));
}
