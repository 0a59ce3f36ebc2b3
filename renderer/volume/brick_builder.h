#pragma once
// The one way to make a BrickGrid: a source hands out blocks of float voxels, the builder quantises them to
// bricks, builds the mips and the content key. Never holds a dense copy of the grid: level 0 is streamed,
// only level 1 and above are kept as sparse floats.
#include <functional>
#include <optional>

#include "renderer/base/jobs.h"
#include "renderer/base/result.h"
#include "renderer/volume/brick_grid.h"

namespace pileus::volume {

/// What a source says about one block.
enum class Fill {
  Zero,      ///< all voxels are 0; `out` is not looked at
  Constant,  ///< all voxels equal out[0]
  Voxels,    ///< every entry of out is set
};

struct ActiveStats {
  std::uint64_t count = 0;
  float minimum = 0, maximum = 0;
};

struct VoxelSource {
  std::string name;
  dmat4 worldFromIndex{1.0};  ///< affine, not singular
  ivec3 activeMin{
      0};  ///< inclusive index bounds of the active voxels; what lies outside is 0, whatever the source says
  ivec3 activeMax{-1};  ///< activeMax < activeMin along any axis: an empty grid
  /// Voxels lo .. lo + kStoredSize - 1 (index coordinates), x fastest, kStoredVoxels of them. Called from
  /// many threads.
  std::function<Fill(ivec3 lo, float* out)> fill;
  /// Optional cheap test: false only if every voxel of the same block is 0. Spares the call of `fill`.
  std::function<bool(ivec3 lo)> touches;
  /// Statistics over active voxels; without, the builder counts the voxels that are not 0.
  std::optional<ActiveStats> stats;
};

struct BuildLimits {
  std::uint64_t latticeBricks = std::uint64_t(1) << 24;  ///< level 0, with the empty ones: 4096^3 voxels
  std::uint64_t payloadBytes = std::uint64_t(4) << 30;   ///< over all levels
  int extent = 65536;                                    ///< voxels along any axis
};

/// Bricks along each axis that level 0 of these active bounds takes (bounds not empty). Error (Input): beyond
/// the limits.
Result<ivec3> latticeSize(const std::string& name, ivec3 activeMin, ivec3 activeMax,
                          const BuildLimits& limits = {});

struct BuildResult {
  GridPtr grid;
  std::uint64_t nonFinite =
      0;  ///< voxels (each counted once) that were NaN, infinite or beyond +-1e37 and became 0
};

/// Quantises to nearest, so a voxel errs by at most half a quantum of its brick (scale / 510). A brick whose
/// smallest voxel is 0 keeps 0 exact. Progress goes from `from` to 1 of the control. Errors: Input (beyond
/// the limits, singular transform), Cancelled.
Result<BuildResult> buildBricks(const VoxelSource& source, JobControl& control, double from = 0,
                                const BuildLimits& limits = {});

/// An empty grid of that name: what a file without active voxels becomes.
GridPtr emptyGrid(std::string name, const dmat4& worldFromIndex = dmat4(1.0));

/// Key of everything in the grid but `content` itself.
Key contentKeyOf(const BrickGrid& grid);

}  // namespace pileus::volume
