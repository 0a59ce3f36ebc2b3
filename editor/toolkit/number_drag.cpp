#include "editor/toolkit/number_drag.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pileus::editor {
namespace {

/// 1, 2 or 5 times a power of ten, at most `x`.
double niceStep(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  const double digit = x / power;
  return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

double dragUnit(const NumberRange& r, double value) {
  if (r.hasSoft()) return r.softMax - r.softMin;
  return std::max(std::abs(value), 1.0) * 2;
}

bool inRatios(const NumberRange& r) { return r.logarithmic && r.hasSoft() && r.softMax > 0; }

/// Away with the noise of the arithmetic: what is shown is what is stored.
double clean(double value) {
  return value == 0 ? 0 : std::strtod(fmt::format("{:.9g}", value).c_str(), nullptr);
}

}  // namespace

std::string numberText(double value, bool integer) {
  if (integer) return fmt::format("{:.0f}", value);
  // Large numbers are written out; the exponent is for what has no other short form.
  std::string text = std::abs(value) >= 1e5 && std::abs(value) < 1e12 ? fmt::format("{:.12g}", value)
                                                                      : fmt::format("{:.6g}", value);
  return text == "-0" ? "0" : text;
}

double draggedValue(double raw, double pixels, double width, const NumberRange& r, bool fine) {
  const double t = pixels / std::max(width, 60.0) * (fine ? 0.1 : 1.0);
  if (inRatios(r)) {
    const double lo = r.softMin > 0 ? r.softMin : r.softMax * 1e-4;
    const double value = std::max(raw, lo) * std::pow(r.softMax / lo, t);
    // A logarithmic field whose range begins at zero reaches it at its lower end.
    return r.softMin <= 0 && value <= lo * 1.001 && t < 0 ? lo : value;
  }
  return raw + t * dragUnit(r, raw);
}

double tidiedValue(double raw, const NumberRange& r, bool fine, bool snap) {
  double value = raw;
  if (inRatios(r) && value > 0) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - (snap ? 0 : fine ? 3 : 2));
    value = std::round(value / step) * step;
    if (r.softMin <= 0 && raw <= r.softMax * 1e-4) value = 0;
  } else {
    double step = niceStep(dragUnit(r, raw) / (snap ? 20 : fine ? 5000 : 500));
    if (r.integer) step = std::max(1.0, std::round(step));
    value = std::round(value / step) * step;
  }
  const double lo = r.hasSoft() ? r.softMin : r.hardMin, hi = r.hasSoft() ? r.softMax : r.hardMax;
  value = std::clamp(value, lo, hi);
  return r.integer ? std::round(value) : clean(value);
}

double steppedValue(double value, int steps, const NumberRange& r, bool fine) {
  double next = 0;
  if (r.integer) {
    next = value + steps;
  } else if (inRatios(r)) {
    const double lo = r.softMin > 0 ? r.softMin : r.softMax * 1e-4;
    next = std::max(value, lo) * std::pow(fine ? 1.01 : 1.1, steps);
    next = std::strtod(fmt::format("{:.{}g}", next, fine ? 4 : 3).c_str(), nullptr);
    if (r.softMin <= 0 && value <= lo && steps < 0) next = 0;
  } else {
    const double step = niceStep(dragUnit(r, value) / (fine ? 500 : 50));
    next = (std::round(value / step) + steps) * step;
  }
  const double lo = r.hasSoft() ? std::min(r.softMin, value) : r.hardMin;
  const double hi = r.hasSoft() ? std::max(r.softMax, value) : r.hardMax;
  next = std::clamp(next, std::max(lo, r.hardMin), std::min(hi, r.hardMax));
  return r.integer ? std::round(next) : clean(next);
}

double softShare(double value, const NumberRange& r) {
  if (!r.hasSoft()) return 0;
  const bool ratios = r.logarithmic && r.softMin > 0;
  if (ratios && value <= 0) return 0;
  const double t = ratios ? std::log(value / r.softMin) / std::log(r.softMax / r.softMin)
                          : (value - r.softMin) / (r.softMax - r.softMin);
  return std::clamp(t, 0.0, 1.0);
}

FieldRows fieldRows(float height, float fontSize, float scale) {
  FieldRows rows;
  rows.text = std::round(0.5f * (height - fontSize));
  rows.barEnd = height;
  rows.barTop = height - std::max(std::min(std::round(3 * scale), height - rows.text - fontSize), 1.0f);
  return rows;
}

}  // namespace pileus::editor
