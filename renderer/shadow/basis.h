#pragma once
// C++ twin of lib/basis.glsl in double precision. Equations: docs/physics.md.
#include <span>
#include <vector>

#include "renderer/shadow/representation.h"

namespace pileus::shadow {

/// Adds an optical depth m spread evenly over [u0, u1] to coefficients c.
void projectStep(Basis basis, std::span<double> c, double m, double u0, double u1);
/// Optical depth in front of u, clamped to [0, basisTotal].
double basisTau(Basis basis, std::span<const double> c, double u);
/// The projected function itself at u, not integrated.
double basisValue(Basis basis, std::span<const double> c, double u);
double basisTotal(Basis basis, std::span<const double> c);

/// Piecewise cosines over `count` intervals: adds m spread over [v0, v1] of interval j; optical depth in
/// front of v of interval j.
void projectPiece(std::span<double> c, double m, int count, int j, double v0, double v1);
double pieceTau(std::span<const double> c, int count, int j, double v);

}  // namespace pileus::shadow
