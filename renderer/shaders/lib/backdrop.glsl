// What a camera sees of environments where nothing else is: a map of radiance, filtered
// (view/environment_table.h). Variant constant BACKDROP (1: there is one).
#pragma once
#include "shared/path.h"
#if BACKDROP
layout(binding = UNIT_BACKDROP) uniform sampler2D backdropMap;
uniform float backdropTurn;  // azimuth of the map's middle, in turns
uniform vec3 backdropScale;

vec3 backdrop(vec3 d) {
  const float kTurns = 1.0 / 6.28318530717959;
  float u = 0.5 - atan(d.x, d.z) * kTurns + backdropTurn, v = acos(clamp(d.y, -1.0, 1.0)) * 2.0 * kTurns;
  return backdropScale * textureLod(backdropMap, vec2(u, v), 0.0).rgb;
}
#endif
