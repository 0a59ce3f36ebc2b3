// How the four metrics of a texel's footprint may be blended: for those who build extinction maps over
// interval metrics.
#pragma once
#include "lib/mixed_bit.glsl"
#include "lib/shadow_blocks.glsl"

// m, w: the metric of the texel itself at uv.
int footprintBlend(int face, vec2 uv, float texel, float m[METRIC_FLOATS], float w[kIntervals]) {
  float right[METRIC_FLOATS], below[METRIC_FLOATS], diagonal[METRIC_FLOATS], wr[kIntervals], wb[kIntervals],
      wd[kIntervals];
  loadMetric(0, face, uv + vec2(texel, 0.0), right, wr);
  loadMetric(0, face, uv + vec2(0.0, texel), below, wb);
  loadMetric(0, face, uv + vec2(texel), diagonal, wd);
  bool top = intervalsMatch(m, w, right, wr), left = intervalsMatch(m, w, below, wb);
  bool bottom = intervalsMatch(below, wb, diagonal, wd), far = intervalsMatch(right, wr, diagonal, wd);
  if (top && left && intervalsMatch(m, w, diagonal, wd)) return BLEND_WHOLE;
  return top && bottom ? BLEND_ROWS : left && far ? BLEND_COLUMNS : BLEND_NONE;
}
