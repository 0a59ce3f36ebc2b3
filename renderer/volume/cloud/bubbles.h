#pragma once
// What clouds are textured with: round heads on a jittered lattice, and vectors that bend them. Pure
// functions of position and time, equal on every machine (see noise.h).
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer/base/math.h"

namespace pileus::volume {

/// Mean and standard deviation of bubbles() over space, at any phase (2 million samples).
inline constexpr float kBubbleMean = 0.467f, kBubbleDeviation = 0.337f;

/// Whole number below x, for |x| < 2^31. Without a call of the library.
inline int wholeBelow(float x) {
  const int i = static_cast<int>(x);
  return i - (x < static_cast<float>(i));
}

inline std::uint32_t cellHash(int x, int y, int z, std::uint32_t seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8DA6B343u +
                    static_cast<std::uint32_t>(y) * 0xD8163841u +
                    static_cast<std::uint32_t>(z) * 0xCB1AB31Fu + seed * 0x9E3779B9u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 13)) * 0x297A2D39u;
  return h ^ (h >> 16);
}

/// Heads of about one cell, round outside and sharp where they meet: 0 between them .. 1. Each swells and
/// shrinks once while `phase` grows by 1. Eight cells are exact: jitter and radius together end within one.
inline float bubbles(vec3 p, std::uint32_t seed, float phase) {
  const ivec3 cell(wholeBelow(p.x - 0.5f), wholeBelow(p.y - 0.5f), wholeBelow(p.z - 0.5f));
  const vec3 f = p - vec3(cell) - 0.5f;
  float highest = 0;
  for (int c = 0; c < 8; ++c) {
    const int ox = c & 1, oy = (c >> 1) & 1, oz = c >> 2;
    const std::uint32_t h = cellHash(cell.x + ox, cell.y + oy, cell.z + oz, seed);
    constexpr float kJitter = 0.6f / 255.0f;
    const float dx = f.x - static_cast<float>(ox) + 0.3f - kJitter * static_cast<float>(h & 255u);
    const float dy = f.y - static_cast<float>(oy) + 0.3f - kJitter * static_cast<float>((h >> 8) & 255u);
    const float dz = f.z - static_cast<float>(oz) + 0.3f - kJitter * static_cast<float>((h >> 16) & 255u);
    const float u = static_cast<float>(h >> 24) * (1.0f / 255.0f);
    float a = phase + 7.0f * u;
    a -= static_cast<float>(wholeBelow(a));
    const float r = (0.56f + 0.14f * u) * (0.86f + 0.56f * a * (1.0f - a));
    highest = std::max(highest, 1.0f - (dx * dx + dy * dy + dz * dz) / (r * r));
  }
  return std::sqrt(highest);
}

/// Three numbers in -1 .. 1 that change smoothly, by at most 3 per unit of length each.
inline vec3 vectorNoise(vec3 p, std::uint32_t seed) {
  const ivec3 cell(wholeBelow(p.x), wholeBelow(p.y), wholeBelow(p.z));
  const vec3 f = p - vec3(cell);
  const vec3 w = f * f * (3.0f - 2.0f * f);
  vec3 sum(0.0f);
  for (int c = 0; c < 8; ++c) {
    const int ox = c & 1, oy = (c >> 1) & 1, oz = c >> 2;
    const std::uint32_t h = cellHash(cell.x + ox, cell.y + oy, cell.z + oz, seed);
    const float weight = (ox ? w.x : 1.0f - w.x) * (oy ? w.y : 1.0f - w.y) * (oz ? w.z : 1.0f - w.z);
    sum += weight * (vec3(static_cast<float>(h & 1023u), static_cast<float>((h >> 10) & 1023u),
                          static_cast<float>(h >> 22)) *
                         (2.0f / 1023.0f) -
                     1.0f);
  }
  return sum;
}

/// Turns a position so that no two octaves have the same lattice.
inline vec3 turned(vec3 p) {
  return {0.36f * p.x + 0.48f * p.y - 0.80f * p.z, -0.80f * p.x + 0.60f * p.y,
          0.48f * p.x + 0.64f * p.y + 0.60f * p.z};
}

/// Smoothstep from a to b; a may lie above b.
inline float rise(float a, float b, float x) {
  const float t = std::clamp((x - a) / (b - a), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// Of x > 0, by Newton's steps.
inline float cubeRoot(float x) {
  const double a = double(x);
  double r = std::sqrt(std::sqrt(a));
  for (int i = 0; i < 24; ++i) r = (2.0 * r + a / (r * r)) / 3.0;
  return static_cast<float>(r);
}

/// How fast a bubble of that diameter [m] rises and turns over [m/s]: small ones live for seconds, large ones
/// for minutes.
inline float bubbleSpeed(float diameter) { return cubeRoot(diameter * (1.0f / 200.0f)); }

/// How much of an octave of that wavelength voxels of that edge carry: all from 3 voxels up, none below 1.5.
inline float carried(float wavelength, float voxel) { return rise(1.5f, 3.0f, wavelength / voxel); }

}  // namespace pileus::volume
