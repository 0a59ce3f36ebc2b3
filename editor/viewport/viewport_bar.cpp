#include "editor/viewport/viewport_bar.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/bar_parts.h"
#include "editor/viewport/viewport_room.h"

namespace pileus::editor {
namespace {

bool hasOutputs(const Bar& bar) { return bar.outputs.size() > 1; }
bool hasDisplay(const Bar& bar) { return bar.type.param("display") && bar.type.param("view"); }
bool hasLooks(const Bar& bar) {
  return bar.type.param("look") && !bar.room.shown.displayed.colors->looks().empty();
}
bool hasExposure(const Bar& bar) { return bar.type.param("exposure"); }

constexpr float kSquare = 0;  // width of a button: as high as a frame

struct Part {
  void (*draw)(Bar&);
  float width;   ///< design pixels
  int priority;  ///< the lowest stay longest where room is short
  bool right = false;
  bool (*wanted)(const Bar&) = nullptr;  ///< null: always
};
constexpr Part kParts[] = {{drawOutput, 120, 8, false, hasOutputs},
                           {drawLayer, 116, 1},
                           {drawChannel, 62, 4},
                           {drawDisplay, 108, 7, false, hasDisplay},
                           {drawView, 138, 3, false, hasDisplay},
                           {drawLook, 110, 9, false, hasLooks},
                           {drawExposure, 127, 2, false, hasExposure},
                           {drawGamma, 112, 17, false, hasExposure},
                           {drawResolution, 78, 19},
                           {drawCamera, 110, 20, true},
                           {drawLock, kSquare, 5, true, hasCamera},
                           {drawRaw, kSquare, 16, true},
                           {drawFalse, kSquare, 13, true},
                           {drawZebra, kSquare, 15, true},
                           {drawHisto, kSquare, 12, true},
                           {drawInspect, kSquare, 10, true},
                           {drawRegionButton, kSquare, 14, true},
                           {drawStill, kSquare, 11, true},
                           {drawCompareButton, kSquare, 6, true},
                           {drawHudButton, kSquare, 18, true}};
constexpr std::size_t kCount = std::size(kParts);

float partWidth(const Theme& theme, const Part& part) {
  return part.width == kSquare ? ImGui::GetFrameHeight() : theme.px(part.width);
}

/// The parts that fit into `room`, most important ones first.
std::array<bool, kCount> fitting(const Bar& bar, float room) {
  std::array<bool, kCount> shown{};
  const Theme& theme = bar.room.ui.theme;
  for (int priority = 1; priority <= static_cast<int>(kCount); ++priority)
    for (std::size_t i = 0; i < kCount; ++i) {
      const Part& part = kParts[i];
      if (part.priority != priority || (part.wanted && !part.wanted(bar))) continue;
      const float width =
          partWidth(theme, part) + (part.right && part.width == kSquare ? theme.px(2) : theme.space(2));
      if (width > room) continue;
      room -= width;
      shown[i] = true;
    }
  return shown;
}

/// Everything, by mouse, however narrow the bar is.
void drawMore(Bar& bar) {
  const auto list = [&](const char* label, void (*items)(Bar&), bool wanted = true) {
    if (!wanted) return;
    const bool open = ImGui::BeginMenu(label);
    bar.room.ui.trace.item(fmt::format("viewport/more/{}", label));
    if (open) items(bar), ImGui::EndMenu();
  };
  list("Shown Node", listOutputs, hasOutputs(bar));
  list("Layer", listLayers);
  list("Channel", listChannels);
  list("Display", listDisplays, hasDisplay(bar));
  list("View Transform", listViews, hasDisplay(bar));
  list("Look", listLooks, hasLooks(bar));
  list("Resolution", listResolutions);
  list("Draft Time", listDraftTimes);
  if (bar.type.param("gamma") && ImGui::BeginMenu("Gamma")) {
    dragNumber(bar, "gamma", bar.settings.gamma, "", "Gamma", "Gamma behind the view transform",
               bar.room.ui.theme.px(96));
    ImGui::EndMenu();
  }
  ImGui::Separator();
  for (const char* id : {"viewport.raw", "viewport.false_color", "viewport.zebra", "viewport.inspector",
                         "viewport.histogram", "viewport.hud"})
    commandMenuItem(bar.room.ui, id);
  ImGui::Separator();
  for (const char* id : {"viewport.region", "viewport.region_toggle", "viewport.snapshot",
                         "viewport.snapshot_wipe", "viewport.compare"})
    commandMenuItem(bar.room.ui, id);
  ImGui::Separator();
  for (const char* id : {"viewport.lock_camera", "viewport.back_to_camera", "viewport.frame",
                         "viewport.reset_camera", "viewport.exposure_reset"})
    commandMenuItem(bar.room.ui, id);
}

void drawMoreButton(Bar& bar, ImVec2 at) {
  const ViewportRoom& room = bar.room;
  const float side = ImGui::GetFrameHeight();
  ImGui::SetCursorScreenPos(at);
  const bool clicked = ImGui::InvisibleButton("##more", {side, side}), hovered = ImGui::IsItemHovered();
  room.ui.trace.item("viewport/more");
  if (hovered)
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, palette::kButtonHover,
                                              room.ui.theme.px(4));
  drawText(ImGui::GetWindowDrawList(), room.ui.theme.body,
           {std::round(at.x + 0.5f * (side - textWidth(room.ui.theme.body, icon::kMore))),
            std::round(at.y + 0.5f * (side - room.ui.theme.body->FontSize))},
           hovered ? palette::kText : palette::kTextDim, icon::kMore, side);
  if (hovered) tooltip(room.ui.theme, "Everything about how the picture is shown");
  if (clicked) ImGui::OpenPopup("viewport more");
  ImGui::SetNextWindowPos({at.x + side, at.y + side + room.ui.theme.px(4)}, ImGuiCond_Appearing, {1, 0});
  if (!ImGui::BeginPopup("viewport more")) return;
  drawMore(bar);
  ImGui::EndPopup();
}

std::vector<std::string> outputsOf(const Session& session, const std::string& shown) {
  std::vector<std::string> names;
  for (const auto& [name, node] : session.document.root().nodes)
    if (const nodes::NodeType* type = nodes::findNodeType(node->type); type && type->isOutput)
      names.push_back(name);
  if (!shown.empty() && std::find(names.begin(), names.end(), shown) == names.end()) names.push_back(shown);
  return names;
}

}  // namespace

void drawViewportBar(const ViewportRoom& room, ImVec2 min, ImVec2 max) {
  const Theme& theme = room.ui.theme;
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, palette::kPanel);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(5)});
  const std::string view = displayNode(room.session, room.shown);
  const nodes::Node* node = nodes::findNode(room.session.document.root(), view);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  if (!type || !room.shown.displayed.colors) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Viewport");
    return;
  }
  Bar bar{room,
          view,
          *type,
          displaySettings(room.session, room.clock, room.shown),
          outputsOf(room.session, shownView(room.session, room.shown)),
          layerChoices(room.shown),
          0};
  bar.layer = shownLayer(room.shown, bar.layers);
  room.ui.trace.note("viewport layer", bar.layers[bar.layer].label);
  // Right of it is room for the buttons that maximise and hide the panel.
  const float side = ImGui::GetFrameHeight(), more = max.x - theme.px(66) - side, y = min.y + theme.px(5);
  const auto shown = fitting(bar, more - theme.space(2) - (min.x + theme.space(2)));
  float left = min.x + theme.space(2), rightWidth = 0;
  for (std::size_t i = 0; i < kCount; ++i)
    if (shown[i] && kParts[i].right)
      rightWidth += partWidth(theme, kParts[i]) + (kParts[i].width == kSquare ? theme.px(2) : theme.space(2));
  float right = more - theme.px(2) - rightWidth;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Part& part = kParts[i];
    if (!shown[i]) continue;
    float& x = part.right ? right : left;
    ImGui::SetCursorScreenPos({x, y});
    part.draw(bar);
    x += partWidth(theme, part) + (part.right && part.width == kSquare ? theme.px(2) : theme.space(2));
  }
  drawMoreButton(bar, {more, y});
}

}  // namespace pileus::editor
