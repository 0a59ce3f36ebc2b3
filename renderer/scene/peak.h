#pragma once
// What light that is scattered within the peaks of a phase function alone has of directions. With
// p = forward P + (1 - forward) p', p' linear in the cosine (scaledPhase()), P has moments 1, 1, chi_l/chi_2.
// Through peaks of optical depth t = albedo forward tau light comes by m of them with Poisson's weights, in
// the directions of P convolved m times with itself.
#include <vector>

#include "renderer/scene/phase.h"

namespace pileus::scene {

/// For 0 .. angles - 1 and 0 .. depths - 1, angles first:
///
///   forward/t exp(-t) SUM_m t^m/m! P^(*m)(cosine)   [1/sr]
///
/// so that one scattering along a way whose transmittance is scaled brings in all that and (1 - forward) p'.
/// At a = sqrt(sin(angle/2)) = i/(angles - 1), and t = kPeakDepth s/(1 - s), s = j/depths.
std::vector<float> scatteredPeaks(const Phase& p, int angles, int depths);
inline constexpr double kPeakDepth = 3;

}  // namespace pileus::scene
