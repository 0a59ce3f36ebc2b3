#pragma once
// The cheapest parameters of a shadow representation that keep a bound on this scene. In steps; GL thread.
#include <optional>

#include "renderer/truth/shadow_measure.h"

namespace pileus::truth {

/// What is bounded. The smallest bytes are sought under P95, the smallest error under the others.
enum class TuneBound { P95, Milliseconds, Mebibytes };
constexpr auto enumInfo(TuneBound*) {
  using B = TuneBound;
  return std::array{EnumItem<B>{B::P95, "p95", "95th percentile of |dT|",
                                "The least memory whose error stays below the bound, on the worst light."},
                    EnumItem<B>{B::Milliseconds, "ms", "Milliseconds",
                                "The least error whose maps are built, and looked up a million times, within "
                                "the bound; all lights together."},
                    EnumItem<B>{B::Mebibytes, "mib", "MiB",
                                "The least error whose maps fit into the bound; all lights together."}};
}

struct TuneGoal {
  TuneBound bound = TuneBound::P95;
  double limit = 0.02;
};

struct TuneOptions {
  SampleOptions points;
  int minResolution = 128, maxResolution = 2048;
};

/// Measured on every light.
struct TuneCandidate {
  shadow::ShadowSpec spec;
  std::size_t bytes = 0;                               ///< of all lights
  double p95 = 0, mean = 0;                            ///< |dT| of the worst light
  double buildMs = 0;                                  ///< of all lights
  double nsPerLookup = 0;                              ///< sum over lights, with their texels in the caches
  double ms() const { return buildMs + nsPerLookup; }  ///< build and a million lookups (1e6 ns = 1 ms)
};

bool meets(const TuneCandidate& candidate, const TuneGoal& goal);

/// Every choice tried for a representation like `like`: its kind, and for extinction maps whether there is a
/// pseudometric. Resolution is not among them.
std::vector<shadow::ShadowSpec> tuneConfigurations(const shadow::ShadowSpec& like, bool horizon);

class Tuner {
 public:
  /// Tunes one set of parameters for all of `casters`.
  Tuner(std::vector<Caster> casters, const shadow::ShadowSpec& like, const TuneGoal& goal,
        const TuneOptions& options = {});
  ~Tuner();
  /// Works for about `ms` milliseconds (see MeasurePass); a rough fraction done, 1 = finished. Error (Input)
  /// where there is nothing to tune: no light, no medium, a ray march. To stop: destroy it.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// In the order they were tried.
  const std::vector<TuneCandidate>& measured() const;
  /// Of measured(): those that none beats in both bytes and p95, by rising bytes.
  std::vector<TuneCandidate> curve() const;
  /// The best that meets the goal so far; none: it cannot be met.
  std::optional<TuneCandidate> best() const;
  /// What came nearest to the goal, whether it meets it or not; none before the first measurement.
  std::optional<TuneCandidate> nearest() const;
  std::string doing() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pileus::truth
