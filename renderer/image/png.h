#pragma once
// 8-bit PNG of a display-referred picture.
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/image/image.h"

namespace pileus::image {

/// `rgba`: size.y * size.x * 4 display-referred floats, clamped to [0,1] and rounded with an ordered dither
/// of one code value; alpha is dropped (the picture stands over black). Atomic. Error (Input) names the path.
Result<void> writePng(const std::filesystem::path& path, ivec2 size, const float* rgba);

/// The bytes of such a file.
Result<std::string> encodePng(ivec2 size, const float* rgba);

/// 8-bit RGBA pixels, top row first.
struct Bitmap {
  ivec2 size{0};
  std::vector<unsigned char> rgba;
};

/// Of a PNG file's bytes. Error (Input) where they are damaged or larger than 4096 on a side.
Result<Bitmap> decodePng(std::string_view file);

}  // namespace pileus::image
