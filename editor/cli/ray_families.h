#pragma once
// Synthetic light rays with known media, pushed through the real GPU maps: what the error tables of
// docs/bench.md are measured on. A family of rays becomes one scene: a ray is one voxel column of its media
// and one map texel.
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "renderer/shadow/extinction_map.h"

namespace pileus::cli {

inline constexpr int kRaySamples = 4096;  ///< midpoint samples on [0,1]; one voxel each, one metre

/// A medium on one ray: the voxels first .. first + sigma.size() - 1, extinction [1/m]; their sum is its
/// optical depth.
struct RayMedium {
  int first = 0;
  std::vector<float> sigma;
};

struct RayFamily {
  std::string name;
  /// Media of the next ray, in order along it and apart from each other; their number is that of every ray of
  /// the family.
  std::function<std::vector<RayMedium>(std::mt19937_64& rng)> draw;
};

/// "one", "two", "three", "eight", "thin+thick": value noise inside fixed intervals; those of "eight" start
/// at random. Another name: no media, which makeRayScene refuses.
RayFamily rayFamily(const std::string& name);
/// "3 boxes on 10 %": random widths that fill a tenth of the ray, random gaps, optical depth `tau` in all.
RayFamily threeBoxes(double tau);

/// The family's rays as a scene. Where all rays share an interval it is one volume; where they differ each
/// ray has a volume of its own, so that bounding boxes cover exactly what is on the ray. Sun straight above,
/// [0,1] of a ray from y = 0 down to -kRaySamples.
struct RayScene {
  int rays = 0;
  volume::InstanceList volumes;
  scene::Light light;
  shadow::LightFrustum frustum;  ///< x in [0,1] is that of the family; a texel is a metre
  int resolution = 16;           ///< of its maps
  std::vector<ivec2> texels;     ///< of each ray
  std::vector<vec4> positions;   ///< every voxel inside the media, world; w is the ray
  std::vector<double>
      transmittance;  ///< there: of the same voxelised, dequantised medium, integrated exactly
};

/// Error (Arguments): an unknown family, no rays, media that do not fit the family's own rules.
Result<RayScene> makeRayScene(const RayFamily& family, int rays, std::uint64_t seed);

struct RayError {
  double mean = 0;    ///< |dT| in media, over all rays
  double p95Max = 0;  ///< 95th percentile over rays of each ray's largest |dT|
  double rms = 0;     ///< mean over rays of each ray's root mean square
};

/// Looks T up in a finished map of the scene's frustum at every position and compares.
Result<RayError> measure(const shadow::Gpu& gpu, const RayScene& scene, const scene::Light& light,
                         const std::shared_ptr<const shadow::ShadowMap>& map);
/// The same for an extinction map of the scene built on the GPU; `resolution` of both options is the scene's.
Result<RayError> measure(const shadow::Gpu& gpu, const RayScene& scene, const shadow::MetricOptions& metric,
                         const shadow::ExtinctionOptions& extinction);

}  // namespace pileus::cli
