// Camera rays through the media of a scene, front to back and up to the nearest solid. Places are relative to
// the pass's origin, which is the eye or the part of the media nearest to it. A shader that includes this
// says what it makes of them: passStep and addSample. Variant constants: SOLIDS (1: there are some to draw),
// RESUME (1: a ray may take several dispatches, lib/resume.glsl), SHAPES and those of lib/stretch.glsl; with
// STRETCH_SCALED what is seen through media is seen through their scaled extinction, and then, as with
// STRETCH_TINTED, in three channels.
#pragma once
#include "lib/camera.glsl"
#include "lib/stretch.glsl"
#include "lib/solid.glsl"

uniform float pixelAngle;  // footprint [m] of a pixel per metre of distance
uniform float stepScale;   // steps of so many details
uniform int solidCount;             // drawn: the first ones
const bool kSolids = SOLIDS != 0;
const float kOpaque = 1e-4;      // a ray of less T ends
const float kStepDepth = 0.5;    // optical depth of a step

struct CameraRay {
  vec3 d;
  float forward;  // metres along the viewing axis per metre
  float offset;   // of samples in their steps
  ivec2 range;    // of its tile's list
  float end;      // where it meets a solid, else kNoHit
  int solid;
  vec3 normal;
};

#if STRETCH_COLORS
#define Through vec3
float mostOf(vec3 t) { return max(max(t.r, t.g), t.b); }
#else
#define Through float
float mostOf(float t) { return t; }
#endif

Through T = Through(1.0);  // of the media in front of what is looked at
#if STRETCH_TINTED
#define Clear vec3
float meanOf(vec3 t) { return (t.r + t.g + t.b) / 3.0; }
#else
#define Clear float
float meanOf(float t) { return t; }
#endif
#if STRETCH_SCALED
Clear clear = Clear(1.0);  // of the same, but not scaled: what alpha lacks
#else
#define clear T
#endif

// Each step that is looked at, whether there is something in it or not.
void passStep(Stretch s, inout StretchSample x);
// A stretch without any volume.
void passGap();
// Where a step has to end, metres into the stretch; kNoEdge: wherever it likes.
float nextCut(Stretch s);
// The next step with something in it (or, once there is none, one without): all but what it takes of T.
// False: the same step is due once more.
bool addSample(CameraRay ray, Stretch s, StretchSample x);

// The optical depth of a step that is seen through.
Through seenDepthOf(StretchSample x) {
#if STRETCH_COLORS
  return x.extinction * x.ds;
#else
  return depthOf(x);
#endif
}

// The same, but not scaled.
Clear clearDepthOf(StretchSample x) {
#if STRETCH_TINTED
  return x.plain * x.ds;
#else
  return depthOf(x);
#endif
}

// What of the light behind a step comes through, and the mean of that over the step.
Through through(StretchSample x) { return exp(-seenDepthOf(x)); }
Through meanThrough(StretchSample x) {
  Through depth = seenDepthOf(x), even = (1.0 - exp(-depth)) / max(depth, 1e-2);
  return mix(even, 1.0 - depth * (0.5 - depth / 6.0), 1.0 - step(1e-2, depth));
}

// r: xy place in the pixel, z offset of the samples.
CameraRay cameraRay(ivec2 pixel, vec3 r) {
  CameraRay ray;
  ray.d = cameraDirection(pixel, r.xy);
  ray.forward = -dot(ray.d, back);
  ray.offset = r.z;
  ray.range = tileRange(pixel);
  ray.end = kNoHit, ray.solid = 0, ray.normal = -ray.d;
  return ray;
}

void findSolid(inout CameraRay ray) {
  if (kSolids) ray.end = nearestSolid(solidCount, eye, ray.d, ray.solid, ray.normal);
}

bool meetsSolid(CameraRay ray) { return kSolids && ray.end < kNoHit && mostOf(T) >= kOpaque && !paused; }
vec3 solidPoint(CameraRay ray) { return eye + ray.end * ray.d; }
// From where rays that leave it start.
vec3 solidClear(CameraRay ray) {
  vec3 p = solidPoint(ray);
  return p + solidClearance(ray.solid, p, ray.normal, ray.end) * ray.normal;
}

StretchSample nextSample(inout Stretch s) {
  StretchSample x;
  vec2 before;
  do {
    before = vec2(s.at, s.wanted);
    x = look(s, nextCut(s));
    passStep(s, x);
    spendStep();
  } while (x.sigma <= 0.0 && hasSteps(s) && !mustPause());
  if (x.sigma <= 0.0)
    foundNothing(vec2(s.at, s.wanted), hasSteps(s));
  else
    foundStep(before);
  spendSample();
  return x;
}

void marchStretch(CameraRay ray, inout Stretch s) {
  goOnAt(s.at, s.wanted);
  StretchSample x;
  bool done = true, more;
  do {
    if (done) x = nextSample(s);
    done = addSample(ray, s, x);
    T *= done && !paused ? through(x) : Through(1.0);
#if STRETCH_SCALED
    clear *= done && !paused ? exp(-clearDepthOf(x)) : Clear(1.0);
#endif
    more = !done || (hasSteps(s) && mostOf(T) >= kOpaque);
    if (done && !paused) stepDone(vec2(s.at, s.wanted), more);
  } while (more && !paused);
}

void marchMedia(CameraRay ray) {
  Stretch s = beginStretches(eye, ray.d, firstPlace(), ray.end, ray.range, ray.offset, kStepDepth);
  bool inMedia = ray.range.x < ray.range.y && mediaAreDue();
  while (inMedia) {
    spendStretch();
    if (!nextStretch(s, pixelAngle * metres(s.next), stepScale)) break;
    if (s.count > 0) marchStretch(ray, s);
    else passGap();
    bool more = mostOf(T) >= kOpaque && !endsHere(s);
    if (!paused) stretchDone(s.next, more);
    inMedia = more && !paused;
  }
  mediaDone();
  spendSample();
}
