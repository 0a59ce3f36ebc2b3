#include "editor/app/panel_areas.h"

#include <algorithm>
#include <cmath>

namespace pileus::editor {
namespace {

constexpr float kGap = 4;            // design pixels between panels
constexpr float kLeastMiddle = 200;  // of width and height for viewport and graph

struct Divider {
  PanelAreas& areas;
  const PanelLayout& layout;
  const Theme& theme;
  float gap;

  PanelRect& at(Panel p) { return areas.of[static_cast<std::size_t>(p)]; }

  /// Takes a strip from the right of `room`.
  void right(PanelRect& room, Panel panel, const char* id, double PanelLayout::*length, float least) {
    const float width = room.max.x - room.min.x;
    const float wanted = theme.px(static_cast<float>(layout.*length));
    const float most =
        std::max(width - gap - theme.px(kLeastMiddle), std::min(theme.px(least), 0.5f * width));
    const float x = std::round(room.max.x - std::clamp(wanted, std::min(theme.px(least), most), most));
    at(panel) = {{x, room.min.y}, room.max};
    areas.splitters.push_back({id,
                               {{x - gap, room.min.y}, {x, room.max.y}},
                               true,
                               length,
                               -1.0 / static_cast<double>(theme.scale)});
    room.max.x = x - gap;
  }
  /// Takes a strip of `share` of what was asked for from the bottom.
  void bottom(PanelRect& room, Panel panel, const char* id, double PanelLayout::*length, float share) {
    const float wanted = theme.px(static_cast<float>(layout.*length)) * share;
    const float y = std::round(std::max(room.max.y - wanted, room.min.y + gap));
    at(panel) = {{room.min.x, y}, room.max};
    areas.splitters.push_back({id,
                               {{room.min.x, y - gap}, {room.max.x, y}},
                               false,
                               length,
                               -1.0 / static_cast<double>(theme.scale)});
    room.max.y = y - gap;
  }
};

}  // namespace

PanelAreas panelAreas(const PanelLayout& layout, Panel maximised, vec2 lo, vec2 hi, const Theme& theme) {
  PanelAreas areas;
  if (maximised != Panel::Global) {
    areas.of[static_cast<std::size_t>(maximised)] = {lo, hi};
    return areas;
  }
  Divider d{areas, layout, theme, theme.px(kGap)};
  PanelRect room{lo, hi};
  // What lies below shares what the middle can spare.
  float wanted = 0;
  if (layout.showLog) wanted += theme.px(static_cast<float>(layout.logHeight)) + d.gap;
  if (layout.showLab) wanted += theme.px(static_cast<float>(layout.labHeight)) + d.gap;
  if (layout.showTimeline) wanted += theme.px(static_cast<float>(layout.timelineHeight)) + d.gap;
  if (layout.showLights) wanted += theme.px(static_cast<float>(layout.lightsHeight)) + d.gap;
  const float height = hi.y - lo.y, spare = std::max(height - theme.px(kLeastMiddle), 0.55f * height);
  const float share = std::min(1.0f, spare / std::max(wanted, 1.0f));
  if (layout.showLog) d.bottom(room, Panel::Log, "splitter/log", &PanelLayout::logHeight, share);
  if (layout.showLab) d.bottom(room, Panel::Lab, "splitter/lab", &PanelLayout::labHeight, share);
  if (layout.showTimeline)
    d.bottom(room, Panel::Timeline, "splitter/timeline", &PanelLayout::timelineHeight, share);
  if (layout.showLights) d.bottom(room, Panel::Lights, "splitter/lights", &PanelLayout::lightsHeight, share);
  if (layout.showParameters)
    d.right(room, Panel::Parameters, "splitter/parameters", &PanelLayout::parametersWidth, 240);
  if (layout.showScope) d.right(room, Panel::Scope, "splitter/scope", &PanelLayout::scopeWidth, 280);
  if (!layout.showGraph) {
    d.at(Panel::Viewport) = room;
  } else if (!layout.showViewport) {
    d.at(Panel::Graph) = room;
  } else {
    const float both = room.max.y - room.min.y - d.gap, least = std::min(theme.px(90), 0.4f * both);
    const float top = std::clamp(both * static_cast<float>(layout.viewportShare), least, both - least);
    const float y = std::round(room.min.y + top);
    d.at(Panel::Viewport) = {room.min, {room.max.x, y}};
    d.at(Panel::Graph) = {{room.min.x, y + d.gap}, room.max};
    areas.splitters.push_back({"splitter/graph",
                               {{room.min.x, y}, {room.max.x, y + d.gap}},
                               false,
                               &PanelLayout::viewportShare,
                               1.0 / static_cast<double>(std::max(both, 1.0f))});
  }
  return areas;
}

}  // namespace pileus::editor
