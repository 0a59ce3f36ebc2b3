// How the four metrics of a texel's footprint may be blended: for those who build extinction maps over
// interval metrics.
#pragma once
#include "lib/mixed_bit.glsl"
#include "lib/shadow_blocks.glsl"

// Bits of pairs of texels: the upper and the lower row, the left and the right column.
const int kRows = 3, kColumns = 12;

// Those that may still turn out to match, and are worth it: a row is of no use without the other.
int openPairs(int match, int fail) {
  int both = ((fail & kRows) != 0 ? kRows : 0) | ((fail & kColumns) != 0 ? kColumns : 0);
  return ~(match | both) & (kRows | kColumns);
}

// m, w: the metric of the texel itself at uv.
int footprintBlend(int face, vec2 uv, float texel, float m[METRIC_FLOATS], float w[kIntervals]) {
  float right[METRIC_FLOATS], below[METRIC_FLOATS], diagonal[METRIC_FLOATS], wr[kIntervals], wb[kIntervals],
      wd[kIntervals];
  loadMetric(0, face, uv + vec2(texel, 0.0), right, wr);
  loadMetric(0, face, uv + vec2(0.0, texel), below, wb);
  loadMetric(0, face, uv + vec2(texel), diagonal, wd);
  int match = (intervalsMatch(m, w, right, wr) ? 1 : 0) | (intervalsMatch(below, wb, diagonal, wd) ? 2 : 0) |
              (intervalsMatch(m, w, below, wb) ? 4 : 0) | (intervalsMatch(right, wr, diagonal, wd) ? 8 : 0);
  if ((match & 5) == 5 && intervalsMatch(m, w, diagonal, wd)) return BLEND_WHOLE;
  // A pair that does not match may still lie on one slanted surface: the texel in front of it in its row or
  // column tells, or else the one behind it.
  int fail = (intervalsAlike(m, w, right, wr) ? 0 : 1) | (intervalsAlike(below, wb, diagonal, wd) ? 0 : 2) |
             (intervalsAlike(m, w, below, wb) ? 0 : 4) | (intervalsAlike(right, wr, diagonal, wd) ? 0 : 8);
  fail &= ~match;
  int open = openPairs(match, fail);
  bool backwards = false;
  while (open != 0) {
    int pair = findLSB(open);
    bool column = pair >= 2, second = (pair & 1) == 1;
    float along = backwards ? 2.0 : -1.0, beside = second ? 1.0 : 0.0;
    float next[METRIC_FLOATS], near[METRIC_FLOATS], further[METRIC_FLOATS], wx[kIntervals];
    loadMetric(0, face, uv + texel * (column ? vec2(beside, along) : vec2(along, beside)), next, wx);
    for (int k = 0; k < METRIC_FLOATS; ++k) {
      float first = !second ? m[k] : column ? right[k] : below[k];
      float last = second ? diagonal[k] : column ? below[k] : right[k];
      near[k] = backwards ? last : first, further[k] = backwards ? first : last;
    }
    bool lead = intervalsLead(next, near, further);
    match |= lead ? 1 << pair : 0;
    fail |= !lead && backwards ? 1 << pair : 0;
    backwards = !lead && !backwards;
    open = openPairs(match, fail);
  }
  if (match == (kRows | kColumns)) return BLEND_WHOLE;
  return (match & kRows) == kRows ? BLEND_ROWS : (match & kColumns) == kColumns ? BLEND_COLUMNS : BLEND_NONE;
}
