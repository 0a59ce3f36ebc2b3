// Layers of shadow maps in the store. STORES: bit per STORE_* kind that coefficients and metrics of the
// variant use. METRIC_STORE, where all mapped lights agree in their metric: its kind; METRIC_FLOATS is then
// no more than it has.
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
// The texels of shadowHalf as they are stored.
layout(binding = UNIT_SHADOW_HALF_BITS) uniform usampler2DArray shadowHalfBits;

// Texture coordinates of a position in texels of a block, [0, edge]^2, its bilinear footprint within the
// block. The arrays are square.
vec3 storeCoordinates(ivec4 place, vec2 at, int layer, ivec3 size) {
  vec2 texel = vec2(place.xy) + clamp(at, vec2(0.5), vec2(float(place.z) - 0.5));
  return vec3(texel * (1.0 / float(size.x)), float(place.w + layer));
}

// One layer of a block at `at` [texels of the block], bilinear.
vec4 sampleBlock(ivec4 place, int store, vec2 at, int layer) {
#if STORES == (1 << STORE_FLOAT)
  return textureLod(shadowFloat, storeCoordinates(place, at, layer, textureSize(shadowFloat, 0)), 0.0);
#elif STORES == (1 << STORE_HALF)
  return textureLod(shadowHalf, storeCoordinates(place, at, layer, textureSize(shadowHalf, 0)), 0.0);
#elif STORES == (1 << STORE_BYTE)
  return textureLod(shadowByte, storeCoordinates(place, at, layer, textureSize(shadowByte, 0)), 0.0);
#elif STORES == (1 << STORE_UNORM)
  return textureLod(shadowUnorm, storeCoordinates(place, at, layer, textureSize(shadowUnorm, 0)), 0.0);
#else
  if (store == STORE_FLOAT)
    return textureLod(shadowFloat, storeCoordinates(place, at, layer, textureSize(shadowFloat, 0)), 0.0);
  if (store == STORE_HALF)
    return textureLod(shadowHalf, storeCoordinates(place, at, layer, textureSize(shadowHalf, 0)), 0.0);
  if (store == STORE_BYTE)
    return textureLod(shadowByte, storeCoordinates(place, at, layer, textureSize(shadowByte, 0)), 0.0);
  return textureLod(shadowUnorm, storeCoordinates(place, at, layer, textureSize(shadowUnorm, 0)), 0.0);
#endif
}

// The lowest bit of each channel of a texel of coefficients (half or float) as it is stored; `texel`: whole
// numbers, clamped to the block. Half texels are read by the nearest filter: for a texelFetch llvmpipe works
// out a level of detail lane by lane.
bvec4 lowBits(ivec4 place, int store, vec2 texel, int layer) {
#if STORES & (1 << STORE_FLOAT)
  if (store == STORE_FLOAT) {
    ivec3 p = ivec3(vec2(place.xy) + clamp(texel, vec2(0.0), vec2(float(place.z - 1))), place.w + layer);
    return notEqual(floatBitsToUint(texelFetch(shadowFloat, p, 0)) & 1u, uvec4(0u));
  }
#endif
#if STORES & (1 << STORE_HALF)
  uvec2 halves =
      textureLod(shadowHalfBits, storeCoordinates(place, texel + 0.5, layer, textureSize(shadowHalf, 0)), 0.0)
          .xy;
  return notEqual(uvec4(halves.x, halves.x >> 16, halves.y, halves.y >> 16) & 1u, uvec4(0u));
#else
  return bvec4(false);
#endif
}

// Metric values and interval weights (as stored: fourth roots) of a light at `at` [texels of the metric's
// block] of a face.
void loadMetricAt(int light, int face, vec2 at, out float m[METRIC_FLOATS], out float w[kIntervals]) {
  ivec4 place = lights[light].metric.place;
#ifdef METRIC_STORE
  const int store = METRIC_STORE, layers = METRIC_FLOATS / 4;
#else
  int store = lights[light].metric.kind.x, layers = lights[light].metric.kind.y;
#endif
  place.w += face * layers;
  for (int i = 0; i < METRIC_FLOATS; i += 4) {
    vec4 v = sampleBlock(place, store, at, min(i / 4, layers - 1));
    for (int j = 0; j < 4; ++j) m[i + j] = i < 4 * layers ? v[j] : 1.0;
  }
  for (int j = 0; j < kIntervals; ++j) w[j] = 1.0;
#if WEIGHTS
  ivec4 weightsPlace = lights[light].weights;
  bool has = (lights[light].solids.z & LIGHT_HAS_WEIGHTS) != 0;
  int weightLayers = (lights[light].items.x + 3) / 4;
  weightsPlace.w += face * weightLayers;
  for (int i = 0; i < kIntervals; i += 4) {
    vec4 v = textureLod(
        shadowByte,
        storeCoordinates(weightsPlace, at, min(i / 4, weightLayers - 1), textureSize(shadowByte, 0)), 0.0);
    for (int j = 0; j < 4 && i + j < kIntervals; ++j) w[i + j] = has ? (v[j] * v[j]) * (v[j] * v[j]) : 1.0;
  }
#endif
}

// The same at map coordinates uv in [0,1]^2.
void loadMetric(int light, int face, vec2 uv, out float m[METRIC_FLOATS], out float w[kIntervals]) {
  loadMetricAt(light, face, uv * float(lights[light].metric.place.z), m, w);
}
