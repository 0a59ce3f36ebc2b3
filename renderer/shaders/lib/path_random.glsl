// Independent numbers for paths: a hash of pixel, sample and a counter. So a sample is the same wherever and
// in however many dispatches it is traced.
#pragma once
#include "lib/random.glsl"

uvec2 pathSeed = uvec2(0u);  // pixel, sample
uint pathDraws = 0u;

void seedPath(ivec2 pixel, int s) {
  pathSeed = uvec2(uint(pixel.x) | uint(pixel.y) << 16u, uint(s));
  pathDraws = 0u;
}

// In [0, 1).
vec3 random3() {
  uvec3 h = pcg3d(uvec3(pathSeed, pathDraws));
  ++pathDraws;
  return vec3(h >> 8u) / 16777216.0;
}

// Exponentially distributed, mean 1.
float exponential(float u) { return -log(1.0 - u); }

// Two unit vectors that are at right angles to n and each other (Duff et al. 2017).
void frameOf(vec3 n, out vec3 a, out vec3 b) {
  float s = n.z >= 0.0 ? 1.0 : -1.0, f = -1.0 / (s + n.z), g = n.x * n.y * f;
  a = vec3(1.0 + s * n.x * n.x * f, s * g, -s * n.x);
  b = vec3(g, s + n.y * n.y * f, -n.y);
}

vec3 directionAround(vec3 axis, float cosine, float turn) {
  vec3 a, b;
  frameOf(axis, a, b);
  float sine = sqrt(max(0.0, 1.0 - cosine * cosine)), phi = 6.28318530717959 * turn;
  return normalize(cosine * axis + sine * (cos(phi) * a + sin(phi) * b));
}
