#include "editor/graph_view/minimap.h"

#include <algorithm>
#include <optional>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/draw_frame.h"
#include "editor/graph_view/draw_node.h"
#include "editor/graph_view/graph_room.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

constexpr float kWidth = 188, kHeight = 118, kInset = 10, kButton = 24;

/// The map on the screen and how canvas units come to lie in it.
struct MapView {
  vec2 lo{0}, hi{0};
  vec2 origin{0};
  float scale = 1;
  vec2 screen(vec2 p) const { return origin + p * scale; }
  vec2 canvas(vec2 p) const { return (p - origin) / scale; }
  bool contains(vec2 p) const { return p.x >= lo.x && p.y >= lo.y && p.x < hi.x && p.y < hi.y; }
};

bool overlaps(vec2 a, vec2 b, vec2 c, vec2 d) { return a.x < d.x && c.x < b.x && a.y < d.y && c.y < b.y; }

bool coversSelected(const Session& session, const CanvasView& view, const Layout& layout, vec2 lo, vec2 hi) {
  const std::set<std::string>& names = session.document.selection();
  // Selected nodes come last. Of many, some may lie under it.
  if (names.empty() || names.size() > 8) return false;
  for (auto p = layout.nodes.rbegin(); p != layout.nodes.rend() && names.contains(p->name); ++p)
    if (overlaps(view.screen(p->min), view.screen(p->max), lo, hi)) return true;
  return false;
}

/// Everything there is, in canvas units.
bool extent(const Session& session, const Canvas& canvas, const Layout& layout, vec2& lo, vec2& hi) {
  bool any = bounds(layout, {}, lo, hi);
  for (const nodes::Frame& f : shownGraph(session, canvas).frames) {
    const vec2 a(f.at), b(f.at + f.size);
    lo = any ? glm::min(lo, a) : a, hi = any ? glm::max(hi, b) : b, any = true;
  }
  return any;
}

std::optional<MapView> mapView(const Theme& theme, const Session& session, const Settings& settings,
                               const Canvas& canvas, const CanvasView& view, const Layout& layout) {
  const vec2 panel = view.max - view.min, size(theme.px(kWidth), theme.px(kHeight));
  vec2 lo, hi;
  if (!settings.showMinimap || panel.x < 2.4f * size.x || panel.y < 2.1f * size.y ||
      !extent(session, canvas, layout, lo, hi))
    return std::nullopt;
  const vec2 seenLo = view.canvas(view.min), seenHi = view.canvas(view.max);
  if (!canvas.minimap.dragging && lo.x >= seenLo.x && lo.y >= seenLo.y && hi.x <= seenHi.x &&
      hi.y <= seenHi.y)
    return std::nullopt;
  MapView map;
  const float inset = theme.px(kInset);
  map.hi = view.max - vec2(inset);
  map.lo = map.hi - size;
  if (coversSelected(session, view, layout, map.lo, map.hi)) {
    map.lo = {view.min.x + inset, view.max.y - inset - size.y};
    map.hi = map.lo + size;
    if (coversSelected(session, view, layout, map.lo, map.hi)) return std::nullopt;
  }
  const vec2 room = size - vec2(theme.px(14)), all = glm::max(hi - lo, vec2(1));
  map.scale = std::min(room.x / all.x, room.y / all.y);
  map.origin = 0.5f * (map.lo + map.hi) - 0.5f * (lo + hi) * map.scale;
  return map;
}

struct ButtonRect {
  vec2 lo{0}, hi{0};
  bool contains(vec2 p) const { return p.x >= lo.x && p.y >= lo.y && p.x < hi.x && p.y < hi.y; }
};
ButtonRect buttonRect(const Theme& theme, const CanvasView& view, const std::optional<MapView>& map) {
  const float edge = theme.px(kButton);
  const vec2 hi =
      map ? vec2(map->hi.x - theme.px(2), map->lo.y + edge + theme.px(2)) : view.max - vec2(theme.px(kInset));
  return {hi - vec2(edge), hi};
}

bool bigEnough(const Theme& theme, const CanvasView& view) {
  const vec2 panel = view.max - view.min;
  return panel.x > theme.px(260) && panel.y > theme.px(120);
}

}  // namespace

bool updateMinimap(const Theme& theme, const Session& session, Settings& settings, Canvas& canvas,
                   const CanvasView& view, const Layout& layout, bool hovered) {
  Minimap& state = canvas.minimap;
  const vec2 pointer = vec(ImGui::GetIO().MousePos);
  const std::optional<MapView> map = mapView(theme, session, settings, canvas, view, layout);
  if (state.dragging) {
    if (!ImGui::IsMouseDown(0) || !map)
      state.dragging = false;
    else
      canvas.center = dvec2(map->canvas(pointer) + state.grip);
    return true;
  }
  const bool linkUnderWay = canvas.interaction.state == Interaction::State::DraggingLink;
  if (canvas.interaction.busy() && !linkUnderWay) return false;
  if (linkUnderWay) {  // a link can be carried across the graph: the view follows the pointer on the map
    if (!map || !map->contains(pointer)) return false;
    canvas.center = dvec2(map->canvas(pointer));
    return true;
  }
  if (!hovered) return false;
  if (bigEnough(theme, view) && buttonRect(theme, view, map).contains(pointer)) {
    if (ImGui::IsMouseClicked(0)) settings.showMinimap = !settings.showMinimap;
    return true;
  }
  if (!map || !map->contains(pointer)) return false;
  if (ImGui::IsMouseClicked(0)) {
    state.dragging = true;
    const vec2 at = map->canvas(pointer), lo = view.canvas(view.min), hi = view.canvas(view.max);
    const bool onView = at.x >= lo.x && at.y >= lo.y && at.x < hi.x && at.y < hi.y;
    state.grip = onView ? 0.5f * (lo + hi) - at : vec2(0);
    canvas.center = dvec2(at + state.grip);
  }
  return true;
}

void drawMinimap(Ui& ui, const Session& session, const Settings& settings, const Canvas& canvas,
                 const CanvasView& view, const Layout& layout) {
  const Theme& theme = ui.theme;
  if (!bigEnough(theme, view)) return;
  const vec2 pointer = vec(ImGui::GetIO().MousePos);
  ImDrawList* draw = view.draw;
  const std::optional<MapView> map = mapView(ui.theme, session, settings, canvas, view, layout);
  if (map) {
    draw->AddRectFilled(im(map->lo), im(map->hi), faded(palette::kPanel, 0.94f), theme.px(6));
    draw->PushClipRect(im(map->lo), im(map->hi), true);
    for (const nodes::Frame& f : shownGraph(session, canvas).frames)
      draw->AddRectFilled(im(map->screen(vec2(f.at))), im(map->screen(vec2(f.at + f.size))),
                          faded(frameTint(f), 0.35f), theme.px(2));
    const std::set<std::string>& selection = session.document.selection();
    for (const NodePlace& p : layout.nodes) {
      const vec2 lo = map->screen(p.min), hi = glm::max(map->screen(p.max), lo + vec2(2 * theme.scale));
      draw->AddRectFilled(
          im(lo), im(hi),
          selection.contains(p.name) ? palette::kSelect : mixed(nodeColorOf(p), palette::kHighlight, 0.12f),
          theme.scale);
    }
    const vec2 lo = map->screen(view.canvas(view.min)), hi = map->screen(view.canvas(view.max));
    draw->AddRectFilled(im(lo), im(hi), faded(palette::kHighlight, 0.06f));
    draw->AddRect(im(lo), im(hi), faded(palette::kHighlight, 0.55f), theme.px(2), 0, theme.scale);
    draw->PopClipRect();
    draw->AddRect(im(map->lo), im(map->hi), palette::kLine, theme.px(6), 0, theme.scale);
    ui.trace.rect("minimap", im(map->lo), im(map->hi));
    ui.trace.rect("minimap/view", im(lo), im(hi));
  }
  const ButtonRect button = buttonRect(theme, view, map);
  const bool over = button.contains(pointer) && canvas.overlays.covered;
  if (map && !over && !map->contains(pointer)) return;  // calm until the pointer comes near
  if (over || map)
    draw->AddRectFilled(im(button.lo), im(button.hi),
                        over ? palette::kButtonHover : faded(palette::kButton, 0.8f), theme.px(4));
  const char* icon = map ? icon::kTimes : icon::kCompress;
  const float width = textWidth(theme.small, icon);
  drawText(draw, theme.small,
           {0.5f * (button.lo.x + button.hi.x - width),
            0.5f * (button.lo.y + button.hi.y - theme.small->FontSize)},
           over ? palette::kTextStrong : faded(palette::kTextFaint, settings.showMinimap ? 0.9f : 0.6f), icon,
           1e3f);
  ui.trace.rect("minimap/button", im(button.lo), im(button.hi));
}

}  // namespace pileus::editor
