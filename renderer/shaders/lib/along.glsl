// Places on rays by how near they are to points and spots in the media: at the density with which a light in
// the empty would light them, 1/r^2, which is even in the angle from the light (equiangular sampling, Kulla
// and Fajardo 2012). Variant constant ALONG (1: there are such lights).
#pragma once
#include "lib/flight.glsl"
#include "lib/light.glsl"

#ifndef ALONG
#define ALONG 0
#endif

#if ALONG
uniform vec3 mediaMin, mediaMax;  // box around all that is drawn
uniform int lightCount;

// Of a ray: where it may have media [m], and what each light would bring to it [W/m, luminance].
struct NearRay {
  vec3 o, d;
  vec2 part;
};

NearRay nearRay(vec3 o, vec3 d, float end) {
  vec2 hit = intersectBox(o, d, mediaMin, mediaMax);
  return NearRay(o, d, vec2(max(hit.x, 0.0), min(hit.y, end)));
}

float nearLuminance(vec3 c) { return dot(c, vec3(0.2722287168, 0.6740817658, 0.0536895174)); }

// The light at its foot on the ray [m], how far off [m], and the angles at which it sees the ends.
vec4 seenFrom(int l, NearRay r) {
  vec3 to = lights[l].position.xyz - r.o;
  float foot = dot(to, r.d);
  float off = max(length(to - foot * r.d), 1e-6 * (abs(foot) + r.part.y - r.part.x) + 1e-12);
  return vec4(foot, off, atan(r.part.x - foot, off), atan(r.part.y - foot, off));
}

float broughtAlong(int l, NearRay r) {
  vec4 s = seenFrom(l, r);
  bool counts = (lights[l].solids.z & LIGHT_INSIDE) != 0 && r.part.x < r.part.y;
  return counts ? nearLuminance(lights[l].emitted.rgb) * (s.w - s.z) / s.y : 0.0;
}

float allBroughtAlong(NearRay r) {
  float sum = 0.0;
  int l = 0;
  do {
    sum += broughtAlong(l, r);
    spendWork(1);
    ++l;
  } while (l < lightCount);
  return sum;
}

// [1/m] at which light l and the place t are chosen; `all`: allBroughtAlong.
float nearDensity(int l, NearRay r, float t, float all) {
  vec4 s = seenFrom(l, r);
  float off = t - s.x, brought = nearLuminance(lights[l].emitted.rgb) / (s.y * s.y + off * off);
  return (lights[l].solids.z & LIGHT_INSIDE) != 0 && all > 0.0 ? brought / all : 0.0;
}

// A light and a place [m].
int chooseNear(NearRay r, float all, vec2 u, out float t) {
  float left = u.x * all, within = 0.0;
  int chosen = 0, l = 0;
  bool found = false;
  do {
    float brought = broughtAlong(l, r);
    bool here = !found && brought > 0.0 && left < brought;
    chosen = here ? l : chosen;
    found = found || here;
    left -= found ? 0.0 : brought;
    spendWork(1);
    ++l;
  } while (l < lightCount);
  vec4 s = seenFrom(chosen, r);
  t = clamp(s.x + s.y * tan(mix(s.z, s.w, u.y)), r.part.x, r.part.y);
  return found ? chosen : -1;
}

// The medium at a place of a ray, one volume chosen by its share of the extinction: its sum [1/m], 0 where
// there is none; metVolume and what belongs to it as a collision has them.
float mediumAlong(ivec2 range, vec3 o, vec3 d, float t, float u) {
  Pick pick = Pick(0.0, u);
  int item = range.x;
  do {
    int v = tileItem(item);
    VolumeRay r;
    vec2 hit = enterVolume(v, o, d, 0, r);
    float at = t - r.anchor;
    vec4 here = mediumAt(r, at);
    here.w = item < range.y && hit.x < hit.y && at >= hit.x && at <= hit.y ? here.w : 0.0;
    takeVolume(pick, v, here);
    spendWork(1);
    ++item;
  } while (item < range.y);
  metAt = o + t * d, metSigma = pick.sum;
  return pick.sum;
}
#endif
