#include "nodes/declare/curve.h"

#include <algorithm>
#include <cmath>

#include "nodes/declare/node_type.h"

namespace pileus::nodes {
namespace {

bool within(double v, double lo, double hi) { return v >= lo && v <= hi; }  // false for what is no number

Result<void> checkCount(std::size_t count, std::string_view what) {
  if (count >= 1 && count <= kMostPoints) return {};
  return fail(Code::Arguments, "{} {}s are not 1 to {}", count, what, kMostPoints);
}

/// The slope at point i >= 1 of the inner ones: 0 at an extreme, else the harmonic mean of its neighbours,
/// weighted by the lengths of the stretches.
double innerSlope(const std::vector<dvec2>& p, std::size_t i) {
  const double h0 = p[i].x - p[i - 1].x, h1 = p[i + 1].x - p[i].x;
  const double d0 = (p[i].y - p[i - 1].y) / h0, d1 = (p[i + 1].y - p[i].y) / h1;
  if (d0 * d1 <= 0) return 0;
  const double w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// At an end, from the two stretches beside it: a parabola's slope, held to what keeps the stretch monotone.
double endSlope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  return std::abs(slope) > 3 * std::abs(d0) ? 3 * d0 : slope;
}

double slopeAt(const std::vector<dvec2>& p, std::size_t i) {
  const std::size_t last = p.size() - 1;
  const auto h = [&](std::size_t k) { return p[k + 1].x - p[k].x; };
  const auto d = [&](std::size_t k) { return (p[k + 1].y - p[k].y) / h(k); };
  if (last == 1) return d(0);
  if (i == 0) return endSlope(h(0), h(1), d(0), d(1));
  if (i == last) return endSlope(h(last - 1), h(last - 2), d(last - 1), d(last - 2));
  return innerSlope(p, i);
}

}  // namespace

Result<void> checkCurve(const Curve& curve) {
  PILEUS_CHECK(checkCount(curve.points.size(), "point"));
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const dvec2& p = curve.points[i];
    for (int axis = 0; axis < 2; ++axis)
      if (!within(p[axis], 0, 1))
        return fail(Code::Arguments, "point {}: {} = {} is outside 0..1", i + 1, "xy"[axis],
                    formatNumber(p[axis]));
    if (i > 0 && !(p.x > curve.points[i - 1].x))
      return fail(Code::Arguments, "point {}: x = {} is not above {}, that of the point before", i + 1,
                  formatNumber(p.x), formatNumber(curve.points[i - 1].x));
  }
  return {};
}

Result<void> checkRamp(const Ramp& ramp, double lo, double hi) {
  PILEUS_CHECK(checkCount(ramp.stops.size(), "stop"));
  for (std::size_t i = 0; i < ramp.stops.size(); ++i) {
    const RampStop& s = ramp.stops[i];
    if (!within(s.at, 0, 1))
      return fail(Code::Arguments, "stop {}: position {} is outside 0..1", i + 1, formatNumber(s.at));
    if (i > 0 && s.at < ramp.stops[i - 1].at)
      return fail(Code::Arguments, "stop {}: position {} lies before {}, that of the stop before", i + 1,
                  formatNumber(s.at), formatNumber(ramp.stops[i - 1].at));
    for (int c = 0; c < 3; ++c)
      if (!within(s.color[c], lo, hi))
        return fail(Code::Arguments, "stop {}: {} = {} is outside {}..{}", i + 1, "rgb"[c],
                    formatNumber(s.color[c]), formatNumber(lo), formatNumber(hi));
  }
  return {};
}

double curveAt(const Curve& curve, double x) {
  const std::vector<dvec2>& p = curve.points;
  if (p.empty()) return x;
  if (!(x > p.front().x)) return p.front().y;
  if (x >= p.back().x) return p.back().y;
  const auto next = std::upper_bound(p.begin(), p.end(), x, [](double v, const dvec2& q) { return v < q.x; });
  const auto i = static_cast<std::size_t>(next - p.begin()) - 1;
  const dvec2 a = p[i], b = p[i + 1];
  const double h = b.x - a.x, t = (x - a.x) / h;
  double y = a.y + t * (b.y - a.y);
  if (curve.shape == CurveShape::Smooth) {
    // Hermite: the straight line, and what the slopes at both ends differ from it.
    const double d = (b.y - a.y) / h, from = slopeAt(p, i) - d, to = slopeAt(p, i + 1) - d;
    y += h * t * (1 - t) * ((1 - t) * from - t * to);
  }
  return std::clamp(y, std::min(a.y, b.y), std::max(a.y, b.y));  // against rounding
}

dvec3 rampAt(const Ramp& ramp, double at) {
  const std::vector<RampStop>& s = ramp.stops;
  if (s.empty()) return dvec3(1);
  const auto next =
      std::upper_bound(s.begin(), s.end(), at, [](double v, const RampStop& q) { return v < q.at; });
  if (next == s.begin()) return s.front().color;
  const RampStop& a = *(next - 1);
  if (next == s.end() || ramp.shape == RampShape::Constant) return a.color;
  double t = (at - a.at) / (next->at - a.at);
  if (ramp.shape == RampShape::Smooth) t = t * t * (3 - 2 * t);
  return a.color + t * (next->color - a.color);
}

bool isIdentity(const Curve& curve) {
  const auto& p = curve.points;
  return !p.empty() && p.front() == dvec2(0) && p.back() == dvec2(1) &&
         std::all_of(p.begin(), p.end(), [](const dvec2& q) { return q.x == q.y; });
}

bool isWhite(const Ramp& ramp) {
  return std::all_of(ramp.stops.begin(), ramp.stops.end(),
                     [](const RampStop& s) { return s.color == dvec3(1); });
}

}  // namespace pileus::nodes
