// A coefficient texel's footprint (itself, right, below, diagonal) is mixed when the intervals of its metrics
// do not match: then neither metrics nor coefficients may be blended across it. Often its two rows or its two
// columns still match within themselves. The map's builder notes what holds in the lowest bits of
// coefficients of the first layer, one each: mixed in the last of the layer's, and with four or more
// coefficients "in pairs" in the third and "pairs are columns" in the second.
#pragma once
#include "shared/records.h"

#define BLEND_WHOLE 0    // all four match
#define BLEND_NONE 1     // each texel on its own
#define BLEND_ROWS 2     // the two texels of a row match
#define BLEND_COLUMNS 3  // the two of a column

int mixedChannel(int coefficients) { return min(coefficients, 4) - 1; }

// Subnormal numbers are avoided, halves and floats: storing or reading one may flush it, bit and all.
float withLowBit(float c, bool on, int store) {
  uint bit = on ? 1u : 0u;
  if (store == STORE_FLOAT) {
    uint f = floatBitsToUint(c);
    if ((f & 0x7F800000u) == 0u) f = (f & 0x80000000u) | 0x00800000u;  // the smallest normal float, 1e-38
    return uintBitsToFloat((f & ~1u) | bit);
  }
  uint h = packHalf2x16(vec2(c, 0.0)) & 0xFFFFu;
  if ((h & 0x7C00u) == 0u) h = (h & 0x8000u) | 0x0400u;  // the smallest normal half, 6e-5
  return unpackHalf2x16((h & ~1u) | bit).x;
}

// `low`: the lowest bits of the first layer as it is stored.
int blendOf(bvec4 low, int coefficients) {
  if (!low[mixedChannel(coefficients)]) return BLEND_WHOLE;
  if (coefficients < 4 || !low.z) return BLEND_NONE;
  return low.y ? BLEND_COLUMNS : BLEND_ROWS;
}

vec4 withBlend(vec4 first, int blend, int coefficients, int store) {
  first[mixedChannel(coefficients)] =
      withLowBit(first[mixedChannel(coefficients)], blend != BLEND_WHOLE, store);
  if (coefficients >= 4) {
    first.z = withLowBit(first.z, blend >= BLEND_ROWS, store);
    first.y = withLowBit(first.y, blend == BLEND_COLUMNS, store);
  }
  return first;
}
