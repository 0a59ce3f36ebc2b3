// A coefficient texel's footprint (itself, right, below, diagonal) is mixed when the intervals of its metrics do not match: then
// neither metrics nor coefficients may be blended. The map's builder notes it in the lowest bit of one coefficient of the first layer.
#pragma once
#include "shared/records.h"

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
