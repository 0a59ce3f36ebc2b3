#include "editor/viewport/brick_overlay.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "editor/picture/shown.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kMostBricks = 1500;

/// The edges of the bricks of one level that hold anything, each once, in source index coordinates.
struct Edges {
  int level = 0;
  std::size_t bricks = 0;
  std::vector<std::pair<dvec3, dvec3>> lines;
};

Edges edgesOf(const volume::BrickGrid& grid) {
  Edges out;
  const int levels = static_cast<int>(grid.levels.size());
  for (int l = 0; l < levels; ++l) {
    const volume::Level& level = grid.levels[static_cast<std::size_t>(l)];
    const auto filled = static_cast<std::size_t>(std::count_if(
        level.table.begin(), level.table.end(), [](const volume::Brick& b) { return b.maximum > 0; }));
    out.level = l, out.bricks = filled;
    if (filled <= kMostBricks) break;
  }
  const volume::Level& level = grid.levels[static_cast<std::size_t>(out.level)];
  const double size = volume::kBrickSize * double(1 << out.level);
  // Edges by the lattice point they begin at and their axis: neighbours share them.
  std::set<std::tuple<int, int, int, int>> seen;
  ivec3 b;
  for (b.z = 0; b.z < level.bricks.z; ++b.z)
    for (b.y = 0; b.y < level.bricks.y; ++b.y)
      for (b.x = 0; b.x < level.bricks.x; ++b.x) {
        if (!(level.at(b).maximum > 0)) continue;
        for (int axis = 0; axis < 3; ++axis)
          for (int corner = 0; corner < 4; ++corner) {
            ivec3 at = b;
            at[(axis + 1) % 3] += corner & 1;
            at[(axis + 2) % 3] += corner >> 1;
            if (!seen.emplace(at.x, at.y, at.z, axis).second) continue;
            const dvec3 from = dvec3(grid.origin) - 0.5 + size * dvec3(at);
            dvec3 to = from;
            to[axis] += size;
            out.lines.emplace_back(from, to);
          }
      }
  return out;
}

/// Kept while the grid is the same.
const Edges& cachedEdges(const volume::GridPtr& grid) {
  static std::map<Key, Edges> cache;
  if (cache.size() > 64) cache.clear();
  const auto it = cache.find(grid->content);
  return it != cache.end() ? it->second : cache.emplace(grid->content, edgesOf(*grid)).first->second;
}

ImU32 levelColor(int level) {
  const ImU32 colors[] = {palette::kSeries0, palette::kSeries1, palette::kSeries2,
                          palette::kSeries3, palette::kSeries4, palette::kSeries5};
  return colors[std::min(level, 5)];
}

}  // namespace

void drawBricks(Ui& ui, const Shown& shown, const Projection& view) {
  const Theme& theme = ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImDrawListFlags flags = draw->Flags;
  draw->Flags &= ~ImDrawListFlags_AntiAliasedLines;  // thousands of lines: fast before smooth
  float y = view.max().y - theme.space(3) - theme.small->FontSize;
  std::string noted;
  for (const PlacedVolume& v : shown.scene.volumes) {
    const volume::GridPtr& grid = v.instance.grid;
    if (v.instance.shape != volume::Shape::Grid || !grid || grid->empty()) continue;
    const Edges& edges = cachedEdges(grid);
    const residency::ResidentGrid* place = shown.renderer.bricks().find(*grid);
    const bool resident = place && edges.level >= place->finest;
    const ImU32 ink = faded(levelColor(edges.level), resident ? 0.55f : 0.2f);
    const dmat4& m = v.instance.worldFromLocal;
    for (const auto& [a, b] : edges.lines)
      if (const auto s = view.segment(dvec3(m * dvec4(a, 1)), dvec3(m * dvec4(b, 1))))
        draw->AddLine(im(s->first), im(s->second), ink, 1);
    const std::string finest = !place               ? "not on the GPU"
                               : place->finest == 0 ? "resident"
                                                    : fmt::format("resident from level {}", place->finest);
    const std::string text =
        fmt::format("{}: {} bricks of level {} of {}, {}", v.chain.empty() ? "" : v.chain.back(),
                    edges.bricks, edges.level, grid->levels.size() - 1, finest);
    noted += text + "\n";
    if (y > view.min().y + theme.px(60)) {
      const float width = textWidth(theme.small, text), x = view.max().x - theme.space(5) - width;
      draw->AddRectFilled({x - theme.space(2), y - theme.px(3)},
                          {view.max().x - theme.space(3), y + theme.small->FontSize + theme.px(3)},
                          palette::kChip, theme.px(4));
      drawText(draw, theme.small, {x, y}, resident ? palette::kText : palette::kTextDim, text, width + 2);
      y -= theme.small->FontSize + theme.px(8);
    }
  }
  if (ui.trace.on() && !noted.empty()) ui.trace.note("overlay bricks", noted);
  draw->Flags = flags;
}

}  // namespace pileus::editor
