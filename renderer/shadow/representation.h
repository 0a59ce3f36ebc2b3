#pragma once
// The choices of a shadow representation, and their C++ twins' parameters.
#include <array>

#include <string>

#include "renderer/base/enum_info.h"

namespace pileus::shadow {

/// Precision of stored maps.
enum class Storage { Float, Half };
constexpr auto enumInfo(Storage*) {
  return std::array{
      EnumItem<Storage>{Storage::Float, "float", "Float", "32-bit coefficients: exact to about 1e-6."},
      EnumItem<Storage>{Storage::Half, "half", "Half",
                        "16-bit coefficients and interval ends: half the memory, errors around 1e-3."}};
}

/// The pseudometric g (Gautron et al. 2011).
enum class Metric { Interval, Fourier, Cosine, None };
constexpr auto enumInfo(Metric*) {
  using M = Metric;
  return std::array{EnumItem<M>{M::Interval, "interval", "Interval",
                                "Exact covered intervals, merged to at most K: monotone, and exact while a "
                                "ray crosses no more than K media."},
                    EnumItem<M>{M::Fourier, "fourier", "Fourier",
                                "Truncated Fourier series of the coverage, from box faces drawn with "
                                "additive blending, as in the paper."},
                    EnumItem<M>{M::Cosine, "cosine", "Cosine",
                                "Truncated cosine series of the coverage: no wrap-around at the ends."},
                    EnumItem<M>{M::None, "none", "None (Euclidean)",
                                "Plain distance along the ray: what Fourier opacity maps use."}};
}

/// What a grid counts as covering.
enum class Coverage { Bricks, Boxes };
constexpr auto enumInfo(Coverage*) {
  using C = Coverage;
  return std::array{
      EnumItem<C>{C::Bricks, "bricks", "Occupied bricks",
                  "Runs of bricks that hold something: gaps inside one grid cost nothing either."},
      EnumItem<C>{C::Boxes, "boxes", "Bounding boxes", "The whole box of each volume, as in the paper."}};
}

/// The basis extinction is projected on, as a function of u = g / g(1).
enum class Basis { Cosine, Fourier, Slab, Piecewise };
constexpr auto enumInfo(Basis*) {
  using B = Basis;
  return std::array{
      EnumItem<B>{B::Cosine, "cosine", "Cosine", "Cosines over [0,1]: the default, lowest error."},
      EnumItem<B>{B::Fourier, "fourier", "Fourier",
                  "Periodic series a0, a1, b1, ...: a labelled baseline; wraps at the ends."},
      EnumItem<B>{B::Slab, "slab", "Linear slabs",
                  "Equal slabs of optical depth: no trigonometry, transmittance never rises."},
      EnumItem<B>{B::Piecewise, "piecewise", "Cosines per interval",
                  "Each interval of the metric has its own optical depth and its own cosines: exact behind "
                  "every medium, and thin media keep their detail before dense ones without weights. Needs "
                  "an interval metric, and a coefficient for each of its intervals; with another metric it "
                  "is the cosine basis."}};
}

/// How much of u an interval gets for its length.
enum class Weighting { None, Root };
constexpr auto enumInfo(Weighting*) {
  using W = Weighting;
  return std::array{EnumItem<W>{W::None, "none", "Even", "Every metre of medium counts alike."},
                    EnumItem<W>{W::Root, "root", "Root of extinction",
                                "Intervals count by the square root of their mean extinction: haze before a "
                                "dense core is kept apart from it. 4 bytes a texel more."}};
}

/// How a map is filled.
enum class Accumulation { Gather, Splat };
constexpr auto enumInfo(Accumulation*) {
  using A = Accumulation;
  return std::array{
      EnumItem<A>{A::Gather, "gather", "Gather",
                  "One thread a texel sums all volumes in registers: the same bits whatever their order."},
      EnumItem<A>{A::Splat, "splat", "Splat",
                  "Each volume is drawn on its own with additive blending, as in the paper; half maps are "
                  "rounded after each volume."}};
}

/// The horizon that errs least at optical depth 50, of 3.5 to 7 (docs/physics.md).
inline constexpr double kUsualHorizon = 5.5;

struct MetricOptions {
  Metric metric = Metric::Interval;
  int intervals = 4;      ///< Interval: 1..8
  int coefficients = 4;   ///< series: 2..16
  int resolution = 1024;  ///< texels along an edge
  Storage storage = Storage::Float;
  Coverage coverage = Coverage::Bricks;   ///< Interval only
  Weighting weighting = Weighting::None;  ///< Interval only
  double horizon = 0;    ///< Interval only: optical depth behind which the metric ends; 0 = none
  bool compact = false;  ///< Interval only: ends in 8 bits, rounded outwards, whatever `storage`
  bool operator==(const MetricOptions&) const = default;
};

struct ExtinctionOptions {
  Basis basis = Basis::Cosine;
  int coefficients = 8;  ///< 1..32
  int resolution = 1024;
  Storage storage = Storage::Float;
  Accumulation accumulation = Accumulation::Gather;
  bool damping = false;  ///< Lanczos sigma factors on the coefficients: softer bands, larger error
  bool operator==(const ExtinctionOptions&) const = default;
};

/// Everything that decides how one light's shadow is made and kept: one description for nodes, comparisons
/// and searches.
struct ShadowSpec {
  enum class Kind { Extinction, FourierOpacity, TransmittanceFunction, Deep, RayMarch };
  Kind kind = Kind::Extinction;
  MetricOptions metric;          ///< Extinction
  ExtinctionOptions extinction;  ///< Extinction
  // FourierOpacity, TransmittanceFunction
  int coefficients = 7;          ///< 1..31
  bool range = false;            ///< per-texel near and far: the basis spans the covered part only
  bool damping = false;          ///< FourierOpacity: Lanczos
  Basis basis = Basis::Fourier;  ///< TransmittanceFunction: Fourier or Cosine
  Storage storage = Storage::Half;
  // Deep
  double errorBound = 0.01;  ///< largest |dT| of the compression
  int nodeBudget = 64;       ///< vertices a texel may keep; a texel that needs more gets a larger bound
  int filter = 1;            ///< light rays along a texel's edge that are averaged before compression, 1..4
  int resolution = 1024;     ///< all but Extinction, which has its own
  double stepScale = 0.5;    ///< RayMarch: voxels
  bool operator==(const ShadowSpec&) const = default;
};

/// The same map at another resolution.
ShadowSpec withResolution(ShadowSpec spec, int resolution);
int resolutionOf(const ShadowSpec& spec);  ///< 0 for RayMarch
/// "interval K=4, 8 cosines, half": what tables and panels call it.
std::string describe(const ShadowSpec& spec);
/// Bytes a texel takes by layout; 0 where it depends on the scene (Deep) or nothing is stored.
std::size_t bytesPerTexel(const ShadowSpec& spec);

}  // namespace pileus::shadow
