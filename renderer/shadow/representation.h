#pragma once
// The choices of a shadow representation, and their C++ twins' parameters.
#include <array>

#include "renderer/base/enum_info.h"

namespace pileus::shadow {

/// The pseudometric g (Gautron et al. 2011).
enum class Metric { Interval, Fourier, Cosine, None };
constexpr auto enumInfo(Metric*) {
  using M = Metric;
  return std::array{
      EnumItem<M>{M::Interval, "interval", "Interval", "Exact covered intervals, merged to at most K: monotone, and exact while a ray crosses no more than K media."},
      EnumItem<M>{M::Fourier, "fourier", "Fourier", "Truncated Fourier series of the coverage, from box faces drawn with additive blending, as in the paper."},
      EnumItem<M>{M::Cosine, "cosine", "Cosine", "Truncated cosine series of the coverage: no wrap-around at the ends."},
      EnumItem<M>{M::None, "none", "None (Euclidean)", "Plain distance along the ray: what Fourier opacity maps use."}};
}

/// What a grid counts as covering.
enum class Coverage { Bricks, Boxes };
constexpr auto enumInfo(Coverage*) {
  using C = Coverage;
  return std::array{EnumItem<C>{C::Bricks, "bricks", "Occupied bricks", "Runs of bricks that hold something: gaps inside one grid cost nothing either."},
                    EnumItem<C>{C::Boxes, "boxes", "Bounding boxes", "The whole box of each volume, as in the paper."}};
}

/// The basis extinction is projected on, as a function of u = g / g(1).
enum class Basis { Cosine, Fourier, Slab };
constexpr auto enumInfo(Basis*) {
  using B = Basis;
  return std::array{EnumItem<B>{B::Cosine, "cosine", "Cosine", "Cosines over [0,1]: the default, lowest error."},
                    EnumItem<B>{B::Fourier, "fourier", "Fourier", "Periodic series a0, a1, b1, ...: a labelled baseline; wraps at the ends."},
                    EnumItem<B>{B::Slab, "slab", "Linear slabs", "Equal slabs of optical depth: no trigonometry, transmittance never rises."}};
}

}  // namespace pileus::shadow
