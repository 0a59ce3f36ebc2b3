// Camera rays through the media of a scene, front to back and up to the nearest solid. A shader that includes
// this says what it makes of them: passStep and addSample.
// Variant constants: SOLIDS (1: there are some to draw), RESUME (1: a ray may take several dispatches,
// lib/resume.glsl), SHAPES and those of lib/stretch.glsl.
#pragma once
#include "lib/stretch.glsl"
#include "lib/solid.glsl"

uniform ivec2 regionOrigin, regionEnd, size;
uniform vec3 eye, right, up, back;  // right and up are scaled to half the picture at distance 1
uniform float pixelAngle;           // footprint [m] of a pixel per metre of distance
uniform float stepScale;            // steps of so many details
uniform int solidCount;             // drawn: the first ones
const bool kSolids = SOLIDS != 0;
const float kOpaque = 1e-4;  // a ray of less T ends

struct CameraRay {
  vec3 d;
  float forward;  // metres along the viewing axis per metre
  float offset;   // of samples in their steps
  ivec2 range;    // of its tile's list
  float end;      // where it meets a solid, else kNoHit
  int solid;
  vec3 normal;
};

float T = 1.0;  // of the media in front of what is looked at

// Each step that is looked at, whether there is something in it or not.
void passStep(Stretch s, inout StretchSample x);
// The next step with something in it (or, once there is none, one without): all but what it takes of T.
void addSample(CameraRay ray, Stretch s, StretchSample x);

// What of the light behind a step comes through.
float through(Stretch s, StretchSample x) { return exp(-x.sigma * s.ds); }

ivec2 regionPixel() { return regionOrigin + ivec2(gl_GlobalInvocationID.xy); }
bool inRegion(ivec2 pixel) { return all(lessThan(pixel, regionEnd)); }
int regionSlot(ivec2 pixel) {
  return (pixel.y - regionOrigin.y) * (regionEnd.x - regionOrigin.x) + pixel.x - regionOrigin.x;
}

// r: xy place in the pixel, z offset of the samples.
CameraRay cameraRay(ivec2 pixel, vec3 r) {
  CameraRay ray;
  vec2 ndc = (vec2(pixel) + r.xy) / vec2(size) * 2.0 - 1.0;
  ray.d = normalize(ndc.x * right - ndc.y * up - back);
  ray.forward = -dot(ray.d, back);
  ray.offset = r.z;
  ray.range = tileRange(pixel);
  ray.end = kNoHit, ray.solid = 0, ray.normal = -ray.d;
  return ray;
}

void findSolid(inout CameraRay ray) {
  if (kSolids) ray.end = nearestSolid(solidCount, eye, ray.d, ray.solid, ray.normal);
}

bool meetsSolid(CameraRay ray) { return kSolids && ray.end < kNoHit && T >= kOpaque && !paused; }
vec3 solidPoint(CameraRay ray) { return eye + ray.end * ray.d; }
// From where rays that leave it start.
vec3 solidClear(CameraRay ray) {
  vec3 p = solidPoint(ray);
  return p + solidClearance(ray.solid, p, ray.normal, ray.end) * ray.normal;
}

StretchSample nextSample(inout Stretch s, float offset) {
  StretchSample x;
  do {
    x = look(s, offset);
    passStep(s, x);
    spendStep();
  } while (x.sigma <= 0.0 && s.i < s.n && !mustPause());
  if (x.sigma <= 0.0)
    foundNothing(s.i, s.n);
  else
    foundStep(x.step);
  spendSample();
  return x;
}

void marchStretch(CameraRay ray, inout Stretch s) {
  s.i = firstStep();
  do {
    StretchSample x = nextSample(s, ray.offset);
    addSample(ray, s, x);
    if (!paused) {
      T *= through(s, x);
      stepDone(s.i, s.i < s.n && T >= kOpaque);
    }
  } while (s.i < s.n && T >= kOpaque && !paused);
}

void marchMedia(CameraRay ray) {
  Stretch s = beginStretches(eye, ray.d, firstT(), ray.end, ray.range);
  bool inMedia = ray.range.x < ray.range.y && mediaAreDue();
  while (inMedia) {
    spendStretch();
    if (!nextStretch(s, pixelAngle * s.next, stepScale)) break;
    if (s.count > 0) marchStretch(ray, s);
    bool more = T >= kOpaque && s.next < ray.end;
    if (!paused) stretchDone(s.next, more);
    inMedia = more && !paused;
  }
  mediaDone();
  spendSample();
}
