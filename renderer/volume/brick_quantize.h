#pragma once
// Float block to 8-bit brick and back: the arithmetic of the builder, apart so that it is tested alone.
#include <span>

#include "renderer/volume/brick_grid.h"

namespace pileus::volume {

/// Replaces non-finite voxels (and those beyond +-1e37, whose range would overflow) by 0.
/// Returns how many of the brick's own voxels that were.
std::uint32_t sanitize(float* block);

/// Range and bytes of a block of kStoredVoxels floats. `firstBrick[a]`: the brick is the first along that
/// axis, so it also answers for its near apron there. Writes kStoredVoxels bytes to `bytes` unless the brick
/// is constant. The payload index is 0 or kConstantBrick.
Brick quantize(const float* block, const bool (&firstBrick)[3], std::byte* bytes);

}  // namespace pileus::volume
