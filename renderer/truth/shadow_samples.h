#pragma once
// Where shadows are judged: seeded points in the media along random light rays, with the exact transmittance
// there. Plain values; any thread.
#include <cstdint>
#include <vector>

#include "renderer/base/jobs.h"
#include "renderer/scene/light.h"
#include "renderer/volume/instance.h"

namespace pileus::truth {

struct ShadowSamples {
  dvec3 origin{0};                    ///< world, in metres: amid the media
  std::vector<vec4> positions;        ///< relative to that, so that they are exact far away too; w is 0
  std::vector<double> transmittance;  ///< exp(-tau) from the light, media only
};

struct SampleOptions {
  int count = 20000;  ///< points wanted
  int perRay = 8;     ///< points a light ray gets on average
  std::uint64_t seed = 1;
  double limitMs = 2000;  ///< where the exact answer is slow, fewer points are taken (at least 2,048)
};

/// Rays are uniform over the map of a sun (parallel, over its footprint on the media) and over directions for
/// a point or spot light (within its cone); points on them are uniform over the length where sigma_t > 0. The
/// truth is shadow::cumulativeOpticalDepth: regular tracking in double precision on all cores. Error (Input)
/// where no ray meets a medium; Error (Cancelled).
Result<ShadowSamples> sampleShadow(const scene::Light& light, const volume::InstanceList& volumes,
                                   const SampleOptions& options, JobControl& control);

}  // namespace pileus::truth
