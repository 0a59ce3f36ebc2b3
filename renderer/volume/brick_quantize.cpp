#include "renderer/volume/brick_quantize.h"

#include <algorithm>
#include <cmath>

namespace pileus::volume {
namespace {

constexpr float kLargest = 1e37f;

std::size_t storedIndex(int x, int y, int z) {
  return (static_cast<std::size_t>(z) * kStoredSize + static_cast<std::size_t>(y)) * kStoredSize +
         static_cast<std::size_t>(x);
}

}  // namespace

std::uint32_t sanitize(float* block) {
  bool clean = true;
  for (int i = 0; i < kStoredVoxels; ++i) clean &= std::abs(block[i]) <= kLargest;
  if (clean) return 0;
  std::uint32_t own = 0;
  for (int z = 0; z < kStoredSize; ++z)
    for (int y = 0; y < kStoredSize; ++y)
      for (int x = 0; x < kStoredSize; ++x) {
        float& v = block[storedIndex(x, y, z)];
        if (std::abs(v) <= kLargest) continue;
        v = 0;
        if (x >= 1 && y >= 1 && z >= 1 && x <= kBrickSize && y <= kBrickSize && z <= kBrickSize) ++own;
      }
  return own;
}

Brick quantize(const float* block, const bool (&firstBrick)[3], std::byte* bytes) {
  // Constancy is decided by the voxels that the brick answers for; the range by all stored ones, so that the
  // near apron is right too.
  const int x0 = firstBrick[0] ? 0 : 1, y0 = firstBrick[1] ? 0 : 1, z0 = firstBrick[2] ? 0 : 1;
  const float first = block[storedIndex(x0, y0, z0)];
  bool constant = true;
  for (int z = z0; z < kStoredSize && constant; ++z)
    for (int y = y0; y < kStoredSize && constant; ++y)
      for (int x = x0; x < kStoredSize; ++x) constant &= block[storedIndex(x, y, z)] == first;
  Brick brick;
  if (constant) {
    brick.offset = brick.minimum = brick.maximum = first + 0.0f;  // + 0: never -0
    return brick;
  }
  const auto [lowest, highest] = std::minmax_element(block, block + kStoredVoxels);
  const float low = *lowest + 0.0f, high = *highest;
  brick.payload = 0;
  brick.offset = low;
  brick.scale = high - low;
  while (brick.offset + brick.scale > high)
    brick.scale = std::nextafter(brick.scale, 0.0f);  // never above the true maximum
  const double offset = static_cast<double>(low), scale = static_cast<double>(brick.scale);
  const double perStep = 255.0 / scale;
  for (int i = 0; i < kStoredVoxels; ++i) {
    const double q = (static_cast<double>(block[i]) - offset) * perStep + 0.5;
    bytes[i] = static_cast<std::byte>(static_cast<unsigned>(std::clamp(q, 0.0, 255.0)));
  }
  unsigned smallest = 255, largest = 0;
  for (int z = z0; z < kStoredSize; ++z)
    for (int y = y0; y < kStoredSize; ++y)
      for (int x = x0; x < kStoredSize; ++x) {
        const auto b = std::to_integer<unsigned>(bytes[storedIndex(x, y, z)]);
        smallest = std::min(smallest, b);
        largest = std::max(largest, b);
      }
  brick.minimum = static_cast<float>(offset + scale * smallest / 255.0);
  brick.maximum = static_cast<float>(offset + scale * largest / 255.0);
  return brick;
}

}  // namespace pileus::volume
