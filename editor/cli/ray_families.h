#pragma once
// Synthetic light rays with known media, pushed through the real GPU maps: what the error tables of docs/bench.md are measured on.
// A family of rays becomes one scene: ray i is voxel column i of one grid per medium, one map texel wide.
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/shadow/extinction_map.h"

namespace pileus::cli {

/// A medium on a ray: where it lies on [0,1] and the optical depth it adds.
struct RayInterval {
  double begin = 0, end = 1, tau = 1;
};

struct RayFamily {
  std::string name;
  std::vector<RayInterval> intervals;  ///< the same for all rays; the profiles differ
};

/// "one", "two", "three", "thin+thick": docs/bench.md states them.
RayFamily rayFamily(const std::string& name);

/// The family's rays as a scene: sun straight above, ray i at x = i.
struct RayScene {
  int rays = 0;
  volume::InstanceList volumes;
  scene::Light light;
  shadow::LightFrustum frustum;       ///< fitted to the boxes along the light; texel i is ray i
  int resolution = 256;
  std::vector<vec4> positions;        ///< every voxel inside the media, world
  std::vector<double> transmittance;  ///< there: of the same voxelised, dequantised medium, integrated exactly
};

Result<RayScene> makeRayScene(const RayFamily& family, int rays, std::uint64_t seed);

struct RayError {
  double mean = 0, p95Max = 0, rms = 0;  ///< |dT| in media over all; 95th percentile over rays of each ray's largest; mean of each ray's rms
};

/// Builds the map on the GPU, looks T up at every position and compares.
Result<RayError> measure(const shadow::Gpu& gpu, const RayScene& scene, const shadow::MetricOptions& metric, const shadow::ExtinctionOptions& extinction);

}  // namespace pileus::cli
