// What the viewport's bar offers in lists, for combos and for the menu of what has no room.
#include <fmt/core.h>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/bar_parts.h"
#include "editor/viewport/viewport_room.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::editor {
namespace {

void setText(Ui& ui, Session& session, const Clock& clock, const std::string& node, const char* param,
             const std::string& value, const char* label) {
  tryEditRoot(session, ui.messages,
              nodes::setParamAt(session.document.root(), node, param, value, clock.frame), label);
}
}  // namespace

void listOutputs(Bar& bar) {
  for (const std::string& name : bar.outputs)
    if (ImGui::Selectable(name.c_str(), name == shownView(bar.room.session, bar.room.shown)))
      bar.room.shown.activeView = name;
}

void listLayers(Bar& bar) {
  for (std::size_t i = 0; i < bar.layers.size(); ++i) {
    if (ImGui::Selectable(bar.layers[i].label.c_str(), i == bar.layer))
      showLayer(bar.room.ui.messages, bar.room.shown, bar.layers[i]);
    bar.room.ui.trace.item(fmt::format("viewport/layer/{}", i));
    if (ImGui::IsItemHovered()) tooltip(bar.room.ui.theme, bar.layers[i].help);
  }
}

void listChannels(Bar& bar) {
  for (const auto& item : enumInfo(static_cast<view::Channel*>(nullptr))) {
    if (item.value == view::Channel::Transmittance) continue;
    const std::string label = fmt::format("{}  {}", item.label, item.help);
    if (ImGui::Selectable(label.c_str(), item.value == bar.room.shown.mode.channel))
      bar.room.shown.mode.channel = item.value;
  }
}

void listDisplays(Bar& bar) {
  const image::ColorConfig& colors = *bar.room.shown.displayed.colors;
  const std::string shown = bar.settings.display.empty() ? colors.defaultDisplay() : bar.settings.display;
  for (const std::string& name : colors.displays())
    if (ImGui::Selectable(name.c_str(), name == shown) && name != shown)
      setText(bar.room.ui, bar.room.session, bar.room.clock, bar.view, "display",
              name == colors.defaultDisplay() ? "" : name, "Display");
}

std::string shownViewTransform(const Bar& bar) {
  const image::ColorConfig& colors = *bar.room.shown.displayed.colors;
  return bar.settings.view.empty() ? colors.defaultView(bar.settings.display) : bar.settings.view;
}

void listViews(Bar& bar) {
  const image::ColorConfig& colors = *bar.room.shown.displayed.colors;
  const std::string shown = shownViewTransform(bar);
  for (const std::string& name : colors.views(bar.settings.display))
    if (ImGui::Selectable(name.c_str(), name == shown) && name != shown)
      setText(bar.room.ui, bar.room.session, bar.room.clock, bar.view, "view",
              name == colors.defaultView(bar.settings.display) ? "" : name, "View");
}

void listLooks(Bar& bar) {
  if (ImGui::Selectable("As the view has it", bar.settings.look.empty()) && !bar.settings.look.empty())
    setText(bar.room.ui, bar.room.session, bar.room.clock, bar.view, "look", "", "Look");
  for (const std::string& name : bar.room.shown.displayed.colors->looks())
    if (ImGui::Selectable(name.c_str(), name == bar.settings.look) && name != bar.settings.look)
      setText(bar.room.ui, bar.room.session, bar.room.clock, bar.view, "look", name, "Look");
}

void listResolutions(Bar& bar) {
  struct Choice {
    double factor;
    const char* label;
  };
  for (const Choice& c : {Choice{1, "100 %"}, Choice{0.5, "50 %"}, Choice{0.25, "25 %"}})
    if (ImGui::Selectable(c.label, c.factor == bar.room.settings.viewportResolution))
      bar.room.settings.viewportResolution = c.factor;
}

void listDraftTimes(Bar& bar) {
  for (const double time : {30.0, 60.0, 100.0})
    if (ImGui::Selectable(fmt::format("{:.0f} ms", time).c_str(), time == bar.room.settings.draftMs))
      bar.room.settings.draftMs = time;
}
}  // namespace pileus::editor
