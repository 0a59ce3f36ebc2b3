#pragma once
// How wrong a finished shadow is, and what a lookup costs: lookupTransmittance on the GPU at points of known
// transmittance. GL thread.
#include <span>

#include "renderer/shadow/gpu.h"
#include "renderer/shadow/shadow_map.h"
#include "renderer/truth/shadow_samples.h"

namespace pileus::truth {

/// Of dT = T of the map - true T, over the points.
struct ShadowError {
  double mean = 0, p95 = 0, maximum = 0;  ///< of |dT|
  double bias = 0;                        ///< mean of dT: above 0 light leaks
};

/// Transmittance from the light to each position (world, relative to `origin`; w unused). At once, however
/// many they are.
Result<std::vector<float>> lookupTransmittance(const shadow::Gpu& gpu, const shadow::ShadowMap& map,
                                               std::span<const vec4> positions,
                                               const dvec3& origin = dvec3(0));

ShadowError shadowError(std::span<const float> mapped, std::span<const double> transmittance);

struct ProbeResult {
  ShadowError error;
  double nsPerLookup = 0;  ///< 0: not timed
};
/// Both. Timed: median of `dispatches` dispatches that take 20 ms each or more, waited for. Each group of
/// points is looked up over and over (llvmpipe takes the groups of a row in order), so that its texels are in
/// the caches, as they are for most of a picture's lookups: with one light ray after another at random it is
/// the machine's memory that would be timed.
Result<ProbeResult> probe(const shadow::Gpu& gpu, const shadow::ShadowMap& map, const ShadowSamples& samples,
                          int dispatches = 5);

}  // namespace pileus::truth
