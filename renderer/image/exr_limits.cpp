#include "renderer/image/exr_limits.h"

#include <OpenEXR/ImfHeader.h>

#include <mutex>

namespace pileus::image {

void limitHeaders() {
  static std::once_flag once;
  std::call_once(once, [] {
    Imf::Header::setMaxImageSize(kLongestSide, kLongestSide);
    Imf::Header::setMaxTileSize(kLongestTileSide, kLongestTileSide);
  });
}

std::int64_t largestRatio(Imf::Compression compression) {
  constexpr std::int64_t kDeflate = 1032;  // 258 bytes in two bits
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return 1;
    case Imf::RLE_COMPRESSION:
      return 64;  // runs of 128 bytes in two
    case Imf::ZIPS_COMPRESSION:
    case Imf::ZIP_COMPRESSION:
      return kDeflate;
    case Imf::PXR24_COMPRESSION:
      return kDeflate * 4 / 3;  // floats are cut to 24 bits first
    case Imf::PIZ_COMPRESSION:
      return 512;  // Huffman: runs of 255 halves in 9 bits or more
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
      return 11;  // 16 halves in 3 bytes
    default:
      // DWA: one coefficient of 64 for each half, and those deflated; floats become halves.
      return kDeflate * 64 * 2;
  }
}

}  // namespace pileus::image
