#pragma once
// The values of curve and ramp parameters, and what they are at a position 0 .. 1: plain values, pure
// functions.
#include <array>
#include <vector>

#include "renderer/base/enum_info.h"
#include "renderer/base/math.h"
#include "renderer/base/result.h"

namespace pileus::nodes {

inline constexpr std::size_t kMostPoints = 64;  ///< of a curve or ramp

enum class CurveShape { Linear, Smooth };
constexpr auto enumInfo(CurveShape*) {
  using T = CurveShape;
  return std::array{EnumItem<T>{T::Linear, "linear", "Linear", "Straight from point to point."},
                    EnumItem<T>{T::Smooth, "smooth", "Smooth",
                                "A cubic through all points that never goes beyond its neighbours."}};
}

/// y over x, both 0 .. 1; x rises from point to point. Before the first and behind the last it stays level.
struct Curve {
  std::vector<dvec2> points{{0, 0}, {1, 1}};
  CurveShape shape = CurveShape::Smooth;
  bool operator==(const Curve&) const = default;
};

enum class RampShape { Constant, Linear, Smooth };
constexpr auto enumInfo(RampShape*) {
  using T = RampShape;
  return std::array{EnumItem<T>{T::Constant, "constant", "Constant", "Each stop's colour up to the next."},
                    EnumItem<T>{T::Linear, "linear", "Linear", "Straight from stop to stop."},
                    EnumItem<T>{T::Smooth, "smooth", "Smooth", "Level at each stop."}};
}

struct RampStop {
  double at = 0;   ///< 0 .. 1
  dvec3 color{1};  ///< linear in the working space
  bool operator==(const RampStop&) const = default;
};

/// Colours over 0 .. 1; stops stand from left to right.
struct Ramp {
  std::vector<RampStop> stops{{0, dvec3(1)}, {1, dvec3(1)}};
  RampShape shape = RampShape::Linear;
  bool operator==(const Ramp&) const = default;
};

/// What is wrong, by the number of the point: "point 2: x = 1.5 is outside 0..1".
Result<void> checkCurve(const Curve& curve);
/// Channels within lo .. hi.
Result<void> checkRamp(const Ramp& ramp, double lo, double hi);

/// y at x; exactly a point's y at its x, and never outside those of the points around. Smooth is the monotone
/// cubic of Fritsch and Butland (1984).
double curveAt(const Curve& curve, double x);
dvec3 rampAt(const Ramp& ramp, double at);

/// y = x all along.
bool isIdentity(const Curve& curve);
/// White all along.
bool isWhite(const Ramp& ramp);

}  // namespace pileus::nodes
