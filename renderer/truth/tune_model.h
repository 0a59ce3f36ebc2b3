#pragma once
// What the tuner expects of parameters it has not tried yet. Plain values.
//
// Errors of independent causes add in squares: p95(c, r)^2 = A(c)^2 + (B / r)^2, with A from the coefficients
// and intervals and B / r from texels that stand for their surroundings. B is fitted to one accurate
// configuration at several resolutions, A to every configuration at one; a configuration never tried borrows
// from its neighbours.
#include <optional>
#include <vector>

#include "renderer/shadow/representation.h"

namespace pileus::truth {

struct TunePoint {
  shadow::ShadowSpec spec;
  double p95 = 0, buildMs = 0, nsPerLookup = 0, bytes = 0;
};

class TuneModel {
 public:
  /// Measurements of the accurate configuration at three resolutions or more.
  void fitResolution(const std::vector<TunePoint>& points);
  void add(const TunePoint& point);
  /// For the resolution in `spec`; nothing where it has no neighbour.
  std::optional<TunePoint> expect(const shadow::ShadowSpec& spec) const;

 private:
  struct Known {
    shadow::ShadowSpec spec;  ///< resolution 0
    double a2 = 0;
    double buildMs = 0, bytes = 0;  ///< of one texel
    double nsPerLookup = 0;
    int resolution = 0;  ///< where it was measured: the finest counts
  };
  std::optional<Known> known(const shadow::ShadowSpec& spec) const;
  std::optional<Known> find(const shadow::ShadowSpec& spec) const;
  double b2_ = 0;
  std::vector<Known> known_;
};

}  // namespace pileus::truth
