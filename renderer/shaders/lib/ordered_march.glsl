// Steps through all volumes on one light ray in order, as the representations need that store transmittance
// itself.
// Variant constants: STEP_HALVES (steps of that many half voxels), WINDOWED and those of lib/stretch.glsl.
#pragma once
#include "lib/stretch.glsl"
#include "lib/map_texel.glsl"

// WINDOWED 1: a dispatch marches one window of the light ray, and what a texel keeps waits in `windowStates`
// for the next one. Stretches and steps are cut at a window's ends.
#if WINDOWED
#include "shared/resume.h"
layout(std430, binding = BIND_MARCH_STATES) buffer WindowStates { float windowStates[]; };
uniform ivec2 window;  // which one, of how many
bool firstWindow() { return window.x == 0; }
bool lastWindow() { return window.x + 1 == window.y; }
// Groups are 8 x 8.
int stateSlot(int floats) {
  return int(gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 8u + gl_GlobalInvocationID.x) * floats;
}
vec2 windowOf(float rayLength) {
  return rayLength * vec2(window.x, lastWindow() ? 1e9 : float(window.x + 1)) / float(window.y);
}
#else
bool firstWindow() { return true; }
bool lastWindow() { return true; }
vec2 windowOf(float rayLength) { return vec2(0.0, 1e30); }
#endif

// Steps of so much optical depth at most, as long as there is light: a straight line over one is off by an
// eighth of its square.
const float kOrderedDepth = 0.05;

Stretch beginMarch(MapRay ray, ivec2 range) {
  vec2 window_ = windowOf(ray.tMax);
  return beginStretches(ray.o, ray.d, vec2(window_.x, 0.0), min(window_.y, ray.tMax), range, 0.5,
                        kOrderedDepth);
}

// The next step [a, b] (metres) with something in it, and its optical depth. False at the end. T: what of the
// light arrives there.
bool nextStep(inout Stretch s, float T, out float a, out float b, out float depth) {
  depth = 0.0, a = 0.0, b = 0.0;
  s.most = T > 1e-5 ? kOrderedDepth : 1e30;
  bool more = true;
  int guard = 0;
  do {
    if (!hasSteps(s))
      more = !endsHere(s) && nextStretch(s, footprintAt(metres(s.next)), 0.5 * float(STEP_HALVES));
    if (more && hasSteps(s)) {
      StretchSample x = look(s, kNoEdge);
      depth = depthOf(x);
      a = metresTo(s, x.from);
      b = metresTo(s, x.from + x.ds);
    }
    ++guard;
  } while (more && depth <= 0.0 && guard < 32768);
  return more && depth > 0.0;
}
