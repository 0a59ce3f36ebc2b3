#pragma once
// Bounds of sigma_t for free flights: of each brick of each grid that a pass looks at, and of each block of
// 4^3 bricks; twin of lib/majorants.glsl. Of the mean of the channels, through the instance's table of
// densities, over all positions at which a brick may be sampled, its aprons included. GL thread.
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/residency/brick_pool.h"
#include "renderer/volume/instance.h"

namespace pileus::residency {

/// Bricks of a block along an axis.
inline constexpr int kBlockBricks = 4;

/// Bounds [1/m] of level `level` of a grid: its bricks, x fastest, then its blocks. `scale`: all of them are
/// so many times as large (for tests).
std::vector<float> majorantsOf(const volume::Instance& instance, int level, double scale = 1);

class Majorants {
 public:
  /// Those of these instances, in this order, each at the finest level that is resident. Error (Gpu) where
  /// the driver has no buffer textures that long.
  Result<void> make(const volume::InstanceList& instances, const BrickPool& pool,
                    const gl::DeviceInfo& device, double scale = 1);
  void bind() const;

 private:
  gl::Buffer texels_{"majorants"};
};

}  // namespace pileus::residency
