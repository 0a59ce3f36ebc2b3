#pragma once
// C++ twin of lib/metric.glsl in double precision: the pseudometric u(x).
#include <span>

#include "renderer/shadow/representation.h"

namespace pileus::shadow {

/// Coefficient i of a box that covers [0, t] (exit minus enter gives a box).
double metricFace(Metric metric, int i, double t);
/// u at x. Interval: values are (a0, b0, a1, b1, ...), unused ones a = b = 1, each with its weight (none: 1);
/// series: coefficients.
double metricU(Metric metric, std::span<const double> values, double x, std::span<const double> weights = {});

/// Twin of pieceOf: interval ends (a0, b0, ...); which interval x belongs to, where in it, and how many there
/// are.
struct Piece {
  int count = 1, index = 0;
  double v = 0;
};
Piece pieceOf(std::span<const double> ends, double x);

}  // namespace pileus::shadow
