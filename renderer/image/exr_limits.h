#pragma once
// What an EXR file may claim before anything is allocated for it. Any thread.
#include <OpenEXR/ImfCompression.h>

#include <cstdint>

namespace pileus::image {

inline constexpr int kLongestSide = 1 << 20, kLongestTileSide = 1 << 14;

/// Makes the library refuse larger windows and tiles while it reads a header; before any file is opened.
void limitHeaders();
/// Bytes of pixels that one byte of a file can become at most.
std::int64_t largestRatio(Imf::Compression compression);

}  // namespace pileus::image
