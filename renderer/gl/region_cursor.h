#pragma once
// Walks a picture or map in regions whose size follows the time they take, so that no dispatch holds the
// window for long. A region is a run of square tiles of one row, whole rows of tiles, or a strip of one tile.
// llvmpipe, which answers meanwhile, keeps to one size. A value; pure.
#include "renderer/base/math.h"
#include "renderer/gl/context.h"
#include "renderer/gl/pace.h"

namespace pileus::gl {

class RegionCursor {
 public:
  static constexpr int kTile = 64;       ///< edge [pixels]
  static constexpr int kStripRows = 8;   ///< the least of a tile: a row of work groups
  static constexpr int kMostTiles = 64;  ///< in one region
  static constexpr int kStrips = kTile / kStripRows;

  RegionCursor() = default;
  /// All `extent` pixels, the first one at `at` of a larger picture. Begins with one tile; with
  /// `softwareTiles`, and stays there, where the device is a CPU.
  RegionCursor(ivec2 extent, const DeviceInfo& device, int softwareTiles = 1, ivec2 at = ivec2(0))
      : size_(extent), at_(at) {
    pace_ = {kStrips, 1, kStrips * kMostTiles};
    if (device.software) pace_.now = pace_.least = pace_.most = kStrips * softwareTiles;
  }

  bool done() const { return next_ >= count(); }
  double fraction() const { return count() > 0 ? (next_ + double(strip_) / kStrips) / count() : 1; }
  ivec2 origin() const {
    return at_ + kTile * ivec2(next_ % grid().x, next_ / grid().x) + ivec2(0, strip_ * kStripRows);
  }
  ivec2 end() const {
    const ivec2 tiles = wholeTiles();
    const ivec2 wanted = tiles.x > 0 ? kTile * tiles : ivec2(kTile, kStripRows * strips());
    return glm::min(origin() + wanted, at_ + size_);
  }
  /// Behind the region, which took `ms` in its longest dispatch.
  void advance(double ms) {
    if (const ivec2 tiles = wholeTiles(); tiles.x > 0) {
      next_ += tiles.x * tiles.y;
    } else if (strip_ += strips(); strip_ >= kStrips || origin().y >= at_.y + size_.y) {
      strip_ = 0;
      ++next_;
    }
    pace_.took(ms);
  }
  /// From the first region, at the same pace.
  void restart() { next_ = strip_ = 0; }
  void finish() { next_ = count(), strip_ = 0; }

 private:
  ivec2 grid() const { return (size_ + kTile - 1) / kTile; }
  int count() const { return grid().x * grid().y; }
  int strips() const { return std::min(pace_.now, kStrips - strip_); }
  /// Of the region, across and down; 0 where it is a strip of one tile.
  ivec2 wholeTiles() const {
    const int tiles = pace_.now / kStrips;
    if (strip_ > 0 || tiles == 0) return ivec2(0);
    const int x = next_ % grid().x, left = grid().x - x;
    if (x > 0 || tiles < left) return {std::min(tiles, left), 1};
    return {left, std::min(tiles / left, grid().y - next_ / grid().x)};
  }

  ivec2 size_{0}, at_{0};
  int next_ = 0, strip_ = 0;  ///< first tile, and strip of it, that is still to come
  Pace pace_{1, 1, 1};
};

}  // namespace pileus::gl
