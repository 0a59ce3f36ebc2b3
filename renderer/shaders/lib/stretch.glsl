// Walks a ray through overlapping volumes: in stretches, in which the same volumes are active, and step by
// step within them; the step is the smallest of those active.
// Variant constants: ACTIVE (volumes of an overlap kept in registers), OVERFLOW (1: there may be more; they
// are visited one by one), EMISSION (1: some volumes emit, and it counts; else, and if undefined, no glow)
// and STRETCH_ALBEDO (1: the active ones' albedo is kept too). A branch on a constant is none.
#pragma once
#include "lib/volume.glsl"
#include "lib/tiles.glsl"

#ifndef EMISSION
#define EMISSION 0
#endif
#ifndef STRETCH_ALBEDO
#define STRETCH_ALBEDO EMISSION
#endif

const bool kOverflow = OVERFLOW != 0;

struct Stretch {
  vec3 o, d;              // the ray, ...
  float end;              // ... where it ends, ...
  ivec2 range;            // ... and its tile's list
  VolumeRay rays[ACTIVE];
#if STRETCH_ALBEDO
  vec4 albedo[ACTIVE];
#endif
  int count, rest;        // how many are active; the first of the list that got no register
  float t, next, ds;      // from where to where; length of a step
  float footprint;        // [m] at t
  int i, n;               // the next step, of how many
};

// What there is at one step.
struct StretchSample {
  int step;
  float at, sigma;     // place on the ray; sigma_t of all [1/m]
  vec4 media[ACTIVE];  // factor of the albedo, sigma_t
  vec3 glow;           // radiance that is added per metre
};

// Before the first stretch, which begins at t.
Stretch beginStretches(vec3 o, vec3 d, float t, float end, ivec2 range) {
  Stretch s;
  s.o = o, s.d = d, s.end = end, s.range = range;
  s.count = 0, s.rest = range.y;
  s.t = 0.0, s.next = t, s.ds = 0.0, s.footprint = 0.0;
  s.i = 0, s.n = 0;
  return s;
}

// On to the next stretch, with steps of `scale` details where that footprint counts: who is active just
// behind `next`, and until when does that stay so? False behind the last volume.
bool nextStretch(inout Stretch s, float footprint, float scale) {
  s.t = s.next, s.next = 1e30;
  s.footprint = footprint;
  s.count = 0, s.rest = s.range.y;
  float ds = 1e30;
  for (int item = s.range.x; item < s.range.y; ++item) {
    int v = tileItem(item);
    VolumeRay ray;
    vec2 hit = min(enterVolume(v, s.o, s.d, levelFor(v, footprint), ray), vec2(s.end));
    bool ahead = hit.x < hit.y && hit.y > s.t, inside = ahead && hit.x <= s.t;
    s.next = ahead ? min(s.next, inside ? hit.y : hit.x) : s.next;
    ds = inside ? min(ds, stepFor(v, footprint)) : ds;
    for (int k = 0; k < ACTIVE; ++k) {
      if (inside && s.count == k) {
        s.rays[k] = ray;
#if STRETCH_ALBEDO
        s.albedo[k] = albedoOf(v);
#endif
      }
    }
    s.rest = inside && s.count == ACTIVE ? min(s.rest, item) : s.rest;
    s.count += inside ? 1 : 0;
  }
  bool more = s.next < 1e30;
  float steps = clamp(ceil((s.next - s.t) / (ds * scale)), 1.0, float(STRETCH_MOST_STEPS));
  s.n = more && s.count > 0 ? int(steps) : 0;
  s.ds = (s.next - s.t) / float(max(s.n, 1));
  s.i = 0;
  return more;
}

// Is that volume of the list, which got no register, active?
bool isActive(Stretch s, int item, out VolumeRay ray) {
  vec2 hit = enterVolume(tileItem(item), s.o, s.d, levelFor(tileItem(item), s.footprint), ray);
  return hit.x <= s.t && hit.y > s.t;
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

// Looks at the next step, `offset` (0 .. 1) into it, and goes on: behind empty bricks at once.
StretchSample look(inout Stretch s, float offset) {
  StretchSample x;
  x.step = s.i;
  x.at = s.t + (float(s.i) + offset) * s.ds;
  float empty = 1e30;
  for (int k = 0; k < ACTIVE; ++k) empty = k < s.count ? min(empty, emptyUntil(s.rays[k], x.at)) : empty;
  if (kOverflow) empty = s.rest < s.range.y ? x.at : empty;
  int to = stepAtOrBehind(s.i, empty, s.t, offset, s.ds);
  x.sigma = 0.0, x.glow = vec3(0.0);
  for (int k = 0; k < ACTIVE; ++k) {
    x.media[k] = k < s.count && to == s.i ? mediumAt(s.rays[k], x.at) : vec4(vec3(1.0), 0.0);
    x.sigma += x.media[k].w;
    x.glow += k < s.count && to == s.i ? glowOf(s, k, x.media[k]) : vec3(0.0);
  }
  if (kOverflow) {
    for (int item = s.rest; item < s.range.y; ++item) {
      VolumeRay ray;
      if (isActive(s, item, ray)) {
        vec4 here = mediumAt(ray, x.at);
        x.sigma += here.w;
        x.glow += glowOf(item, ray, here);
      }
    }
  }
  s.i = max(to, s.i + 1);
  return x;
}
