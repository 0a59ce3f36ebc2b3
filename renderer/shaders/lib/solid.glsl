// Opaque solids: where rays meet them and whether they stand between a point and a light. Twin:
// scene/solid.h. Variant constant BLOCKERS: 0 where no light of the scene is blocked by any.
#pragma once
#include "shared/records.h"
#include "lib/intersect.glsl"
#include "lib/light.glsl"
#include "lib/scene_table.glsl"

#ifndef BLOCKERS
#define BLOCKERS 1
#endif

const float kNoHit = 1e30;

vec4 solidRow(int s, int row) { return sceneFloats(sceneSections.w + s * SOLID_ROWS + row); }
vec3 solidAlbedo(int s) { return solidRow(s, 8).rgb; }

// The first t > tMin at which o + t d meets solid s, else kNoHit; `normal` (unit, world, against the ray)
// holds for a hit only.
float hitSolid(int s, vec3 o, vec3 d, float tMin, out vec3 normal) {
  mat4 m = mat4(solidRow(s, 0), solidRow(s, 1), solidRow(s, 2), solidRow(s, 3));
  vec3 lo = (m * vec4(o, 1.0)).xyz, ld = (m * vec4(d, 0.0)).xyz;
  bool plane = int(solidRow(s, 8).w) == SOLID_PLANE;
  vec2 hit = intersectBox(lo, ld, vec3(-0.5), vec3(0.5));
  float t = hit.x > tMin ? hit.x : hit.y;
  bool met = hit.x < hit.y;
  float across = ld.y == 0.0 ? kNoHit : -lo.y / ld.y;
  t = plane ? across : t;
  vec3 p = abs(lo + t * ld);
  met = plane ? p.x <= 0.5 && p.z <= 0.5 && ld.y != 0.0 : met;
  int axis = plane ? 1 : p.x > p.y && p.x > p.z ? 0 : p.y > p.z ? 1 : 2;
  // Normals go with the inverse transpose: its columns are the rows of localFromWorld.
  normal = normalize(axis == 0   ? vec3(m[0].x, m[1].x, m[2].x)
                     : axis == 1 ? vec3(m[0].y, m[1].y, m[2].y)
                                 : vec3(m[0].z, m[1].z, m[2].z));
  normal = dot(normal, d) > 0.0 ? -normal : normal;
  return met && t > tMin ? t : kNoHit;
}

// The nearest of the first `count` (at least one) solids along a ray, and its distance; kNoHit if there is
// none.
float nearestSolid(int count, vec3 o, vec3 d, out int solid, out vec3 normal) {
  float nearest = kNoHit;
  solid = 0;
  normal = -d;
  int s = 0;
  do {
    vec3 n;
    float t = hitSolid(s, o, d, 0.0, n);
    bool nearer = t < nearest;
    nearest = nearer ? t : nearest;
    solid = nearer ? s : solid;
    normal = nearer ? n : normal;
    ++s;
  } while (s < count);
  return nearest;
}

// 1 where nothing of what blocks the light stands within `distance` from p towards it, else 0.
float solidVisibility(int light, vec3 p, vec3 towards, float distance) {
  float visible = 1.0;
#if BLOCKERS
  ivec2 range = lights[light].solids.xy;
  vec3 n;
  for (int s = range.x; s < range.x + range.y; ++s)
    visible = hitSolid(s, p, towards, 0.0, n) < distance ? 0.0 : visible;
#endif
  return visible;
}

// How far off a surface point p of solid s, hit at distance t, rays have to start to clear it: some tens of
// roundings of what the hit was computed from.
float solidClearance(int s, vec3 p, vec3 normal, float t) {
  float along = 0.0;  // extent of the solid along its normal, and its centre's place
  for (int row = 4; row < 8; ++row) along += abs(dot(normal, solidRow(s, row).xyz));
  vec3 a = abs(p);
  return 2e-6 * (t + max(max(a.x, a.y), a.z) + along);
}
