#pragma once
// Which items touch each 16 x 16 tile of a picture or map, as offsets and indices in shader storage. No cap
// on either.
#include <span>

#include "renderer/gl/buffer.h"
#include "renderer/gl/shader_library.h"

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
  void build(ivec2 size, std::span<const PixelBounds> bounds, int items = 0);
  void bind(gl::Program& program) const;
  int longest() const { return longest_; }  ///< items in the fullest tile

 private:
  ivec2 grid_{1};
  int longest_ = 0;
  gl::Buffer offsets_{"tile offsets"}, items_{"tile items"};
};

}  // namespace pileus::residency
