#include "renderer/residency/tile_lists.h"

#include <algorithm>
#include <vector>

#include "renderer/shaders/shared/bindings.h"

namespace pileus::residency {

void TileLists::build(ivec2 size, std::span<const PixelBounds> bounds, int modulo) {
  grid_ = glm::max((size + kTile - 1) / kTile, ivec2(1));
  const auto each = [&](const PixelBounds& b, auto&& visit) {
    const ivec2 lo = glm::max(b.min, ivec2(0)), hi = glm::min(b.max, size);
    if (lo.x >= hi.x || lo.y >= hi.y) return;
    for (int y = lo.y / kTile; y <= (hi.y - 1) / kTile; ++y)
      for (int x = lo.x / kTile; x <= (hi.x - 1) / kTile; ++x) visit(std::size_t(y * grid_.x + x));
  };
  std::vector<int> offsets(std::size_t(grid_.x * grid_.y) + 1, 0);
  for (const PixelBounds& b : bounds) each(b, [&](std::size_t tile) { ++offsets[tile + 1]; });
  longest_ = *std::max_element(offsets.begin(), offsets.end());
  for (std::size_t i = 1; i < offsets.size(); ++i) offsets[i] += offsets[i - 1];
  std::vector<int> items(std::size_t(offsets.back())), at(offsets.begin(), offsets.end() - 1);
  for (std::size_t i = 0; i < bounds.size(); ++i)
    each(bounds[i],
         [&](std::size_t tile) { items[std::size_t(at[tile]++)] = modulo > 0 ? int(i) % modulo : int(i); });
  offsets_.assign(std::span<const int>(offsets));
  items_.assign(std::span<const int>(items));
}

void TileLists::bind(gl::Program& program) const {
  offsets_.bindTexels(UNIT_TILE_OFFSETS, GL_R32I);
  items_.bindTexels(UNIT_TILE_ITEMS, GL_R32I);
  program.set("tileGrid", grid_);
}

}  // namespace pileus::residency
