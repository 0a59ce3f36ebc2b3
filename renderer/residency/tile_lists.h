#pragma once
// Which items touch each 16 x 16 tile of a picture or map, as offsets and indices in the scene table. No cap
// on either.
#include <span>
#include <vector>

#include "renderer/residency/scene_table.h"

namespace pileus::residency {

/// Pixels [min, max) an item may touch.
struct PixelBounds {
  ivec2 min{0}, max{0};
};

class TileLists {
 public:
  static constexpr int kTile = 16;
  /// bounds[i] belongs to item i, or i modulo `items` where that is given (an item may have several bounds
  /// that share no tile); lists keep the order of the bounds.
  void build(SceneTable& table, ivec2 size, std::span<const PixelBounds> bounds, int items = 0);
  /// Lists given one by one: tiles of a single row.
  void build(SceneTable& table, std::span<const std::vector<int>> lists);
  void bind(gl::Program& program) const { program.set("tileGrid", grid_); }
  int longest() const { return longest_; }  ///< items in the fullest tile

 private:
  ivec2 grid_{1};
  int longest_ = 0;
};

}  // namespace pileus::residency
