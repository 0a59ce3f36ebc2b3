#pragma once
// An environment as a few suns, others for each sample: strata of equal energy, one direction from each. The
// mean over the samples converges to the integral over the map. Immutable; any thread.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/scene/light.h"

namespace pileus::scene {

/// How many parts of equal energy each stratum has, and each part again: as many sets of lights hold the
/// whole map.
inline constexpr int kStratumParts = 16;

/// A part of the sphere: columns x0 .. x1 and rows y0 .. y1 of the map, within texels too; inside a row y
/// goes evenly with the sine of the elevation, so that equal parts are equal solid angles.
struct Stratum {
  dvec2 low{0}, high{0};
  dvec3 flux{0};      ///< integral of radiance [W/m^2]
  double energy = 0;  ///< the same of environmentImportance()
  dvec3 mean{0};      ///< unit vector: its middle by importance
  double narrow = 1;  ///< length of the mean of the directions, by importance: 1 for a point, 0 for a sphere
};

struct StratumSample {
  dvec3 direction{0, 1, 0};
  vec3 radiance{0};
  double pdf = 0;  ///< [1/sr], of this stratum's directions
};

class EnvironmentStrata {
 public:
  /// `map` is brought to kSize first. A black one has none.
  explicit EnvironmentStrata(const EnvironmentMap& map, int count = 16);

  static constexpr ivec2 kSize{512, 256};  ///< what larger maps are reduced to
  const std::vector<Stratum>& strata() const { return strata_; }
  /// Part 0 .. kStratumParts - 1 of a stratum or of a part, in the order in which it is halved again and
  /// again.
  Stratum part(const Stratum& whole, unsigned number) const;
  /// For even a and b in [0, 1): directions of one of the above in proportion to importance, exactly.
  StratumSample sample(const Stratum& stratum, double a, double b) const;

 private:
  using Sums = std::vector<double>;  // over all texels above and to the left, (width + 1) (height + 1)
  double within(const Sums& sums, const dvec2& low, const dvec2& high) const;
  double spread(const dvec2& low, const dvec2& high) const;
  dvec2 cut(const dvec2& low, const dvec2& high, int axis, double share) const;
  void divide(const dvec2& low, const dvec2& high, int count);
  std::array<Stratum, 2> halves(const dvec2& low, const dvec2& high, double share) const;
  Stratum measured(const dvec2& low, const dvec2& high) const;

  EnvironmentMap map_;
  Sums energy_, flux_[3], toward_[3];
  std::vector<Stratum> strata_;
};

/// A direction of light that stands for others beside it.
struct EnvironmentLight {
  dvec3 towards{0, 1, 0};  ///< in the frame of the map
  vec3 irradiance{0};      ///< at normal incidence [W/m^2]
  /// Mean cosine of what the direction stands for: a lobe of mean cosine g is seen as one of g x narrow (the
  /// moments of two lobes of Henyey and Greenstein multiply), and nothing glints.
  double narrow = 1;
};

/// One light for each stratum, its middle: the best there is for a picture of one sample, and for drafts.
std::vector<EnvironmentLight> draftLights(const EnvironmentStrata& strata);

/// One light for each stratum, from the number of the set alone. The first kStratumParts sets are the middles
/// of the parts, one of each stratum, with exact flux and width, in an order that spreads any number of first
/// ones; the next kStratumParts^2 those of the parts' parts. What follows are directions inside these, which
/// stand for ever less beside them: the mean over the sets converges to the integral over the map.
std::vector<EnvironmentLight> environmentLights(const EnvironmentStrata& strata, unsigned set);

/// Its own, or new ones.
std::shared_ptr<const EnvironmentStrata> strataOf(const Environment& environment);

/// An environment as suns in the world: those of a set, or without one the middles.
std::vector<Light> standIns(const Environment& environment, const EnvironmentStrata& strata,
                            std::optional<unsigned> set);
/// Of the middles the one nearest to where most of the light comes from: whoever measures one map for an
/// environment takes that. A black sun for a black environment.
Light mainSun(const Environment& environment);

}  // namespace pileus::scene
