#pragma once
// C++ twin of lib/metric.glsl in double precision: the pseudometric u(x).
#include <span>

#include "renderer/shadow/representation.h"

namespace pileus::shadow {

/// Coefficient i of a box that covers [0, t] (exit minus enter gives a box).
double metricFace(Metric metric, int i, double t);
/// u at x. Interval: values are (a0, b0, a1, b1, ...), unused ones a = b = 1, each with its weight (none: 1); series: coefficients.
double metricU(Metric metric, std::span<const double> values, double x, std::span<const double> weights = {});

}  // namespace pileus::shadow
