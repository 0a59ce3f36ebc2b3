// Steps through all volumes on one light ray in order, as the representations need that store transmittance itself.
// Variant constants: STEP_HALVES (steps of that many half voxels), ACTIVE (volumes of an overlap kept in registers), OVERFLOW (1: there may be more; they are visited one by one).
#pragma once
#include "lib/volume.glsl"
#include "lib/tiles.glsl"
#include "lib/map_texel.glsl"

// WINDOWED 1: a dispatch marches one window of the light ray, and what a texel keeps waits in `windowStates` for the next one. Stretches and
// steps are cut at a window's ends.
#if WINDOWED
#include "shared/resume.h"
layout(std430, binding = BIND_MARCH_STATES) buffer WindowStates { float windowStates[]; };
uniform ivec2 window;  // which one, of how many
bool firstWindow() { return window.x == 0; }
bool lastWindow() { return window.x + 1 == window.y; }
// Groups are 8 x 8.
int stateSlot(int floats) { return int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 8u + gl_GlobalInvocationID.x) * floats; }
vec2 windowOf(float rayLength) { return rayLength * vec2(window.x, lastWindow() ? 1e9 : float(window.x + 1)) / float(window.y); }
#else
bool firstWindow() { return true; }
bool lastWindow() { return true; }
vec2 windowOf(float rayLength) { return vec2(0.0, 1e30); }
#endif

struct OrderedMarch {
  MapRay ray;
  ivec2 range;           // of the tile's list
  VolumeRay rays[ACTIVE];
  float t, next, ds;     // the stretch in which the active volumes stay the same; its step
  int i, n, count, rest;
};

OrderedMarch beginMarch(MapRay ray, ivec2 range) {
  OrderedMarch m;
  m.ray = ray, m.range = range;
  m.t = 0.0, m.next = windowOf(ray.length).x, m.ds = 0.0;
  m.i = 0, m.n = 0, m.count = 0, m.rest = range.y;
  return m;
}

// Who is active just behind `next`, and until when does that stay so? False behind the last volume.
bool nextStretch(inout OrderedMarch m) {
  float end = windowOf(m.ray.length).y;
  if (m.next >= end) return false;
  m.t = m.next;
  m.next = 1e30;
  m.count = 0, m.rest = m.range.y;
  float ds = 1e30;
  for (int item = m.range.x; item < m.range.y; ++item) {
    int v = tileItem(item);
    float size = footprintAt(m.t);
    VolumeRay r;
    vec2 hit = enterVolume(v, m.ray.o, m.ray.d, levelFor(v, size), r);
    hit = min(max(hit, vec2(0.0)), vec2(m.ray.length));
    bool ahead = hit.x < hit.y && hit.y > m.t, inside = ahead && hit.x <= m.t;
    m.next = ahead ? min(m.next, inside ? hit.y : hit.x) : m.next;
    ds = inside ? min(ds, stepFor(v, size)) : ds;
    for (int k = 0; k < ACTIVE; ++k) {
      if (inside && m.count == k) m.rays[k] = r;
    }
    m.rest = inside && m.count == ACTIVE ? min(m.rest, item) : m.rest;
    m.count += inside ? 1 : 0;
  }
  bool more = m.next < 1e30;
  m.next = min(m.next, end);
  m.n = more && m.count > 0 ? int(clamp(ceil((m.next - m.t) / (ds * 0.5 * float(STEP_HALVES))), 1.0, 8192.0)) : 0;
  m.ds = (m.next - m.t) / float(max(m.n, 1));
  m.i = 0;
  return more;
}

// The next step [a, b] (metres) with something in it, and its extinction [1/m]. False at the end.
bool nextStep(inout OrderedMarch m, out float a, out float b, out float sigma) {
  sigma = 0.0, a = 0.0, b = 0.0;
  bool more = true;
  int guard = 0;
  do {
    if (m.i >= m.n) more = nextStretch(m);
    if (more && m.i < m.n) {
      float at = m.t + (float(m.i) + 0.5) * m.ds, empty = 1e30;
      for (int k = 0; k < ACTIVE; ++k) empty = k < m.count ? min(empty, emptyUntil(m.rays[k], at)) : empty;
#if OVERFLOW
      empty = m.rest < m.range.y ? at : empty;
#endif
      int to = stepAtOrBehind(m.i, empty, m.t, 0.5, m.ds);
      for (int k = 0; k < ACTIVE; ++k) sigma += k < m.count && to == m.i ? sigmaAt(m.rays[k], at) : 0.0;
#if OVERFLOW
      for (int item = m.rest; item < m.range.y; ++item) {
        VolumeRay r;
        vec2 hit = enterVolume(tileItem(item), m.ray.o, m.ray.d, levelFor(tileItem(item), footprintAt(m.t)), r);
        if (hit.x <= m.t && hit.y > m.t) sigma += sigmaAt(r, at);
      }
#endif
      a = m.t + float(m.i) * m.ds;
      b = a + m.ds;
      m.i = max(to, m.i + 1);
    }
    ++guard;
  } while (more && sigma <= 0.0 && guard < 32768);
  return more && sigma > 0.0;
}
