// Where a path goes on behind a vertex, and how much light turns that way. Variant constant: PHASE_LOBES
// of lib/stretch.glsl.
#pragma once
#include "lib/flight.glsl"
#include "lib/phase.glsl"

// What scatters at a vertex: a medium's lobes, or a solid.
struct Vertex {
  vec3 p, d;  // and the direction in which it was reached
  bool solid;
  vec3 normal;
  vec4 lobes;
  float blend;
  vec3 albedo;
};

// Scattered per unit of solid angle, but for the albedo [1/sr]; and the density of scatteredDirection.
float scattersTo(Vertex v, vec3 d) {
  if (v.solid) return max(dot(v.normal, d), 0.0) / 3.14159265358979;
#if PHASE_LOBES
  return phaseOfLobes(dot(v.d, d), v.lobes, v.blend);
#else
  return phaseHg(dot(v.d, d), v.blend);
#endif
}

vec3 scatteredDirection(Vertex v) {
  vec3 u = random3();
  float cosine;
  if (v.solid) {
    cosine = sqrt(u.x);
  } else {
#if PHASE_LOBES
    vec2 lobe = u.z < v.blend ? v.lobes.zw : v.lobes.xy;
    int tries = 0;
    bool taken;
    do {
      cosine = henyeyGreensteinCosine(lobe.x, u.x);
      float top = 1.0 + lobe.y;
      taken = random3().x * top <= 1.0 + lobe.y * cosine * cosine;
      if (!taken) u.xy = random3().xy;
      spendWork(1);
    } while (!taken && ++tries < 1000);
#else
    cosine = henyeyGreensteinCosine(v.blend, u.x);
#endif
  }
  return directionAround(v.solid ? v.normal : v.d, cosine, u.y);
}

// Of a medium that a flight along d has met.
Vertex mediumVertex(vec3 d) {
  Vertex v;
  vec4 albedo = albedoOf(metVolume);
  v.p = metAt, v.d = d, v.solid = false, v.normal = -d;
  v.albedo = albedo.rgb * metFactor, v.blend = albedo.w, v.lobes = vec4(0.0);
#if PHASE_LOBES
  v.lobes = lobesOf(metVolume);
#endif
  return v;
}
