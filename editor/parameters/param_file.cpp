// The widgets of files and of the grids in them.
#include <algorithm>

#include "editor/document/session.h"
#include "editor/parameters/file_state.h"
#include "editor/parameters/param_widgets.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

const std::vector<std::string> kVdb{"vdb"};

namespace fs = std::filesystem;

void browse(const ParamWidget& w) {
  const ParameterRoom& room = w.room;
  BrowserRequest request;
  request.title = w.target.spec->label + " of " + w.target.nodes.front();
  request.button = "Choose";
  request.saving = w.target.spec->writes;
  request.start =
      w.state.mixed() ? fs::path() : absoluteFile(room.session, std::get<std::string>(w.state.value));
  request.sequences =
      w.target.spec->help.find('#') != std::string::npos;  // the node says that it reads patterns
  request.kinds = w.target.spec->fileKinds;
  request.done = [room, target = w.target](const fs::path& path) {
    setParamValue(room, target, path.string());
  };
  room.ui.modals.browser.open(room.settings, std::move(request));
}

/// A small square button in a row of such.
bool mark(Ui& ui, const char* icon, const std::string& trace, const char* help) {
  const float size = ImGui::GetFrameHeight();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, ImGui::GetStyle().FramePadding.y});
  ImGui::PushStyleColor(ImGuiCol_Button, 0);
  ImGui::PushID(trace.c_str());
  const bool pressed = ImGui::Button(icon, {size, 0});
  ImGui::PopID();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ui.trace.item(trace);
  if (ImGui::IsItemHovered()) tooltip(ui.theme, help);
  return pressed;
}

fs::path vdbOf(const Session& session, const Clock& clock, const ParamWidget& w) {
  const nodes::Node* node = nodes::findNode(session.document.graph(), w.target.nodes.front());
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  if (!type) return {};
  for (const nodes::ParamSpec& spec : type->params)
    if (spec.type == nodes::ParamType::File && spec.fileKinds == kVdb && !spec.writes)
      return absoluteFile(session, std::get<std::string>(nodes::paramValue(*node, spec, clock.frame)));
  return {};
}

void drawGridList(const ParamWidget& w) {
  const ParameterRoom& room = w.room;
  const fs::path file = vdbOf(room.session, room.clock, w);
  if (ImGui::Selectable("Chosen by name and class")) setParamValue(room, w.target, std::string());
  room.ui.trace.item("grid/");
  ImGui::Separator();
  if (file.empty()) return ImGui::TextDisabled("No file chosen.");
  const GridList grids = gridsOf(room.parameters.grids, firstOfPattern(file));
  if (!grids.ready) return ImGui::TextDisabled("Reading the file\xe2\x80\xa6");
  if (!grids.error.empty()) {
    ImGui::PushTextWrapPos(room.ui.theme.px(360));
    ImGui::TextDisabled("%s", grids.error.c_str());
    return ImGui::PopTextWrapPos();
  }
  const std::string& current = std::get<std::string>(w.state.value);
  for (const GridList::Item& g : grids.items) {
    if (ImGui::Selectable((g.name.empty() ? "(no name)" : g.name).c_str(), g.name == current))
      setParamValue(room, w.target, g.name);
    room.ui.trace.item("grid/" + g.name);
    ImGui::SameLine(0, room.ui.theme.space(4));
    ImGui::PushFont(room.ui.theme.small);
    ImGui::TextDisabled("%s", g.about.c_str());
    ImGui::PopFont();
  }
  if (grids.items.empty()) ImGui::TextDisabled("The file holds no grids.");
}

}  // namespace

void drawFile(const ParamWidget& w) {
  const ParameterRoom& room = w.room;
  std::string text = w.state.mixed() ? "" : std::get<std::string>(w.state.value);
  const std::string shown = text;
  const float each = ImGui::GetFrameHeight() + room.ui.theme.px(2);
  const bool clearable = !shown.empty() || w.state.mixed();
  std::vector<std::string> kinds = w.target.spec->fileKinds;
  const char* hint = w.state.mixed() ? "\xe2\x80\x93" : w.target.spec->writes ? "no file" : "no file chosen";
  if (textField(room.session, room.parameters, w.target.key(), text, w.width - (clearable ? 2 : 1) * each,
                hint, &kinds))
    setParamValue(room, w.target, expandedHome(text));
  if (!shown.empty() && ImGui::IsItemHovered() && !ImGui::IsItemActive() && room.parameters.rest.long_)
    tooltip(room.ui.theme, absoluteFile(room.session, shown).string());
  if (clearable) {
    ImGui::SameLine(0, room.ui.theme.px(2));
    if (mark(room.ui, icon::kTimes, "clear/" + w.target.spec->id, "No file"))
      setParamValue(room, w.target, std::string());
  }
  ImGui::SameLine(0, room.ui.theme.px(2));
  if (mark(room.ui, icon::kFolderOpen, "browse/" + w.target.spec->id, "Choose a file")) browse(w);
  const std::string missing =
      w.target.spec->writes || w.state.mixed() ? "" : missingFile(room.session, room.parameters, shown);
  if (missing.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  ImGui::PushFont(room.ui.theme.small);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + w.width);
  ImGui::TextUnformatted(missing.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::PopStyleColor();
  room.ui.trace.note("missing file", missing);
}

bool isGridName(const nodes::NodeType& type, const nodes::ParamSpec& spec) {
  return spec.type == nodes::ParamType::Text && spec.id.ends_with("grid") &&
         std::any_of(type.params.begin(), type.params.end(), [](const nodes::ParamSpec& p) {
           return p.type == nodes::ParamType::File && p.fileKinds == kVdb;
         });
}

void drawGridName(const ParamWidget& w) {
  const float button = ImGui::GetFrameHeight();
  std::string text = w.state.mixed() ? "" : std::get<std::string>(w.state.value);
  const char* hint = w.state.mixed() ? "\xe2\x80\x93" : "by name and class";
  if (textField(w.room.session, w.room.parameters, w.target.key(), text,
                w.width - button - w.room.ui.theme.px(2), hint))
    setParamValue(w.room, w.target, text);
  ImGui::SameLine(0, w.room.ui.theme.px(2));
  if (beginCombo(w.room.ui.theme, "##grids", "", button)) {
    drawGridList(w);
    ImGui::EndCombo();
  }
  w.room.ui.trace.item("grids/" + w.target.spec->id);
}

}  // namespace pileus::editor
