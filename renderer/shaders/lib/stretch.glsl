// Walks a ray through overlapping volumes: in stretches, in which the same volumes are active, and step by
// step within them. A step is as long as the smallest of those active asks for, and shorter where they are so
// dense that it would hold more than `most` of optical depth.
// Places on the ray are kept in two parts, the anchor of a volume (metres) and a small rest, and within a
// stretch count from where it begins: so that what is thin keeps its thickness however far away it is.
// Variant constants: ACTIVE (volumes of an overlap kept in registers), OVERFLOW (1: there may be more; they
// are visited one by one), EMISSION (1: some volumes emit, and it counts; else, and if undefined, no glow)
// STRETCH_ALBEDO (1: the active ones' albedo is kept too), PHASE_LOBES (1: and with it the lobes of their
// phase functions, which are not all Henyey and Greenstein's), STRETCH_IDS (1: it is known which volumes they
// are), STRETCH_SCALED (1, with STRETCH_ALBEDO: scaled extinction and scattering are summed up beside, of
// phase functions whose forward peak goes straight on), STRETCH_TINTED (1, with STRETCH_ALBEDO: extinction
// has colours, which are summed up beside) and DENSE (1: there are voxels through which no light comes, so
// that a step looks at its end too, lest a surface is passed between two middles). A branch on a constant is
// none.
#pragma once
#include "lib/volume.glsl"
#include "lib/tiles.glsl"

#ifndef EMISSION
#define EMISSION 0
#endif
#ifndef STRETCH_ALBEDO
#define STRETCH_ALBEDO EMISSION
#endif

#ifndef PHASE_LOBES
#define PHASE_LOBES 0
#endif

#ifndef STRETCH_IDS
#define STRETCH_IDS 0
#endif

#ifndef DENSE
#define DENSE 0
#endif

#ifndef STRETCH_SCALED
#define STRETCH_SCALED 0
#endif
#ifndef STRETCH_TINTED
#define STRETCH_TINTED 0
#endif
#define STRETCH_COLORS (STRETCH_SCALED || STRETCH_TINTED)

const bool kOverflow = OVERFLOW != 0;
const float kNoEdge = 1e30;
const float kCoarseSteps = 32.0;
// Of so many voxels: over more, what is lost at its ends does not count.
const float kShort = 20.0;
// A volume is inside a stretch that misses so much of its chord: roundings differ between the places at which
// a compiler repeats them.
const float kSameEdge = 1e-5;
// A step that was too dense is taken again with a fraction of its length, one behind it may be longer again.
const float kLeastOfStep = 1.0 / 16.0, kMostOfStep = 4.0;

struct Stretch {
  vec3 o, d;              // the ray, ...
  float end;              // ... where it ends [m], ...
  ivec2 range;            // ... and its tile's list
  float offset;           // 0 .. 1: shifts the steps, 0.5 is none
  float most;             // optical depth of a step
  VolumeRay rays[ACTIVE]; // their places count from where the stretch begins
#if STRETCH_ALBEDO
  vec4 albedo[ACTIVE];
#if PHASE_LOBES
  vec4 lobes[ACTIVE];
#endif
#if STRETCH_SCALED
  vec2 scaled[ACTIVE];    // their phase functions
#endif
#if STRETCH_TINTED
  vec3 tints[ACTIVE];
#endif
#endif
#if STRETCH_IDS
  int ids[ACTIVE];
#endif
  int count, rest;        // how many are active; the first of the list that got no register
  vec2 begin, next;       // where it begins and where the next one does: anchor, rest
  int first, level;       // the first active volume and its mip, or -1
  Place start;            // where it begins, in that volume
  float span;             // metres from one to the other
  float ds;               // [m] a step where nothing is dense
  float voxel;            // [m] the smallest of those active
  float edge;             // [m] first and last step: next to a grid's face it falls off over a voxel
  float at, wanted;       // metres into the stretch to the next step, and how long it shall be
  float footprint;        // [m] where it begins
};

// What there is at one step; what is too dense for its length has none, and neither has nothing.
struct StretchSample {
  float from, ds;      // metres into the stretch, and its length; 0: it is to be taken again
  float sigma;         // sigma_t of all [1/m]
  vec4 media[ACTIVE];  // factor of the albedo, sigma_t
  vec3 glow;           // radiance that is added per metre
#if STRETCH_COLORS
  vec3 extinction;  // of all, scaled or not [1/m]
  vec3 scattering, forward;  // scaled; the latter times the mean cosine
  vec3 plain;       // extinction, not scaled
#endif
};

#if STRETCH_SCALED
vec2 scaledOf(Stretch s, int k) { return s.scaled[k]; }
vec2 scaledOf(int v) { return scaledPhaseOf(v); }
#else
vec2 scaledOf(Stretch s, int k) { return vec2(0.0); }
vec2 scaledOf(int v) { return vec2(0.0); }
#endif
#if STRETCH_TINTED
vec3 tinted(Stretch s, int k) { return s.tints[k]; }
vec3 tinted(int v) { return tintOf(v); }
#else
vec3 tinted(Stretch s, int k) { return vec3(1.0); }
vec3 tinted(int v) { return vec3(1.0); }
#endif

#if STRETCH_COLORS
// Of a volume: its albedo, medium, scaled phase function and tint.
void addColors(inout StretchSample x, vec4 albedo, vec4 medium, vec2 scaled, vec3 tint) {
  vec3 sigma = medium.w * tint, w = albedo.rgb * medium.rgb, s = sigma * w * (1.0 - scaled.x);
  x.extinction += sigma * (1.0 - w * scaled.x);
  x.scattering += s;
  x.forward += s * scaled.y;
  x.plain += sigma;
}
#endif

float metres(vec2 place) { return place.x + place.y; }
// Metres along the ray to a place in the stretch, and the place.
float metresTo(Stretch s, float at) { return s.begin.x + (s.begin.y + at); }
vec3 pointAt(Stretch s, float at) { return s.start.p + at * s.d; }
Place placeAt(Stretch s, float at) {
  return Place(pointAt(s, at), s.first < 0 ? vec3(0.0) : localAt(s.first, s.rays[0], s.level, at), s.first);
}
float middleOf(StretchSample x) { return x.from + 0.5 * x.ds; }
float depthOf(StretchSample x) { return x.sigma * x.ds; }

// Before the first stretch, which begins at `from` (anchor, rest).
Stretch beginStretches(vec3 o, vec3 d, vec2 from, float end, ivec2 range, float offset, float most) {
  Stretch s;
  s.o = o, s.d = d, s.end = end, s.range = range;
  s.offset = offset, s.most = most;
  s.count = 0, s.rest = range.y;
  s.begin = from, s.next = from, s.span = 0.0;
  s.first = -1, s.level = 0, s.start = placeAt(o + metres(from) * d);
  for (int k = 0; k < ACTIVE; ++k) s.rays[k] = noRay();
#if STRETCH_IDS
  for (int k = 0; k < ACTIVE; ++k) s.ids[k] = 0;
#endif
  s.ds = 0.0, s.voxel = 0.0, s.edge = 0.0, s.at = 0.0, s.wanted = 0.0, s.footprint = 0.0;
  return s;
}

bool endsHere(Stretch s) { return metres(s.next) >= s.end; }
bool hasSteps(Stretch s) { return s.at < s.span; }

// Where steps begin anew their phase is the ray's.
float firstStep(Stretch s) { return s.ds * (0.5 + s.offset); }

// On to the next stretch, with steps of `scale` details where that footprint counts: who is active just
// behind `next`, and until when does that stay so? False behind the last volume.
bool nextStretch(inout Stretch s, float footprint, float scale) {
  s.begin = s.next;
  s.span = kNoEdge;
  s.footprint = footprint;
  s.count = 0, s.rest = s.range.y;
  float ds = 1e30, finest = 1e30, voxel = 1e30;
  s.first = -1;
  for (int item = s.range.x; item < s.range.y; ++item) {
    int v = tileItem(item);
    VolumeRay ray;
    int level = levelFor(v, footprint);
    vec2 hit = enterVolume(v, s.o, s.d, level, ray);
    float ahead = ray.anchor - s.begin.x;
    vec2 edges = (hit - s.begin.y) + ahead;  // from where the stretch begins
    float slack = kSameEdge * (hit.y - hit.x);
    bool counts = hit.x < hit.y && edges.y > slack, inside = counts && edges.x <= slack;
    float edge = inside ? edges.y : edges.x;
    bool nearest = counts && edge < s.span;
    s.span = nearest ? edge : s.span;
    s.next = nearest ? vec2(ray.anchor, inside ? hit.y : hit.x) : s.next;
    ds = inside ? min(ds, scale * stepFor(v, footprint)) : ds;
    finest = inside ? min(finest, stepFor(v, footprint)) : finest;
    voxel = inside ? min(voxel, voxelOf(v, level)) : voxel;
    s.level = inside && s.first < 0 ? level : s.level;
    s.first = inside && s.first < 0 ? v : s.first;
    for (int k = 0; k < ACTIVE; ++k) {
      if (inside && s.count == k) {
        s.rays[k] = startingAt(ray, s.begin.y - ahead);
#if STRETCH_IDS
        s.ids[k] = v;
#endif
#if STRETCH_ALBEDO
        s.albedo[k] = albedoOf(v);
#if PHASE_LOBES
        s.lobes[k] = lobesOf(v);
#endif
#if STRETCH_SCALED
        s.scaled[k] = scaledPhaseOf(v);
#endif
#if STRETCH_TINTED
        s.tints[k] = tintOf(v);
#endif
#endif
      }
    }
    s.rest = inside && s.count == ACTIVE ? min(s.rest, item) : s.rest;
    s.count += inside ? 1 : 0;
  }
  float end = (s.end - s.begin.x) - s.begin.y;
  bool more = s.span < kNoEdge && end > 0.0, cut = s.span >= end;
  s.next = cut ? vec2(s.end, 0.0) : s.next;
  s.span = more ? min(s.span, end) : 0.0;
  // Coarse steps are for long ways.
  ds = min(ds, max(finest, s.span / kCoarseSteps));
  s.ds = s.span / clamp(ceil(s.span / ds), 1.0, float(STRETCH_MOST_STEPS));
  s.voxel = min(voxel, s.span);
  s.edge = ds < 0.75 * voxel || s.span > kShort * voxel ? s.ds : s.voxel;
  s.at = more && s.count > 0 ? 0.0 : s.span;
  s.wanted = s.edge;
  s.start = placeAt(s.o + metres(s.begin) * s.d);
  if (s.first >= 0) {
    s.start.local = localAt(s.first, s.rays[0], s.level, 0.0);
    s.start.p = (worldFromLocal(s.first) * vec4(s.start.local, 1.0)).xyz;
    s.start.volume = s.first;
  }
  return more;
}

// Is that volume of the list, which got no register, active? Its places then count from where the stretch
// begins.
bool isActive(Stretch s, int item, out VolumeRay ray) {
  vec2 hit = enterVolume(tileItem(item), s.o, s.d, levelFor(tileItem(item), s.footprint), ray);
  float ahead = ray.anchor - s.begin.x, middle = 0.5 * s.span;
  vec2 edges = (hit - s.begin.y) + ahead;
  ray = startingAt(ray, s.begin.y - ahead);
  return edges.x <= middle && edges.y > middle;
}

#if EMISSION
// Radiance that a volume's table (factor and all) adds per metre; nothing of a medium.
vec3 emission(VolumeRay ray, vec4 factor, vec4 table) {
  return ray.extinction < 0.0 ? factor.rgb * table.rgb : vec3(0.0);
}
vec3 glowOf(Stretch s, int k, vec4 table) { return emission(s.rays[k], s.albedo[k], table); }
vec3 glowOf(int item, VolumeRay ray, vec4 table) { return emission(ray, albedoOf(tileItem(item)), table); }
#else
vec3 glowOf(Stretch s, int k, vec4 table) { return vec3(0.0); }
vec3 glowOf(int item, VolumeRay ray, vec4 table) { return vec3(0.0); }
#endif

// Looks at the middle of the next step and goes on behind it: behind empty bricks at once; not at all where
// the step is too dense, which makes the next one shorter. No step goes past `cut` [m into the stretch].
StretchSample look(inout Stretch s, float cut) {
  StretchSample x;
  float left = s.span - s.at;
  x.from = s.at;
  float least = min(s.edge, s.wanted);
  x.ds = left <= 1.25 * least ? left : min(s.wanted, left - least);
  x.ds = cut > s.at ? min(x.ds, cut - s.at) : x.ds;
  float middle = x.from + 0.5 * x.ds, empty = 1e30;
  // Each page is fetched once, outside all branches.
  BrickPlace at[ACTIVE];
  for (int k = 0; k < ACTIVE; ++k) {
    at[k] = brickPlace(s.rays[k], middle);
    empty = min(empty, k < s.count ? emptyUntil(s.rays[k], at[k]) : 1e30);
  }
  if (kOverflow) empty = s.rest < s.range.y ? middle : empty;
  bool something = empty <= middle;
  x.sigma = 0.0, x.glow = vec3(0.0);
#if STRETCH_COLORS
  x.extinction = vec3(0.0), x.scattering = vec3(0.0), x.forward = vec3(0.0), x.plain = vec3(0.0);
#endif
  for (int k = 0; k < ACTIVE; ++k) {
    vec4 here = mediumAt(s.rays[k], at[k]);
    x.media[k] = k < s.count && something ? here : vec4(vec3(1.0), 0.0);
    x.sigma += x.media[k].w;
    x.glow += k < s.count && something ? glowOf(s, k, x.media[k]) : vec3(0.0);
#if STRETCH_COLORS
    if (k < s.count) addColors(x, s.albedo[k], x.media[k], scaledOf(s, k), tinted(s, k));
#endif
  }
  if (kOverflow) {
    for (int item = s.rest; item < s.range.y; ++item) {
      VolumeRay ray;
      if (isActive(s, item, ray)) {
        vec4 here = mediumAt(ray, middle);
        x.sigma += here.w;
        x.glow += glowOf(item, ray, here);
#if STRETCH_COLORS
        addColors(x, albedoOf(tileItem(item)), here, scaledOf(tileItem(item)), tinted(tileItem(item)));
#endif
      }
    }
  }
  float peak = x.sigma;
#if DENSE
  float end = 0.0;
  for (int k = 0; k < ACTIVE; ++k)
    end += k < s.count && something ? mediumAt(s.rays[k], x.from + 0.999 * x.ds).w : 0.0;
  peak = max(peak, end);
#endif
  float fitting = 0.9 * s.most / max(peak, 1e-30);
  // No shorter than floats can tell: the step is exact for what does not change within it.
  bool dense = peak * x.ds > 1.5 * s.most && x.ds > 1e-6 * s.at;
  float to = something ? (x.ds == left ? s.span : x.from + x.ds) : min(empty, s.span);
  float longest = x.from > 0.0 ? s.ds : firstStep(s);
  s.wanted = dense       ? max(fitting, kLeastOfStep * x.ds)
             : something ? min(longest, clamp(fitting, x.ds, kMostOfStep * max(x.ds, s.edge)))
                         : firstStep(s);
  s.at = dense ? s.at : to;
  x.ds = dense ? 0.0 : something ? x.ds : to - x.from;
  x.sigma = dense ? 0.0 : x.sigma;
  return x;
}
