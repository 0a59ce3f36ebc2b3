// Layers of shadow maps in the store. STORES: bit per STORE_* kind that coefficients and metrics of the variant use.
#pragma once
#include "shared/bindings.h"
#include "shared/records.h"
#include "lib/light.glsl"
#include "lib/metric.glsl"

layout(binding = UNIT_SHADOW_FLOAT) uniform sampler2DArray shadowFloat;
layout(binding = UNIT_SHADOW_HALF) uniform sampler2DArray shadowHalf;
layout(binding = UNIT_SHADOW_UNORM) uniform sampler2DArray shadowUnorm;
layout(binding = UNIT_SHADOW_BYTE) uniform sampler2DArray shadowByte;
layout(binding = UNIT_SHADOW_PAIR) uniform sampler2DArray shadowPair;

// Texel position of map coordinates uv in [0,1]^2, bilinear footprint within the block.
vec2 blockTexel(ivec4 place, vec2 uv) { return vec2(place.xy) + clamp(uv * float(place.z), vec2(0.5), vec2(float(place.z) - 0.5)); }

// One layer of a block at uv, bilinear.
vec4 sampleBlock(ivec4 place, int store, vec2 uv, int layer) {
  vec2 at = blockTexel(place, uv);
  float l = float(place.w + layer);
#if STORES == 1
  return textureLod(shadowFloat, vec3(at / vec2(textureSize(shadowFloat, 0).xy), l), 0.0);
#elif STORES == 2
  return textureLod(shadowHalf, vec3(at / vec2(textureSize(shadowHalf, 0).xy), l), 0.0);
#elif STORES == 8
  return textureLod(shadowByte, vec3(at / vec2(textureSize(shadowByte, 0).xy), l), 0.0);
#elif STORES == 4
  return textureLod(shadowUnorm, vec3(at / vec2(textureSize(shadowUnorm, 0).xy), l), 0.0);
#else
  if (store == STORE_FLOAT) return textureLod(shadowFloat, vec3(at / vec2(textureSize(shadowFloat, 0).xy), l), 0.0);
  if (store == STORE_HALF) return textureLod(shadowHalf, vec3(at / vec2(textureSize(shadowHalf, 0).xy), l), 0.0);
  if (store == STORE_BYTE) return textureLod(shadowByte, vec3(at / vec2(textureSize(shadowByte, 0).xy), l), 0.0);
  return textureLod(shadowUnorm, vec3(at / vec2(textureSize(shadowUnorm, 0).xy), l), 0.0);
#endif
}

vec4 fetchBlock(ivec4 place, int store, ivec2 texel, int layer) {
  ivec3 p = ivec3(place.xy + clamp(texel, ivec2(0), ivec2(place.z - 1)), place.w + layer);
  // Coefficients are float or half.
  if (store == STORE_FLOAT) return texelFetch(shadowFloat, p, 0);
  return texelFetch(shadowHalf, p, 0);
}

// Metric values and interval weights of a light at uv of a face.
void loadMetric(int light, int face, vec2 uv, out float m[METRIC_FLOATS], out float w[kIntervals]) {
  ivec4 place = lights[light].metric.place;
  ivec2 kind = lights[light].metric.kind.xy;
  place.w += face * kind.y;
#ifdef METRIC_STORE
  const int store = METRIC_STORE;
#else
  int store = kind.x;
#endif
  for (int i = 0; i < METRIC_FLOATS; i += 4) {
    vec4 v = sampleBlock(place, store, uv, min(i / 4, kind.y - 1));
    for (int j = 0; j < 4; ++j) m[i + j] = i < 4 * kind.y ? v[j] : 1.0;
  }
  for (int j = 0; j < kIntervals; ++j) w[j] = 1.0;
#if WEIGHTS
  ivec4 wp = lights[light].weights;
  bool has = (lights[light].solids.z & 1) != 0;
  int layers = (lights[light].items.x + 3) / 4;
  for (int i = 0; i < kIntervals; i += 4) {
    vec4 v = textureLod(shadowByte, vec3(blockTexel(wp, uv) / vec2(textureSize(shadowByte, 0).xy), float(wp.w + face * layers + min(i / 4, layers - 1))), 0.0);
    for (int j = 0; j < 4 && i + j < kIntervals; ++j) w[i + j] = has ? v[j] : 1.0;
  }
#endif
}
