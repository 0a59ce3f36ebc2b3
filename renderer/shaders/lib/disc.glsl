// Soft suns: what arrives comes from everywhere on a disc, evenly as it is seen against the plane across its
// middle; scene::splitDisc has the same in parts. Variant constant DISCS (1: there are some).
#pragma once
#include "lib/light.glsl"
#include "lib/path_random.glsl"

#ifndef DISCS
#define DISCS 0
#endif

bool isDisc(int l) { return DISCS != 0 && lights[l].items.w == LIGHT_SUN && lights[l].emitted.w > 0.0; }

// [1/sr] of discDirection.
float discDensity(int l, vec3 d) {
  vec3 axis = lights[l].towards.xyz, across = cross(axis, d);
  float edge = lights[l].emitted.w, cosine = dot(axis, d);
  bool on = cosine > 0.0 && dot(across, across) <= edge * edge;
  return on ? cosine / (3.14159265358979 * edge * edge) : 0.0;
}

vec3 discDirection(int l, vec2 u) {
  vec3 axis = lights[l].towards.xyz, a, b;
  frameOf(axis, a, b);
  float sine = lights[l].emitted.w * sqrt(u.x), phi = 6.28318530717959 * u.y;
  return normalize(sqrt(max(1.0 - sine * sine, 0.0)) * axis + sine * (cos(phi) * a + sin(phi) * b));
}
