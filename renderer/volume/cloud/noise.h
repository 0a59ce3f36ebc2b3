#pragma once
// Integer-hash noise and random numbers, equal on every machine: only +, -, *, /, sqrt and floor, no library
// transcendental functions.
#include <cmath>
#include <cstdint>

#include "renderer/base/math.h"

namespace pileus::volume {

/// A well-mixed 32-bit hash of three coordinates and a seed.
inline std::uint32_t hash3(int x, int y, int z, std::uint32_t seed) {
  std::uint32_t h = seed * 0x9E3779B9u + static_cast<std::uint32_t>(x) * 0x85EBCA6Bu;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du + static_cast<std::uint32_t>(y) * 0xC2B2AE35u;
  h = (h ^ (h >> 13)) * 0x297A2D39u + static_cast<std::uint32_t>(z) * 0x27D4EB2Fu;
  h = (h ^ (h >> 16)) * 0x7FEB352Du;
  h = (h ^ (h >> 15)) * 0x846CA68Bu;
  return h ^ (h >> 16);
}

/// A sequence of uniform numbers in [0, 1).
class Random {
 public:
  explicit Random(std::uint32_t seed) : seed_(seed) {}
  float next() {
    return static_cast<float>(hash3(static_cast<int>(count_++), 17, 59, seed_) >> 8) * 0x1p-24f;
  }
  float between(float lo, float hi) { return lo + (hi - lo) * next(); }

 private:
  std::uint32_t seed_;
  std::uint32_t count_ = 0;
};

/// Squared distance to the nearest feature point of a jittered unit lattice; about 0 .. 1.2.
inline float worley(vec3 p, std::uint32_t seed) {
  const vec3 base = glm::floor(p);
  const ivec3 cell(base);
  const vec3 f = p - base;
  float nearest = 4.0f;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        // The nearest corner of that cell bounds what can be there.
        const vec3 o(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        const vec3 gap = glm::max(glm::max(o - f, f - o - 1.0f), vec3(0.0f));
        if (glm::dot(gap, gap) >= nearest) continue;
        const std::uint32_t h = hash3(cell.x + x, cell.y + y, cell.z + z, seed);
        const vec3 point = o +
                           vec3(static_cast<float>(h & 1023u), static_cast<float>((h >> 10) & 1023u),
                                static_cast<float>(h >> 22)) *
                               (1.0f / 1024.0f) -
                           f;
        nearest = std::min(nearest, glm::dot(point, point));
      }
  return nearest;
}

/// Gradient noise in about [-1, 1], mean 0, wavelength about 2.
inline float gradientNoise(vec3 p, std::uint32_t seed) {
  const vec3 base = glm::floor(p);
  const ivec3 cell(base);
  const vec3 f = p - base;
  const vec3 w = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
  float corners[8];
  for (int c = 0; c < 8; ++c) {
    const ivec3 o(c & 1, (c >> 1) & 1, c >> 2);
    const std::uint32_t h = hash3(cell.x + o.x, cell.y + o.y, cell.z + o.z, seed);
    const vec3 g = vec3(static_cast<float>(h & 1023u), static_cast<float>((h >> 10) & 1023u),
                        static_cast<float>(h >> 22)) *
                       (2.0f / 1023.0f) -
                   1.0f;
    corners[c] = glm::dot(g, f - vec3(o));
  }
  const auto mix = [](float a, float b, float t) { return a + (b - a) * t; };
  return mix(mix(mix(corners[0], corners[1], w.x), mix(corners[2], corners[3], w.x), w.y),
             mix(mix(corners[4], corners[5], w.x), mix(corners[6], corners[7], w.x), w.y), w.z);
}

inline float smoothstep01(float t) {
  t = t < 0 ? 0.0f : t > 1 ? 1.0f : t;
  return t * t * (3.0f - 2.0f * t);
}

/// Polynomial smooth minimum: equal to min where the two differ by more than k.
inline float smoothMin(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0f) / k;
  return std::min(a, b) - h * h * k * 0.25f;
}

}  // namespace pileus::volume
