// Bounds of sigma_t along a ray: of each brick of a grid and of each block of 4^3 bricks, remapped, aprons
// included (residency/majorants.h). An exact shape has one everywhere.
#pragma once
#include "lib/volume.glsl"
#include "shared/path.h"

// Texels 2 v and 2 v + 1: where the bounds of volume v's bricks and of its blocks begin; then bits of floats.
layout(binding = UNIT_MAJORANTS) uniform usamplerBuffer majorantTexels;

const float kNudge = 1e-3;      // voxels: how far behind a wall its far side begins
const float kFewEvents = 1.0;   // a block's bound serves where it costs no more events than that

// Up to `until` metres along a ray sigma_t [1/m] (mean of its channels) is at most `most`. Of a grid: in
// bricks lo .. hi.
struct Bound {
  float most, until;
  ivec3 lo, hi;
};

float boundAt(int first, ivec3 cell, ivec3 cells) {
  int i = first + (cell.z * cells.y + cell.y) * cells.x + cell.x;
  return uintBitsToFloat(texelFetch(majorantTexels, i).x);
}

// The t at which a ray at level position q leaves a cell between two corners.
float leaveCell(VolumeRay r, vec3 q, vec3 lo, vec3 hi) {
  vec3 wall = mix(lo, hi, greaterThan(r.d, vec3(0.0)));
  vec3 exits = mix((wall - q) / r.d, vec3(1e30), lessThan(abs(r.d), vec3(1e-20)));
  return max(min(min(exits.x, exits.y), exits.z), 0.0);
}

// Of volume v, on whose finest resident level the ray is, from t on.
Bound boundOf(VolumeRay r, int v, float t) {
  Bound b = Bound(max(r.extinction, 0.0), 1e30, ivec3(0), ivec3(0));
#if SHAPES & SHAPES_GRID
  vec3 speed = abs(r.d);
  float on = kNudge / max(max(max(speed.x, speed.y), speed.z), 1e-30);
  vec3 q = r.o + (t + on) * r.d;
  ivec3 brick = clamp(brickAt(q), ivec3(0), max(r.bricks - 1, ivec3(0))), block = brick >> 2;
  int header = r.analytic ? 0 : 2 * v;
  int first = r.analytic ? 0 : int(texelFetch(majorantTexels, header).x),
      firstBlock = r.analytic ? 0 : int(texelFetch(majorantTexels, header + 1).x);
  ivec3 zero = ivec3(0);
  float ofBrick = boundAt(first, r.analytic ? zero : brick, r.bricks);
  float ofBlock = boundAt(firstBlock, r.analytic ? zero : block, (r.bricks + 3) >> 2);
  float brickEnd = leaveCell(r, q, vec3(brick) * kBrick, vec3(brick + 1) * kBrick);
  float blockEnd = leaveCell(r, q, vec3(block) * 4.0 * kBrick, vec3(block + 1) * 4.0 * kBrick);
  bool coarse = ofBlock * blockEnd <= kFewEvents;
  if (!r.analytic) {
    b.most = coarse ? ofBlock : ofBrick;
    b.until = t + on + (coarse ? blockEnd : brickEnd);
    b.lo = coarse ? 4 * block : brick;
    b.hi = coarse ? min(4 * block + 3, r.bricks - 1) : brick;
  }
#endif
  return b;
}

// What is at t, in one of the bound's bricks: so never above it, whatever is behind its walls.
BrickPlace placeWithin(Bound b, VolumeRay r, float t) {
  BrickPlace at;
  at.t = t, at.q = r.o + t * r.d;
#if SHAPES & SHAPES_GRID
  at.brick = clamp(brickAt(at.q), b.lo, b.hi);
  at.page = pageOf(r, at.brick);
#endif
  return at;
}
