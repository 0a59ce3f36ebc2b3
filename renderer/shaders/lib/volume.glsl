// Placed volumes and their voxels in the brick atlas.
#pragma once
#include "shared/bindings.h"
#include "shared/records.h"
#include "lib/intersect.glsl"

layout(std430, binding = BIND_VOLUMES) readonly buffer VolumeBuffer { VolumeRecord volumes[]; };
layout(std430, binding = BIND_LEVELS) readonly buffer LevelBuffer { LevelRecord levels[]; };
layout(std430, binding = BIND_PAGES) readonly buffer PageBuffer { uvec4 pages[]; };
layout(binding = UNIT_ATLAS) uniform sampler3D brickAtlas;
uniform ivec4 atlasSlots;  // xyz: slots along each axis
const float kBrick = 16.0, kStored = 18.0;

// The line o + t d in a volume's local space.
struct LocalRay {
  vec3 o, d;
};

LocalRay localRay(int v, vec3 o, vec3 d) {
  mat4 m = volumes[v].localFromWorld;
  return LocalRay((m * vec4(o, 1.0)).xyz, (m * vec4(d, 0.0)).xyz);
}

vec2 intersectVolume(int v, LocalRay r) {
  if (volumes[v].shape.x == SHAPE_BALL) return intersectBall(r.o, r.d);
  return intersectBox(r.o, r.d, volumes[v].boundsMin.xyz, volumes[v].boundsMax.xyz);
}

uvec4 pageAt(LevelRecord level, ivec3 b) {
  if (any(lessThan(b, ivec3(0))) || any(greaterThanEqual(b, level.bricks.xyz))) return uvec4(PAGE_CONSTANT, 0u, 0u, 0u);
  return pages[level.bricks.w + (b.z * level.bricks.y + b.y) * level.bricks.x + b.x];
}

// Density at q in the level's own voxel coordinates inside brick b.
float sampleBrick(uvec4 page, vec3 q, ivec3 b) {
  float offset = uintBitsToFloat(page.y);
  if (page.x == PAGE_CONSTANT) return offset;
  int s = int(page.x);
  ivec3 slot = ivec3(s % atlasSlots.x, (s / atlasSlots.x) % atlasSlots.y, s / (atlasSlots.x * atlasSlots.y));
  vec3 texel = vec3(slot) * kStored + (q - vec3(b) * kBrick) + 1.5;  // apron of one, texel centres at one half
  return offset + uintBitsToFloat(page.z) * textureLod(brickAtlas, texel / (vec3(atlasSlots.xyz) * kStored), 0.0).r;
}

// Level coordinates of a level-0 position (both relative to the lattice).
vec3 levelPosition(vec3 p, int level) { return (p + 0.5) * exp2(-float(level)) - 0.5; }

// Density of a grid at local position p; `level` is clamped to what is resident.
float sampleGrid(int v, vec3 p, int level) {
  level = clamp(level, volumes[v].shape.w, volumes[v].shape.z - 1);
  LevelRecord record = levels[volumes[v].shape.y + level];
  vec3 q = levelPosition(p, level);
  ivec3 b = ivec3(floor(q / kBrick));
  return sampleBrick(pageAt(record, b), q, b);
}

// Extinction sigma_t [1/m] on a local ray at t. `skipTo`: the next t that can be non-zero, > t where the brick here is empty.
float sigmaOnRay(int v, LocalRay r, float t, int level, out float skipTo) {
  skipTo = t;
  float extinction = volumes[v].boundsMin.w;
  if (volumes[v].shape.x != SHAPE_GRID) return extinction * volumes[v].boundsMax.w;
  level = clamp(level, volumes[v].shape.w, volumes[v].shape.z - 1);
  LevelRecord record = levels[volumes[v].shape.y + level];
  vec3 q = levelPosition(r.o + t * r.d, level);
  ivec3 b = ivec3(floor(q / kBrick));
  uvec4 page = pageAt(record, b);
  if (page.x == PAGE_CONSTANT && page.y == 0u) {
    float scale = exp2(-float(level));
    // Climb while the coarser brick is empty too: its positions are a superset of ours.
    for (int up = level + 1; up < min(level + 3, volumes[v].shape.z); ++up) {
      LevelRecord coarse = levels[volumes[v].shape.y + up];
      vec3 qc = levelPosition(r.o + t * r.d, up);
      ivec3 bc = ivec3(floor(qc / kBrick));
      uvec4 pc = pageAt(coarse, bc);
      if (pc.x != PAGE_CONSTANT || pc.y != 0u) break;
      q = qc, b = bc, scale *= 0.5;
    }
    vec3 d = r.d * scale;
    vec3 wall = vec3(b) * kBrick + mix(vec3(0.0), vec3(kBrick), greaterThan(d, vec3(0.0)));
    vec3 exits = mix((wall - q) / d, vec3(1e30), lessThan(abs(d), vec3(1e-20)));
    skipTo = t + max(min(min(exits.x, exits.y), exits.z), 0.0);
    return 0.0;
  }
  return max(0.0, extinction * sampleBrick(page, q, b));
}

// The mip whose voxels match a footprint [m].
int levelFor(int v, float footprint) {
  if (volumes[v].shape.x != SHAPE_GRID) return 0;
  return clamp(int(floor(log2(max(footprint / volumes[v].detail.x, 1.0)))) + volumes[v].shape.w, 0, volumes[v].shape.z - 1);
}

// March step [m] that resolves volume v at a footprint [m].
float stepFor(int v, float footprint) { return max(volumes[v].detail.x, volumes[v].shape.x == SHAPE_GRID ? footprint : 0.0); }

// Optical depth of volume v from p along the unit direction d, midpoint march, steps of `scale` details.
float opticalDepth(int v, vec3 p, vec3 d, float scale) {
  LocalRay r = localRay(v, p, d);
  vec2 hit = intersectVolume(v, r);
  float t0 = max(hit.x, 0.0), t1 = hit.y;
  if (t0 >= t1) return 0.0;
  if (volumes[v].shape.x != SHAPE_GRID) return volumes[v].boundsMin.w * volumes[v].boundsMax.w * (t1 - t0);
  int n = int(clamp(ceil((t1 - t0) / (volumes[v].detail.x * scale)), 1.0, 16384.0));
  float ds = (t1 - t0) / float(n), sum = 0.0;
  for (int i = 0; i < n;) {
    float skipTo;
    float t = t0 + (float(i) + 0.5) * ds;
    sum += sigmaOnRay(v, r, t, 0, skipTo);
    i = max(i + 1, int(min((skipTo - t0) / ds + 0.5, 1e6)));
  }
  return sum * ds;
}
