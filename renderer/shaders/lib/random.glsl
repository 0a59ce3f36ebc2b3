// Sampling patterns. They depend on (pixel, sample index) alone, so a picture converges to the same bits
// wherever it is rendered.
#pragma once

// PCG hash of three words (Jarzynski and Olano 2020).
uvec3 pcg3d(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

vec3 hash3(ivec2 pixel, int stream) {
  return vec3(pcg3d(uvec3(uvec2(pixel), uint(stream))) >> 8u) / 16777216.0;
}

float radicalInverse2(uint i) { return float(bitfieldReverse(i) >> 8u) / 16777216.0; }

// xy: position in the pixel, z: offset of the march, all in [0,1). One sample: the centre. More: each
// stratified over the samples and rotated by a hash of the pixel.
vec3 pixelSample(ivec2 pixel, int s, int samples) {
  if (samples == 1) return vec3(0.5);
  vec3 h = hash3(pixel, 7);
  return fract(h +
               vec3((float(s) + 0.5) / float(samples), radicalInverse2(uint(s)), float(s) * 0.61803398875));
}
