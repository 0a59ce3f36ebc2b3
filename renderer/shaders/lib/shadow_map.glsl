// Reading shadow maps out of the store: metrics for those who build on them, lookupTau for those who shade.
// Variant constants: METRIC_FLOATS and BASIS_FLOATS (largest of the lights present), STORES (bit per STORE_* kind in use), and where
// all mapped lights agree (UNIFORM_MAPS) their METRIC, METRIC_COUNT, BASIS and COEFFICIENTS, so that nothing else is compiled in.
#pragma once
#include "shared/bindings.h"
#include "shared/records.h"
#include "lib/metric.glsl"

layout(std140, binding = BIND_LIGHTS) uniform LightBlock { LightRecord lights[MAX_LIGHTS]; };
layout(binding = UNIT_SHADOW_FLOAT) uniform sampler2DArray shadowFloat;
layout(binding = UNIT_SHADOW_HALF) uniform sampler2DArray shadowHalf;
layout(binding = UNIT_SHADOW_UNORM) uniform sampler2DArray shadowUnorm;

// One layer of a block at map coordinates uv in [0,1]^2, bilinear within the block.
vec4 sampleBlock(ivec4 place, int store, vec2 uv, int layer) {
  vec2 at = vec2(place.xy) + clamp(uv * float(place.z), vec2(0.5), vec2(float(place.z) - 0.5));
#if STORES == 1
  return textureLod(shadowFloat, vec3(at / vec2(textureSize(shadowFloat, 0).xy), float(place.w + layer)), 0.0);
#else
  if (store == STORE_FLOAT) return textureLod(shadowFloat, vec3(at / vec2(textureSize(shadowFloat, 0).xy), float(place.w + layer)), 0.0);
  if (store == STORE_HALF) return textureLod(shadowHalf, vec3(at / vec2(textureSize(shadowHalf, 0).xy), float(place.w + layer)), 0.0);
  return textureLod(shadowUnorm, vec3(at / vec2(textureSize(shadowUnorm, 0).xy), float(place.w + layer)), 0.0);
#endif
}

vec4 fetchFirstLayer(ivec4 place, int store, ivec2 texel) {
  ivec3 p = ivec3(place.xy + clamp(texel, ivec2(0), ivec2(place.z - 1)), place.w);
#if STORES == 1
  return texelFetch(shadowFloat, p, 0);
#else
  if (store == STORE_FLOAT) return texelFetch(shadowFloat, p, 0);
  if (store == STORE_HALF) return texelFetch(shadowHalf, p, 0);
  return texelFetch(shadowUnorm, p, 0);
#endif
}

void loadMetric(int light, vec2 uv, out float m[METRIC_FLOATS]) {
  ivec4 place = lights[light].metric.place;
  ivec2 kind = lights[light].metric.kind.xy;
  for (int i = 0; i < METRIC_FLOATS; i += 4) {
    vec4 v = sampleBlock(place, kind.x, uv, min(i / 4, kind.y - 1));
    for (int j = 0; j < 4; ++j) m[i + j] = i < 4 * kind.y ? v[j] : 1.0;
  }
}

// A coefficient texel's footprint (itself, right, below, diagonal) is mixed when the intervals of its metrics do not match: then
// neither metrics nor coefficients may be blended. The map's builder notes it in the lowest bit of one coefficient of the first layer.
int mixedChannel(int coefficients) { return min(coefficients, 4) - 1; }
bool mixedBit(vec4 first, int coefficients, int store) {
  float c = first[mixedChannel(coefficients)];
  return store == STORE_FLOAT ? (floatBitsToUint(c) & 1u) != 0u : (packHalf2x16(vec2(c, 0.0)) & 1u) != 0u;
}
float withMixedBit(float c, bool mixed, int store) {
  uint bit = mixed ? 1u : 0u;
  if (store == STORE_FLOAT) return uintBitsToFloat((floatBitsToUint(c) & ~1u) | bit);
  return unpackHalf2x16((packHalf2x16(vec2(c, 0.0)) & ~1u) | bit).x;
}

// Optical depth between the light and a world position. Within one kind of metric the hardware blends metric and coefficients and
// they are evaluated once; at silhouettes the four texels are evaluated each by its own metric and transmittance is blended.
float lookupTau(int light, vec3 world) {
  vec3 q = (lights[light].lightFromWorld * vec4(world, 1.0)).xyz;
  float x = clamp(q.z, 0.0, 1.0);
  ivec4 place = lights[light].coefficients.place;
  int store = lights[light].coefficients.kind.x, layers = lights[light].coefficients.kind.y;
#ifdef UNIFORM_MAPS
  const int metric = METRIC, metricCount = METRIC_COUNT, basis = BASIS, n = COEFFICIENTS;
#else
  int metric = lights[light].shadow.w, metricCount = lights[light].items.x, basis = lights[light].shadow.y, n = lights[light].shadow.z;
#endif
  vec2 f = q.xy * float(place.z) - 0.5, base = floor(f), w = f - base;
  int taps = 1;
  if (metric == METRIC_INTERVAL && mixedBit(fetchFirstLayer(place, store, ivec2(base)), n, store)) taps = 4;
  float m[METRIC_FLOATS], c[BASIS_FLOATS];
  for (int i = 0; i < METRIC_FLOATS; ++i) m[i] = 1.0;
  float tau = 0.0, transmittance = 0.0, weights = 0.0;
  int tap = 0;
  do {
    vec2 o = vec2(float(tap & 1), float(tap >> 1));
    vec2 uv = taps == 1 ? q.xy : (base + o + 0.5) / float(place.z);
    if (metric != METRIC_NONE) loadMetric(light, uv, m);
    for (int i = 0; i < BASIS_FLOATS; i += 4) {
      vec4 v = sampleBlock(place, store, uv, min(i / 4, layers - 1));
      for (int j = 0; j < 4 && i + j < BASIS_FLOATS; ++j) c[i + j] = v[j];
    }
    tau = basisTau(basis, n, c, metricU(metric, metricCount, m, x));
    // What is lit here lies in a medium: a texel whose ray meets none says nothing about it.
    float weight = mix(1.0 - w.x, w.x, o.x) * mix(1.0 - w.y, w.y, o.y) + 1e-6;
    if (metric == METRIC_INTERVAL && m[1] <= m[0]) weight *= 1e-6;
    transmittance += weight * exp(-tau);
    weights += weight;
    ++tap;
  } while (tap < taps);
  bool outside = any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0))) || q.z <= 0.0;
  return outside ? 0.0 : taps == 1 ? tau : -log(max(transmittance / weights, 1e-30));
}
