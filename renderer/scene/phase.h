#pragma once
// How a medium spreads what it scatters over directions. Every phase function here is one of Draine's lobes
// or a blend of two:
//
//   p(c) = (1 - g^2)/(4 pi (1 + g^2 - 2 g c)^(3/2)) (1 + a c^2)/(1 + a (1 + 2 g^2)/3)   [1/sr]
//
// with c the cosine between the directions of travel before and after, 1 forward (Draine 2003). a = 0 is
// Henyey and Greenstein 1941, g = 0 with a = 1 Rayleigh. GLSL twin: lib/phase.glsl.
#include <vector>

#include "renderer/base/math.h"

namespace pileus::scene {

/// Sharper lobes than this are not told apart from it.
inline constexpr double kSharpestPhase = 0.9999;

struct PhaseLobe {
  double g = 0;      ///< -kSharpestPhase .. kSharpestPhase
  double alpha = 0;  ///< >= 0

  bool operator==(const PhaseLobe&) const = default;
};

struct Phase {
  PhaseLobe first, second;
  double blend = 0;  ///< share of the second one, 0 .. 1

  bool operator==(const Phase&) const = default;
  /// A single lobe of Henyey and Greenstein.
  bool simple() const { return blend == 0 && first.alpha == 0; }
};

/// g is clamped to kSharpestPhase, here and below.
Phase henyeyGreenstein(double g);
Phase doubleHenyeyGreenstein(double forward, double back, double blend);
Phase rayleigh();
Phase draine(double g, double alpha);
/// Droplets of water in air, `diameter` in micrometres, 0 .. 50: a lobe of Henyey and Greenstein and one of
/// Draine, fitted to Mie's solution by Jendersie and d'Eon 2023.
Phase droplets(double diameter);
inline constexpr double kLargestDroplet = 50;  ///< of the fit [micrometres]

/// [1/sr]; also the probability density of sampleCosine(), over directions.
double phaseValue(const Phase& p, double cosine);
double meanCosine(const Phase& p);
/// Integrals of p P_l over all directions, l = 0 .. count - 1. The first is 1, the second the mean cosine.
std::vector<double> legendreMoments(const Phase& p, int count);

/// A phase function whose forward peak counts as light that goes straight on: the share `forward` of it does
/// (the second moment: Joseph, Wiscombe and Weinman 1976, for two terms), the rest has mean cosine `cosine`.
/// None does where that would leave less than nothing ahead: where light is scattered back. Extinction is
/// then (1 - albedo forward) sigma_t, scattering (1 - forward) sigma_s.
struct ScaledPhase {
  double forward = 0, cosine = 0;
};
ScaledPhase scaledPhase(const Phase& p);

/// Exactly distributed as p. `random` gives independent numbers in [0, 1): three at least, and two more for
/// each cosine that is turned down, less than twice on average.
template <class Random>
double sampleCosine(const Phase& p, Random&& random);

/// The cosine behind which lies the share u of Henyey and Greenstein's lobe.
double henyeyGreensteinCosine(double g, double u);

template <class Random>
double sampleCosine(const Phase& p, Random&& random) {
  const PhaseLobe& lobe = random() < p.blend ? p.second : p.first;
  for (;;) {
    const double c = henyeyGreensteinCosine(lobe.g, random());
    if (random() * (1 + lobe.alpha) <= 1 + lobe.alpha * c * c) return c;
  }
}

}  // namespace pileus::scene
