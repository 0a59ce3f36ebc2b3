// Light from everywhere: radiance by direction, constant in each texel of a map, and directions chosen by it
// (view/environment_table.h). Variant constant ENVIRONMENT (1: there is one).
#pragma once
#include "shared/path.h"

#ifndef ENVIRONMENT
#define ENVIRONMENT 0
#endif

#if ENVIRONMENT
// height texels of rows: x sum of the chances of rows up to and with this one, y solid angle of each of its
// texels [sr]; then texels row by row: rgb radiance, w sum of the chances in its row up to and with it.
layout(binding = UNIT_ENVIRONMENT) uniform samplerBuffer environmentTexels;
uniform ivec2 environmentSize;
uniform float environmentTurn;   // azimuth of the map's middle, in turns
uniform float environmentPower;  // luminance of its radiance, over all directions

const float kTurn = 6.28318530717959;

ivec2 environmentTexel(vec3 d) {
  float u = fract(0.5 - (atan(d.x, d.z) / kTurn - environmentTurn));
  float v = acos(clamp(d.y, -1.0, 1.0)) * 2.0 / kTurn;
  return clamp(ivec2(vec2(u, v) * vec2(environmentSize)), ivec2(0), environmentSize - 1);
}
vec4 environmentRow(int y) { return texelFetch(environmentTexels, y); }
vec4 environmentAt(ivec2 at) {
  return texelFetch(environmentTexels, environmentSize.y + at.y * environmentSize.x + at.x);
}

// [1/sr] at which sampleEnvironment gives what is in that texel.
float environmentDensity(ivec2 at) {
  vec4 row = environmentRow(at.y);
  float chance = row.x - (at.y > 0 ? environmentRow(at.y - 1).x : 0.0);
  float within = environmentAt(at).w - (at.x > 0 ? environmentAt(at - ivec2(1, 0)).w : 0.0);
  return chance > 0.0 ? chance * within / row.y : 0.0;
}

// A direction and its texel.
vec3 sampleEnvironment(vec3 u, out ivec2 at) {
  int lo = 0, hi = environmentSize.y - 1;
  do {
    int middle = (lo + hi) >> 1;
    bool behind = environmentRow(middle).x <= u.x;
    lo = behind && lo < hi ? middle + 1 : lo;
    hi = behind ? hi : middle;
  } while (lo < hi);
  at.y = lo;
  float below = at.y > 0 ? environmentRow(at.y - 1).x : 0.0, chance = environmentRow(at.y).x - below;
  float inRow = clamp((u.x - below) / max(chance, 1e-30), 0.0, 0.999999);
  lo = 0, hi = environmentSize.x - 1;
  do {
    int middle = (lo + hi) >> 1;
    bool behind = environmentAt(ivec2(middle, at.y)).w <= u.y;
    lo = behind && lo < hi ? middle + 1 : lo;
    hi = behind ? hi : middle;
  } while (lo < hi);
  at.x = lo;
  float left = at.x > 0 ? environmentAt(at - ivec2(1, 0)).w : 0.0, width = environmentAt(at).w - left;
  float inTexel = clamp((u.y - left) / max(width, 1e-30), 0.0, 1.0);
  // Evenly over the texel's solid angle: in azimuth and in the height of the direction.
  float top = cos(0.5 * kTurn * float(at.y) / float(environmentSize.y)),
        bottom = cos(0.5 * kTurn * float(at.y + 1) / float(environmentSize.y));
  float height = mix(top, bottom, inRow), flat_ = sqrt(max(0.0, 1.0 - height * height));
  float azimuth = kTurn * (0.5 - (float(at.x) + inTexel) / float(environmentSize.x) + environmentTurn);
  return vec3(flat_ * sin(azimuth), height, flat_ * cos(azimuth));
}
#endif
