#pragma once
// The directions in which the transport of light is followed.
#include <array>

#include "renderer/base/math.h"

namespace pileus::transport {

/// Those of an octant, side by side in the lanes of a vector; the other octants have the same with other
/// signs.
inline constexpr int kOrdinates = 4;

/// Four of an octant, 32 in all, of equal weight: (1, 1, 1)/sqrt(3) and the three (b, b, c), b so that
/// polynomials up to degree 5 are integrated exactly over the sphere.
struct Ordinates {
  std::array<dvec3, kOrdinates> direction;  ///< unit vectors of the octant (+, +, +)
  std::array<double, kOrdinates> weight;    ///< solid angles; pi/2 together
};
Ordinates ordinates();

}  // namespace pileus::transport
