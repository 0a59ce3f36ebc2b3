// Placed volumes and their voxels in the brick atlas.
// llvmpipe runs both sides of every branch and tests a loop's end only after its body, so hot code here is
// free of branches, loops are do-while, and what the scene does not hold is left out by the variant: SHAPES
// has the bits SHAPES_* of what there is.
#pragma once
#include "shared/bindings.h"
#include "shared/records.h"
#include "lib/intersect.glsl"
#include "lib/resume.glsl"
#include "lib/scene_table.glsl"

#ifndef SHAPES
#define SHAPES (SHAPES_GRID | SHAPES_EXACT)
#endif

layout(binding = UNIT_PAGES) uniform usamplerBuffer pageTexels;
layout(binding = UNIT_ATLAS) uniform sampler3D brickAtlas;
uniform vec3 atlasTexel;  // 1 / size of the atlas
const float kBrick = 16.0, kStored = 18.0;

// VolumeRecord v begins at texel v * VOLUME_ROWS of the table.
vec4 volumeRow(int v, int row) { return sceneFloats(v * VOLUME_ROWS + row); }
mat4 localFromWorld(int v) {
  return mat4(volumeRow(v, 0), volumeRow(v, 1), volumeRow(v, 2), volumeRow(v, 3));
}
mat4 worldFromLocal(int v) {
  return mat4(volumeRow(v, 4), volumeRow(v, 5), volumeRow(v, 6), volumeRow(v, 7));
}
vec4 boundsMin(int v) { return volumeRow(v, 8); }
vec4 boundsMax(int v) { return volumeRow(v, 9); }
vec4 albedoOf(int v) { return volumeRow(v, 10); }
// g and alpha of a volume's lobes.
vec4 lobesOf(int v) { return volumeRow(v, 14); }
vec3 tintOf(int v) { return volumeRow(v, 15).rgb; }  // of the extinction; its mean is 1
// The share of its phase function that goes straight on, and the mean cosine of the rest.
vec2 scaledPhaseOf(int v) { return volumeRow(v, 11).zw; }
float detailOf(int v) { return volumeRow(v, 11).x; }
ivec4 shapeOf(int v) { return ivec4(sceneBits(v * VOLUME_ROWS + 12)); }
ivec4 levelRecord(ivec4 shape, int level) { return ivec4(sceneBits(shape.y + level)); }

// A line through one mip level of a volume, everything a sample needs in registers. Its places o + t d count
// from `anchor` metres down the line, next to where it enters: t is small there, and a chord is as exact far
// away as near by.
struct VolumeRay {
  vec3 o, d;         // level voxel coordinates (local space for an analytic shape)
  float anchor;
  ivec3 bricks;      // lattice of the level; 1 1 1 for an analytic shape
  int pages;         // its first page
  float extinction;  // [1/m] per unit density; of an analytic shape: its sigma_t; < 0: it only emits
  bool analytic;
#if SHAPES & SHAPES_REMAPPED
  vec4 remap;  // of the record
#endif
};

// A line that meets nothing.
VolumeRay noRay() {
  VolumeRay r;
  r.o = vec3(0.0), r.d = vec3(0.0), r.anchor = 0.0;
  r.bricks = ivec3(0), r.pages = 0, r.extinction = 0.0, r.analytic = true;
#if SHAPES & SHAPES_REMAPPED
  r.remap = vec4(0.0);
#endif
  return r;
}

#if SHAPES & SHAPES_REMAPPED
// What a density of the voxels becomes (w), and the factor of the albedo that goes with it.
vec4 remapped(vec4 remap, float density) {
  float place = clamp(density * remap.y + remap.z, 0.0, float(REMAP_ENTRIES - 1));
  int i = min(int(place), REMAP_ENTRIES - 2), texel = max(int(remap.x), 0) + i;
  vec4 entry = mix(sceneFloats(texel), sceneFloats(texel + 1), place - float(i));
  return remap.x < 0.0 ? vec4(vec3(1.0), density) : entry;
}
#endif

// A coarse voxel stands for what is in it as long as it is thin: up to this optical depth, were it as dense
// as the densest. Light falls off exponentially, so that the mean extinction of a thick one lets too little
// pass.
const float kThinVoxel = 0.1;

// What of a footprint [m] volume v may be averaged over.
float resolvable(int v, float footprint) {
  vec4 detail = volumeRow(v, 11);  // x: finest [m], y: shortest mean free path [m]
  return clamp(footprint, detail.x, max(kThinVoxel * detail.y, detail.x));
}

// The mip whose voxels match a footprint [m]. A hair more than a power of two is one, whatever the rounding.
int levelFor(int v, float footprint) {
  ivec4 shape = shapeOf(v);
  int octave = (floatBitsToInt(1.00001 * resolvable(v, footprint) / detailOf(v)) >> 23) - 127;
  int level = clamp(octave + shape.w, shape.w, max(shape.z - 1, shape.w));
  return shape.x == SHAPE_GRID ? level : 0;
}

// March step [m] that resolves volume v at a footprint [m].
float stepFor(int v, float footprint) {
  return shapeOf(v).x == SHAPE_GRID ? resolvable(v, footprint) : detailOf(v);
}

// A voxel [m] of the level that goes with it.
float voxelOf(int v, int level) { return detailOf(v) * exp2(float(level - shapeOf(v).w)); }

vec2 intersectShape(ivec4 shape, vec3 o, vec3 d, vec3 lo, vec3 hi) {
  vec2 hit = intersectBox(o, d, lo, hi);
#if SHAPES & SHAPES_EXACT
  if (shape.x == SHAPE_BALL) hit = intersectBall(o, d);
#endif
  return hit;
}

// The part (t0, t1) of the line lo + t ld of its local space inside volume v, counted from r.anchor, and the
// line ready for sampling at a mip level. The anchor is at or behind lo.
vec2 enterLocal(int v, vec3 lo, vec3 ld, int level, out VolumeRay r) {
  vec4 boxMin = boundsMin(v), boxMax = boundsMax(v);
  ivec4 shape = shapeOf(v);
  r.analytic = shape.x != SHAPE_GRID;
  r.extinction = boxMin.w * (r.analytic ? boxMax.w : 1.0);
#if SHAPES & SHAPES_GRID
  level = clamp(level, shape.w, max(shape.z - 1, 0));
  // A coarse voxel reaches further out than the ones it is the mean of, of which the outermost are zeros. The
  // finest end where the grid says, which may be between two.
  float s = exp2(-float(level)), edge = exp2(float(level));
  if (!r.analytic && level > 0) {
    boxMin.xyz = (floor((boxMin.xyz + 1.0) * s) - 0.5) * edge - 0.5;
    boxMax.xyz = (floor((boxMax.xyz - 1.0) * s) + 1.5) * edge - 0.5;
  }
#endif
  // Met twice: from o, which may be far, and from the entry found so.
  vec2 rough = intersectShape(shape, lo, ld, boxMin.xyz, boxMax.xyz);
  r.anchor = rough.x < rough.y ? max(rough.x, 0.0) : 0.0;
  lo += r.anchor * ld;
  vec2 hit = intersectShape(shape, lo, ld, boxMin.xyz, boxMax.xyz);
  r.o = lo, r.d = ld;
  r.bricks = ivec3(1);
  r.pages = 0;
#if SHAPES & SHAPES_REMAPPED
  r.remap = volumeRow(v, 13);
#endif
#if SHAPES & SHAPES_GRID
  ivec4 record = levelRecord(shape, level);
  // A level-0 position p is (p + 0.5) / 2^level - 0.5 on the level.
  if (!r.analytic) {
    r.o = (lo + 0.5) * s - 0.5;
    r.d = ld * s;
    r.bricks = record.xyz;
    r.pages = record.w;
  }
#endif
  return hit;
}

vec2 enterVolume(int v, vec3 o, vec3 d, int level, out VolumeRay r) {
  mat4 m = localFromWorld(v);
  return enterLocal(v, (m * vec4(o, 1.0)).xyz, (m * vec4(d, 0.0)).xyz, level, r);
}

// Where t is on a line, in the local space of volume v, at whose level the line is.
vec3 localAt(int v, VolumeRay r, int level, float t) {
  vec3 q = r.o + t * r.d;
#if SHAPES & SHAPES_GRID
  ivec4 shape = shapeOf(v);
  level = clamp(level, shape.w, max(shape.z - 1, 0));
  if (!r.analytic) q = (q + 0.5) * exp2(float(level)) - 0.5;
#endif
  return q;
}

// A place, and, where it is in a volume, that volume (else -1) and the place in its local space: exact also
// where what is dense changes within less than a float can tell so far from the pass's origin.
struct Place {
  vec3 p, local;
  int volume;
};
Place placeAt(vec3 p) { return Place(p, vec3(0.0), -1); }

// The part of the line inside it, from o; only as exact as that far away.
vec2 extentOfVolume(int v, vec3 o, vec3 d) {
  VolumeRay r;
  vec2 hit = enterVolume(v, o, d, 0, r);
  return hit + r.anchor;
}

// The same line, its places counted from t.
VolumeRay startingAt(VolumeRay r, float t) {
  r.o += t * r.d;
  r.anchor += t;
  return r;
}

// The brick that answers for level position q. Positions in (-1, 0) exist on coarser levels (a coarse voxel's
// centre lies half a voxel in): the first brick's near apron holds what they need.
ivec3 brickAt(vec3 q) { return ivec3(floor(mix(q, max(q, vec3(0.0)), greaterThan(q, vec3(-1.0))) / kBrick)); }

uvec4 pageOf(VolumeRay r, ivec3 b) {
  bool inside = all(greaterThanEqual(b, ivec3(0))) && all(lessThan(b, r.bricks)) && !r.analytic;
  uvec4 page = texelFetch(pageTexels, inside ? r.pages + (b.z * r.bricks.y + b.y) * r.bricks.x + b.x : 0);
  return inside ? page : uvec4(PAGE_CONSTANT, 0u, 0u, 0u);
}

// Density at level position q in brick b: constant bricks have scale 0 and any slot.
float sampleBrick(uvec4 page, vec3 q, ivec3 b) {
  bool constant = page.x == PAGE_CONSTANT;
  uvec3 slot = (uvec3(page.x) >> uvec3(0u, 10u, 20u)) & 1023u;
  // An apron of one, texel centres at one half.
  vec3 texel = vec3(slot) * kStored + (q - vec3(b) * kBrick) + 1.5;
  float value = textureLod(brickAtlas, texel * atlasTexel, 0.0).r;
  return uintBitsToFloat(page.y) + (constant ? 0.0 : uintBitsToFloat(page.z) * value);
}

// Density of a grid at level-0 position p, for those who sample points.
float sampleGrid(int v, vec3 p, int level) {
  ivec4 shape = shapeOf(v);
  level = clamp(level, shape.w, shape.z - 1);
  ivec4 record = levelRecord(shape, level);
  VolumeRay r;
  r.o = (p + 0.5) * exp2(-float(level)) - 0.5;
  r.bricks = record.xyz;
  r.pages = record.w;
  r.analytic = false;
  ivec3 b = brickAt(r.o);
  float density = sampleBrick(pageOf(r, b), r.o, b);
#if SHAPES & SHAPES_REMAPPED
  density = remapped(volumeRow(v, 13), density).w;
#endif
  return density;
}

bool emptyPage(VolumeRay r, uvec4 page) {
#if SHAPES & SHAPES_REMAPPED
  return uintBitsToFloat(page.w) <= r.remap.w;
#else
  return page.x == PAGE_CONSTANT && page.y == 0u;
#endif
}

// What is at t of a line: the place, its brick and that one's page.
struct BrickPlace {
  float t;
  vec3 q;
  ivec3 brick;
  uvec4 page;
};

BrickPlace brickPlace(VolumeRay r, float t) {
  BrickPlace at;
  at.t = t, at.q = r.o + t * r.d;
#if SHAPES & SHAPES_GRID
  at.brick = brickAt(at.q);
  at.page = pageOf(r, at.brick);
#endif
  return at;
}

// The t at which the ray leaves the brick.
float leaveBrick(VolumeRay r, BrickPlace at) {
  vec3 wall = (vec3(at.brick) + vec3(greaterThan(r.d, vec3(0.0)))) * kBrick;
  vec3 exits = mix((wall - at.q) / r.d, vec3(1e30), lessThan(abs(r.d), vec3(1e-20)));
  return at.t + max(min(min(exits.x, exits.y), exits.z), 0.0);
}

// Where the brick is empty: the t at which the ray leaves it. Elsewhere where it is.
float emptyUntil(VolumeRay r, BrickPlace at) {
#if SHAPES & SHAPES_GRID
  return !r.analytic && emptyPage(r, at.page) ? leaveBrick(r, at) : at.t;
#else
  return at.t;
#endif
}
float emptyUntil(VolumeRay r, float t) { return emptyUntil(r, brickPlace(r, t)); }

// There: sigma_t [1/m] (w) and the factor of the albedo, or of what is emitted.
vec4 mediumAt(VolumeRay r, BrickPlace at) {
#if SHAPES & SHAPES_GRID
  vec4 here = vec4(vec3(1.0), sampleBrick(at.page, at.q, at.brick));
#if SHAPES & SHAPES_REMAPPED
  here = remapped(r.remap, here.w);
#endif
  return r.analytic ? vec4(vec3(1.0), max(r.extinction, 0.0))
                    : vec4(here.rgb, max(r.extinction * here.w, 0.0));
#else
  return vec4(vec3(1.0), max(r.extinction, 0.0));
#endif
}
vec4 mediumAt(VolumeRay r, float t) { return mediumAt(r, brickPlace(r, t)); }

// sigma_t [1/m] at t.
float sigmaAt(VolumeRay r, float t) { return mediumAt(r, t).w; }

// The first of the steps t0 + (i + offset) ds at or behind t, but not before i.
int stepAtOrBehind(int i, float t, float t0, float offset, float ds) {
  return max(i, int(min(ceil((t - t0) / ds - offset - 1e-3), 1e6)));
}

const float kDarkness = 60.0;  // an optical depth behind which none is looked for

// Optical depth from t0 to t1 of a grid so dense that light changes much over a step of ds: in steps that
// hold no more than a part of it, until it is dark.
float denseDepth(VolumeRay r, float t0, float t1, float ds) {
  const float kPiece = 0.25;
  const int kMost = MARCH_MOST_STEPS / MARCH_UNROLL;
  ds = max(ds, (t1 - t0) / float(kMost / 2));
  float sum = 0.0, t = t0, piece = min(ds, kPiece / max(sigmaAt(r, t0), 1e-30));
  int i = 0;
  do {
    piece = min(piece, t1 - t);
    float middle = t + 0.5 * piece;
    BrickPlace at = brickPlace(r, middle);
    float sigma = mediumAt(r, at).w, empty = emptyUntil(r, at);
    bool dense = sigma * piece > 2.0 * kPiece && piece > 1e-6 * (t - t0);
    sum += dense ? 0.0 : sigma * piece;
    t = dense ? t : max(t + piece, empty > middle ? empty : t);
    piece = dense ? max(0.25 * piece, kPiece / sigma) : min(ds, min(4.0 * piece, kPiece / max(sigma, 1e-30)));
    ++i;
  } while (t < t1 && sum < kDarkness && i < kMost);
  spend(i);
  return sum;
}

// Optical depth of volume v from a place along the unit direction d over tMax metres, midpoint march, steps
// of `scale` details or less where it is dense; no more than kDarkness is needed. Samples are taken
// MARCH_UNROLL at a time (written out: a loop would cost iterations); in empty bricks they are zeros, and
// where a group begins in one it is left at once.
#define MARCH_SAMPLE(j) \
  sum += i + j < n ? sigmaAt(r, begin + float(j) * ds) : 0.0;
float opticalDepth(int v, Place from, vec3 d, float scale, float tMax) {
  VolumeRay r;
  mat4 m = localFromWorld(v);
  vec3 lo = v == from.volume ? from.local : (m * vec4(from.p, 1.0)).xyz;
  vec2 hit = enterLocal(v, lo, (m * vec4(d, 0.0)).xyz, 0, r);
  float t0 = max(hit.x, -r.anchor), t1 = max(min(hit.y, tMax - r.anchor), t0);
  if (r.analytic) return r.extinction * (t1 - t0);
  int n = int(clamp(ceil((t1 - t0) / (detailOf(v) * scale)), 1.0, float(MARCH_MOST_STEPS)));
  float ds = (t1 - t0) / float(n), sum = 0.0;
  if (ds <= 0.0) return 0.0;
  if (ds > volumeRow(v, 11).y) return denseDepth(r, t0, t1, ds);
  int i = 0;
  do {
    float begin = t0 + (float(i) + 0.5) * ds;
    BrickPlace at = brickPlace(r, begin);
    int next = stepAtOrBehind(i, emptyUntil(r, at), t0, 0.5, ds);
    sum += mediumAt(r, at).w;
    MARCH_SAMPLE(1) MARCH_SAMPLE(2) MARCH_SAMPLE(3)
    i = max(next, i + MARCH_UNROLL);
    spend(1);
  } while (i < n && sum * ds < kDarkness);
  return sum * ds;
}
