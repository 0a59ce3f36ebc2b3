#include "renderer/residency/tile_lists.h"

#include <algorithm>

namespace pileus::residency {

void TileLists::build(SceneTable& table, ivec2 size, std::span<const PixelBounds> bounds, int modulo) {
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
  table.set(SceneTable::Section::TileOffsets, std::span<const int>(offsets));
  table.set(SceneTable::Section::TileItems, std::span<const int>(items));
}

void TileLists::build(SceneTable& table, std::span<const std::vector<int>> lists) {
  grid_ = {std::max(int(lists.size()), 1), 1};
  longest_ = 0;
  std::vector<int> offsets{0}, items;
  for (const std::vector<int>& list : lists) {
    items.insert(items.end(), list.begin(), list.end());
    offsets.push_back(int(items.size()));
    longest_ = std::max(longest_, int(list.size()));
  }
  table.set(SceneTable::Section::TileOffsets, std::span<const int>(offsets));
  table.set(SceneTable::Section::TileItems, std::span<const int>(items));
}

}  // namespace pileus::residency
