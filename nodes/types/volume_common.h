#pragma once
// What the volume nodes share: uniform shapes, and curves over the values of what is linked.
#include <algorithm>
#include <optional>

#include "nodes/declare/describe.h"

namespace pileus::nodes {

struct VolumeOut {
  VolumeValue volume;
};

/// The density and the output of a uniform shape.
template <class In>
void describeUniform(Describe<In, VolumeOut>& d) {
  d.in("density", &In::density)
      .range(0, 1e6)
      .soft(0, 10)
      .help("Density inside; the medium's extinction multiplies it.");
  d.out("volume", &VolumeOut::volume).help("One volume with the default medium.");
}

inline VolumeOut uniform(volume::Shape shape, double density, const dvec3& center, const dvec3& size) {
  volume::Instance instance;
  instance.shape = shape;
  instance.density = density;
  instance.worldFromLocal = composeTransform(center, dvec3(0.0), size);
  return {{{instance}}};
}

/// A curve over the values of volumes: `In::data` beside `In::volume`.
struct DataCurve {
  double lowest = 0;
  double highest = 0;  ///< 0: the largest value there is
  Curve curve{{{0, 0}, {1, 1}}, CurveShape::Smooth};
};

/// The stretch of values that lies under a curve.
struct DataStretch {
  double lowest, highest;
  double most;  ///< the largest value of all that does not emit
};

/// `value`: what the volumes' values are called; `under`: what lies above them.
template <class In, class Out>
void describeStretch(Describe<In, Out>& d, const std::string& value, const std::string& under,
                     const std::string& right) {
  d.in("input_min", &In::data, &DataCurve::lowest)
      .range(0, 1e6)
      .soft(0, 10)
      .help("The " + value + " at the left of " + under + "; lower ones count as this.");
  d.in("input_max", &In::data, &DataCurve::highest)
      .range(0, 1e6)
      .soft(0, 10)
      .help("The " + value + " at " + right + " right; higher ones count as this. 0: the largest " + value +
            " of the volumes.");
}

template <class In, class Out>
void describeCurve(Describe<In, Out>& d, std::string value, std::string help) {
  d.in("curve", &In::data, &DataCurve::curve)
      .over("volume", "input_min", "input_max", std::move(value))
      .help(std::move(help));
}

/// Nothing where all is empty or emits; an error (Input) where the lowest is not below the highest.
inline Result<std::optional<DataStretch>> stretchOf(const DataCurve& data, const VolumeValue& volumes,
                                                    std::string_view value) {
  DataStretch s{data.lowest, data.highest, 0};
  for (const volume::Instance& i : volumes.items)
    if (!i.emission) s.most = std::max(s.most, volume::largestDensity(i));
  if (s.most <= 0) return std::optional<DataStretch>();
  if (!(data.highest > 0)) s.highest = s.most;
  if (s.lowest < s.highest) return std::optional(s);
  const std::string largest = fmt::format("the largest {}", value);
  return fail(Code::Input, "input_min: {} is not below {}, {}", formatNumber(s.lowest),
              formatNumber(s.highest), data.highest > 0 ? "input_max" : largest);
}

}  // namespace pileus::nodes
