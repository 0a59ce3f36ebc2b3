// Lights: what arrives unshadowed, where a point lies in a light's map, and a map texel's light ray. Twins:
// scene/light.h, shadow/light_frustum.h. Variant constant: MANY_LIGHTS (1: more than a uniform block holds).
#pragma once
#include "shared/bindings.h"
#include "shared/records.h"

#ifndef MANY_LIGHTS
#define MANY_LIGHTS 0
#endif
#if MANY_LIGHTS
layout(std430, binding = BIND_LIGHTS) readonly buffer LightBlock { LightRecord lights[]; };
#else
layout(std140, binding = BIND_LIGHTS) uniform LightBlock { LightRecord lights[MAX_LIGHTS]; };
#endif

// Towards the light from p, and E(p) [W/m^2] without shadow.
struct Incidence {
  vec3 towards;
  float distance;  // metres; 1e30 for a sun
  float cone;      // what a spot's cone lets through, 0..1; else 1
  vec3 irradiance;
};

Incidence lightAt(int l, vec3 p) {
  vec3 to = lights[l].position.xyz - p;
  float r2 = dot(to, to), r = sqrt(r2);
  bool sun = lights[l].items.w == LIGHT_SUN;
  Incidence i;
  i.towards = sun ? lights[l].towards.xyz : r > 0.0 ? to / r : lights[l].towards.xyz;
  i.distance = sun ? 1e30 : r;
  float falloff = 1.0 / max(max(r2, lights[l].emitted.w * lights[l].emitted.w), 1e-30);
  float edge = lights[l].towards.w, inner = lights[l].position.w;
  float t = clamp((dot(i.towards, lights[l].towards.xyz) - edge) / max(inner - edge, 1e-6), 0.0, 1.0);
  i.cone = lights[l].items.w == LIGHT_SPOT ? t * t * (3.0 - 2.0 * t) : 1.0;
  i.irradiance = lights[l].emitted.rgb * (sun ? 1.0 : falloff * i.cone);
  return i;
}

// A piece of a ray as a light near it sees it: along it 1/r^2 may have any peak, so it is integrated. With
// the foot of the light on the ray at `foot` and h its distance from there, r^2 = h^2 + (t - foot)^2, and in
// the angle at which the light sees a point, tan(angle) = (t - foot)/h, dt/r^2 is d(angle)/h.
struct Passage {
  float falloff;   // mean of 1/max(r^2, radius^2) [1/m^2]; of a sun 1
  float centre;    // where in the piece the mean lies that 1/r^2 weighs, 0..1
  float spread;    // how much that weight is spread out: 1 evenly, 0 at one point
  vec2 angles;     // of its ends
};

const Passage kSunPassage = Passage(1.0, 0.5, 1.0, vec2(0.0));

// Integral of 1/(h^2 + t^2) over t0 .. t1, which both have the same sign, or are 0.
float integralOfFalloff(float h, float t0, float t1) {
  return t1 > t0 ? atan(h * (t1 - t0) / (h * h + t0 * t1)) / h : 0.0;
}

// The piece of unit direction d over ds metres from p.
Passage passageOf(int l, vec3 p, vec3 d, float ds) {
  vec3 to = lights[l].position.xyz - p;
  float foot = dot(to, d), radius = lights[l].emitted.w;
  // A ray that meets a point is as bright as one that passes next to it: nothing is so thin as a line.
  float h = max(length(to - foot * d), 1e-5 * ds + 1e-7 * abs(foot)), a = -foot, b = ds - foot;
  float inside = sqrt(max(radius * radius - h * h, 0.0));  // half of what lies in the light
  float sum = integralOfFalloff(h, a, min(b, -inside)) + integralOfFalloff(h, max(a, inside), b);
  if (inside > 0.0) sum += max(min(b, inside) - max(a, -inside), 0.0) / (radius * radius);
  Passage q;
  q.falloff = sum / max(ds, 1e-30);
  q.angles = vec2(atan(a, h), atan(b, h));
  float mean = 0.5 * log((h * h + b * b) / (h * h + a * a)) / max(sum, 1e-30),
        square = ds / max(sum, 1e-30) - h * h;
  q.centre = clamp((mean - a) / ds, 0.0, 1.0);
  q.spread = clamp(12.0 * (square - mean * mean) / (ds * ds), 0.0, 1.0);
  return q;
}

// Maps of point lights have six faces: 0..5 = +X -X +Y -Y +Z -Z of light space. A face's image plane is
// spanned by the other two axes in cyclic order. One texel of border beyond 90 degrees makes bilinear
// footprints whole at the edges.
float faceScale(int kind, float edge) { return kind == LIGHT_POINT ? 1.0 - 2.0 / edge : 1.0; }

// World -> (u, v, x): u and v in [0,1]^2 of face `face`, x in [0,1] from near to far; any of them may lie
// outside.
vec3 mapCoordinates(int l, vec3 p, float edge, out int face) {
  vec3 q = (lights[l].lightFromWorld * vec4(p, 1.0)).xyz;
  face = 0;
  int kind = lights[l].items.w;
  if (kind == LIGHT_SUN) return q;
  float x = (length(q) - lights[l].extent.z) / lights[l].extent.x;
  vec3 a = abs(q);
  int axis = kind == LIGHT_SPOT ? 2 : a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  float along = axis == 0 ? q.x : axis == 1 ? q.y : q.z;
  vec2 across = axis == 0 ? q.yz : axis == 1 ? q.zx : q.xy;
  face = kind == LIGHT_POINT ? 2 * axis + (along < 0.0 ? 1 : 0) : 0;
  float depth = kind == LIGHT_POINT ? abs(along) : along;
  vec2 uv = 0.5 + 0.5 * faceScale(kind, edge) * across / (max(depth, 1e-20) * lights[l].extent.w);
  return vec3(depth > 0.0 ? uv : vec2(-1.0), x);
}

// The light ray of map coordinates: from x = 0 to 1 is o + t d, t in [0, tMax] metres.
struct MapRay {
  vec3 o, d;
  float tMax;
};

MapRay mapRay(int l, int face, vec2 uv, float edge) {
  int kind = lights[l].items.w;
  MapRay r;
  if (kind == LIGHT_SUN) {
    r.o = (lights[l].worldFromLight * vec4(uv, 0.0, 1.0)).xyz;
    vec3 end = (lights[l].worldFromLight * vec4(uv, 1.0, 1.0)).xyz;
    r.tMax = length(end - r.o);
    r.d = (end - r.o) / r.tMax;
    return r;
  }
  vec2 across = (2.0 * uv - 1.0) / faceScale(kind, edge) * lights[l].extent.w;
  int axis = face >> 1;
  float s = (face & 1) == 1 ? -1.0 : 1.0;
  vec3 q = kind == LIGHT_SPOT ? vec3(across, 1.0)
           : axis == 0        ? vec3(s, across)
           : axis == 1        ? vec3(across.y, s, across.x)
                              : vec3(across, s);
  r.d = normalize((lights[l].worldFromLight * vec4(q, 0.0)).xyz);
  r.o = lights[l].position.xyz + lights[l].extent.z * r.d;
  r.tMax = lights[l].extent.x;
  return r;
}
