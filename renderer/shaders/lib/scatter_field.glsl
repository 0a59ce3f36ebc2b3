// Light that has been scattered at least once: moments of its radiance on a lattice, three blocks of one
// texture side by side along z, one per channel (view/scatter_field.h).
#pragma once
#include "shared/scatter.h"

layout(binding = UNIT_SCATTER) uniform sampler3D scatterMoments;
uniform vec3 scatterMin, scatterPerMetre;  // of the lattice, relative to the pass's origin; 1 / its size
uniform vec3 lightScale;                   // scaled optical depths are so many times those of light's shadows
uniform float scatterCell;                 // [m]

// xyz: radiance times direction, w: radiance, over all directions.
vec4 scatterMoment(vec3 p, int channel) {
  vec3 size = vec3(textureSize(scatterMoments, 0)) / vec3(1.0, 1.0, 3.0);
  vec3 q = clamp((p - scatterMin) * scatterPerMetre * size, vec3(0.5), size - 0.5);
  q.z += float(channel) * size.z;
  return textureLod(scatterMoments, q / (size * vec3(1.0, 1.0, 3.0)), 0.0);
}

// What of it is scattered at p into direction d, per metre: by scaled scattering, and that times the mean
// cosine [1/m].
vec3 scatteredAgain(vec3 p, vec3 d, vec3 scattering, vec3 forward) {
  vec3 sum = vec3(0.0);
  for (int c = 0; c < 3; ++c) {
    vec4 m = scatterMoment(p, c);
    sum[c] = max(scattering[c] * m.w + 3.0 * forward[c] * dot(m.xyz, d), 0.0);
  }
  return sum / (4.0 * 3.14159265358979);
}

// What falls of it on a surface at p, looked up a cell off it, where none of its own cells are [W/m^2].
vec3 scatteredOnto(vec3 p, vec3 normal) {
  vec3 sum = vec3(0.0);
  for (int c = 0; c < 3; ++c) {
    vec4 m = scatterMoment(p + scatterCell * normal, c);
    sum[c] = max(0.25 * m.w - 0.5 * dot(m.xyz, normal), 0.0);
  }
  return sum;
}
