#pragma once
// The working space: linear ACEScg, AP1 primaries.
#include "renderer/base/math.h"

namespace pileus::scene {

/// Rows of the inverse primary matrix of S-2014-004.
inline dvec3 acescgFromXyz(const dvec3& xyz) {
  return {1.6410233797 * xyz.x - 0.3248032942 * xyz.y - 0.2364246952 * xyz.z,
          -0.6636628587 * xyz.x + 1.6153315917 * xyz.y + 0.0167563477 * xyz.z,
          0.0117218943 * xyz.x - 0.0082844420 * xyz.y + 0.9883948585 * xyz.z};
}

inline double acescgLuminance(const dvec3& rgb) {
  return glm::dot(rgb, dvec3(0.2722287168, 0.6740817658, 0.0536895174));
}

}  // namespace pileus::scene
