#pragma once
// What one kind of map is measured by, for the table that prints it and the test that asserts it.
#include <span>

#include "renderer/shadow/deep_shadow_map.h"
#include "renderer/shadow/shadow_pass.h"

namespace pileus::cli {

/// A slanted box edge over another box, under a sun overhead.
struct SilhouetteScene {
  scene::Light light;
  volume::InstanceList volumes;
};
SilhouetteScene silhouetteScene();
/// Largest |dT| of a representation there, at 4000 points in the lower box. An edge is a step between
/// neighbouring texels, so the truth is the bilinear blend of the exact transmittances of the four texels.
Result<double> silhouetteError(const shadow::Gpu& gpu, const shadow::ShadowSpec& spec);

/// Intervals and cosines (or slabs), float, without weights and horizon unless `extras`.
shadow::ShadowSpec intervalSpec(int intervals, int coefficients, int resolution, bool extras,
                                shadow::Storage storage = shadow::Storage::Float);
/// A node budget that is never reached; bound 0: every step is kept.
shadow::ShadowSpec deepSpec(double bound, int resolution);

struct DeepMeasure {
  shadow::DeepStatistics statistics;
  double largest = 0;  ///< |T - T of the uncompressed map|
};
/// A deep map, compressed as the spec says, against `uncompressed` at given world points.
Result<DeepMeasure> measureDeep(const shadow::Gpu& gpu, const shadow::ShadowSpec& spec,
                                const shadow::ShadowMap& uncompressed, std::span<const vec4> at);

}  // namespace pileus::cli
