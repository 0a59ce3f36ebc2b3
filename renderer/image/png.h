#pragma once
// 8-bit PNG of a display-referred picture.
#include <filesystem>

#include "renderer/image/image.h"

namespace pileus::image {

/// `rgba`: size.y * size.x * 4 display-referred floats, clamped to [0,1] and rounded with an ordered dither
/// of one code value; alpha is dropped (the picture stands over black). Atomic. Error (Input) names the path.
Result<void> writePng(const std::filesystem::path& path, ivec2 size, const float* rgba);

}  // namespace pileus::image
