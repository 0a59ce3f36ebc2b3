#pragma once
// A scalar grid as sparse bricks with mips: what importers and procedural bakes produce and what the GPU pool
// uploads. Immutable once shared. Voxel values sit at integer index coordinates, as in OpenVDB's samplers.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/hash.h"
#include "renderer/base/math.h"

namespace pileus::volume {

inline constexpr int kBrickSize = 16;  ///< voxels a brick owns along each axis
inline constexpr int kApron = 1;       ///< copies of its neighbours' voxels on every side
inline constexpr int kStoredSize = kBrickSize + 2 * kApron;
inline constexpr int kStoredVoxels = kStoredSize * kStoredSize * kStoredSize;
inline constexpr std::uint32_t kConstantBrick = 0xFFFFFFFFu;

/// Value of a stored byte b: offset + scale * b / 255. A constant brick (also an empty one) has no payload:
/// its value is `offset`. A brick answers for positions in [16 b, 16 b + 16) relative to the level's lattice,
/// so it may be constant only if its own voxels and those of the layer after them (the apron on the far
/// sides) are.
struct Brick {
  std::uint32_t payload = kConstantBrick;  ///< index of its kStoredVoxels bytes, over all levels
  float offset = 0, scale = 0;
  float minimum = 0, maximum = 0;  ///< over positions the brick answers for (own voxels and far apron)
};

/// Mip level l: voxel (i,j,k) is the mean of the 2x2x2 voxels 2i.. of level l-1. Level 0 position p is
/// position (p + 0.5) / 2^l - 0.5 of level l, both relative to the lattice origin.
struct Level {
  ivec3 bricks{0};           ///< lattice size; bricks outside are zero
  std::vector<Brick> table;  ///< x fastest
  const Brick& at(ivec3 b) const {
    return table[(std::size_t(b.z) * std::size_t(bricks.y) + std::size_t(b.y)) * std::size_t(bricks.x) +
                 std::size_t(b.x)];
  }
};

struct BrickGrid {
  std::string name;           ///< grid name in its file, or what baked it
  dmat4 worldFromIndex{1.0};  ///< of the source's index coordinates
  ivec3 origin{0};   ///< index coordinates of the lattice's voxel (0,0,0): one below the first active voxel
  Box3 indexBounds;  ///< index coordinates, where the trilinear value can be non-zero: active bounds +- 1;
                     ///< empty() = empty grid
  std::vector<Level> levels;  ///< level 0 first; at least one unless empty; the last one is a single brick or
                              ///< at most 4 along an axis
  std::shared_ptr<const std::byte>
      payload;  ///< payloadCount * kStoredVoxels bytes (heap or a mapped file; kept alive by this)
  std::uint32_t payloadCount = 0;
  double voxelSize = 1;            ///< metres: smallest edge of a voxel
  float minimum = 0, maximum = 0;  ///< over active voxels
  std::uint64_t activeVoxels = 0;
  Key content;  ///< of everything above: equal keys mean equal voxels

  bool empty() const { return levels.empty() || indexBounds.empty(); }
  std::span<const std::byte> bytes(const Brick& b) const {
    return {payload.get() + std::size_t(b.payload) * kStoredVoxels, kStoredVoxels};
  }
};

using GridPtr = std::shared_ptr<const BrickGrid>;

/// Dequantised voxel of level 0 at source index coordinates (0 outside the lattice).
float voxelAt(const BrickGrid& grid, ivec3 index);
/// Trilinear value of `level` at source index coordinates, as the GPU samples it (in double precision). 0
/// outside the lattice.
double sampleTrilinear(const BrickGrid& grid, const dvec3& index, int level = 0);

/// Collects voxels brick by brick and builds mips: the one way to make a BrickGrid. See brick_builder.h.

}  // namespace pileus::volume
