// What is scattered within peaks of phase functions alone. Twin: scene/peak.h.
#pragma once
#include "lib/scene_table.glsl"
#include "shared/scatter.h"

float peakEntry(int first, int i, int j) {
  return uintBitsToFloat(sceneBits(first + (j * PEAK_ANGLES + i) / 4)[i & 3]);
}

// Of the table that begins at that texel, in direction `cosine`, through peaks of `depth` [1/sr].
float scatteredPeak(int first, float cosine, float depth) {
  float angle = sqrt(sqrt(clamp(0.5 - 0.5 * cosine, 0.0, 1.0))) * float(PEAK_ANGLES - 1);
  float s = depth / (depth + PEAK_DEPTH) * float(PEAK_DEPTHS);
  int i = min(int(angle), PEAK_ANGLES - 2), j = min(int(s), PEAK_DEPTHS - 2);
  vec2 part = vec2(angle - float(i), min(s - float(j), 1.0));
  vec2 near = vec2(peakEntry(first, i, j), peakEntry(first, i + 1, j));
  vec2 far = vec2(peakEntry(first, i, j + 1), peakEntry(first, i + 1, j + 1));
  vec2 between = mix(near, far, part.y);
  return mix(between.x, between.y, part.x);
}
