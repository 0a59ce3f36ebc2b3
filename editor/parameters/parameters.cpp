#include "editor/parameters/parameters.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/parameters/document_rows.h"
#include "editor/parameters/param_row.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/phase_plot.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

using Names = std::vector<std::string>;

void wrapped(ImU32 ink, const char* mark, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted((std::string(mark) + (*mark ? "  " : "") + text).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void gap(const Theme& theme, float steps = 1) { ImGui::Dummy({0, theme.space(steps)}); }

void separator(const Theme& theme) {
  gap(theme, 0.5f);
  ImGui::Separator();
  gap(theme, 0.5f);
}

void drawName(Ui& ui, Session& session, Shown& shown, Parameters& parameters, const std::string& name) {
  Parameters& panel = parameters;
  if (panel.nameOf != name) panel.nameOf = name, panel.nameText = name;
  if (ui.fields.focusName) ui.fields.focusHere();
  ui.fields.focusName = false;
  ImGui::SetNextItemWidth(-1);
  ImGui::PushFont(ui.theme.strong);
  ImGui::InputText("##name", &panel.nameText, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopFont();
  ui.trace.item("node name");
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive() && panel.rest.short_)
    tooltip(ui.theme, "Name of this node (F2)");
  if (!ImGui::IsItemDeactivated()) {
    if (!ImGui::IsItemActive()) panel.nameText = name;
    return;
  }
  std::set<std::string> selection = session.document.selection();  // an edit drops names that are gone
  if (panel.nameText != name &&
      tryEdit(session, ui.messages, nodes::renameNode(session.document.graph(), name, panel.nameText),
              "Rename " + name)) {
    if (selection.erase(name)) selection.insert(panel.nameText);
    session.document.select(std::move(selection));
    viewsFollow(session, shown, name, panel.nameText);
    if (panel.pinned == name) panel.pinned = panel.nameText;
  }
  panel.nameOf.clear();
}

/// A quiet button in the header's bar; `on` keeps it lit.
bool barButton(Ui& ui, const Parameters& parameters, const char* mark, const char* trace, const char* help,
               bool on, float x, float y) {
  const Theme& theme = ui.theme;
  const float size = theme.px(22);
  ImGui::SetCursorScreenPos({x, y});
  const bool clicked = ImGui::InvisibleButton(trace, {size, size});
  ui.trace.item(trace);
  const bool hovered = ImGui::IsItemHovered();
  if (on || hovered)
    ImGui::GetWindowDrawList()->AddRectFilled({x, y}, {x + size, y + size},
                                              faded(palette::kTextStrong, on ? 0.22f : 0.12f), theme.px(4));
  const float w = textWidth(theme.body, mark);
  drawText(ImGui::GetWindowDrawList(), theme.body,
           {x + 0.5f * (size - w), y + 0.5f * (size - theme.body->FontSize)},
           faded(palette::kTextStrong, on || hovered ? 1 : 0.65f), mark, size);
  if (hovered && parameters.rest.short_) tooltip(theme, help);
  return clicked;
}

void drawPanelMenu(Ui& ui, Session& session, const Clock& clock, Parameters& parameters, const Names& names) {
  if (!ImGui::BeginPopup("panel menu")) return;
  const auto item = [&](const char* id, const char* label, const char* key, bool on = false) {
    const bool chosen = ImGui::MenuItem(label, key, on);
    ui.trace.item(std::string("panel menu/") + id);
    return chosen;
  };
  if (item("reset", names.size() == 1 ? "Reset All Parameters" : "Reset All Parameters of These Nodes", ""))
    resetNodes(ui, session, names);
  if (item("paste", "Paste All Values of the Copied Node", "Ctrl+Shift+V"))
    pasteValues(ui, session, clock, names);
  ImGui::Separator();
  if (item("modified", "Show Only Modified", "", parameters.onlyModified)) parameters.onlyModified ^= true;
  if (item("pin", "Pin to This Node", "", !parameters.pinned.empty()))
    parameters.pinned = parameters.pinned.empty() ? names.front() : "";
  if (item("help", "Help on This Node", "F1")) openHelpPage(ui, session, parameters, names.front(), "");
  ImGui::EndPopup();
}

void drawBar(Ui& ui, Session& session, const Clock& clock, Parameters& parameters, const Names& names,
             const nodes::Node& node, const nodes::NodeType* type) {
  const Theme& theme = ui.theme;
  Parameters& panel = parameters;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, each = theme.px(24);
  const ImU32 color = type ? categoryColor(type->category) : palette::kNodeUnknown;
  const char* mark = type ? categoryIcon(type->category) : icon::kWarning;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, {at.x + width, at.y + theme.px(28)}, color, theme.px(4));
  drawText(draw, theme.body, {at.x + theme.px(9), at.y + theme.px(6)}, faded(palette::kTextStrong, 0.8f),
           mark, width);
  drawText(draw, theme.strong, {at.x + theme.px(32), at.y + theme.px(6)}, palette::kTextStrong,
           type ? type->label : node.type, width - theme.px(36) - 4 * each);
  float x = at.x + width - theme.px(4) - theme.px(22);
  const float y = at.y + theme.px(3);
  if (barButton(ui, parameters, icon::kMore, "panel/menu", "More", false, x, y))
    ImGui::OpenPopup("panel menu");
  if (type &&
      barButton(ui, parameters, icon::kQuestion, "panel/help", "Help on this node (F1)", false, x - each, y))
    openHelpPage(ui, session, parameters, names.front(), "");
  if (barButton(ui, parameters, icon::kFilter, "panel/modified", "Show only what is modified",
                panel.onlyModified, x - 2 * each, y))
    panel.onlyModified ^= true;
  const bool pinned = !panel.pinned.empty();
  if (names.size() == 1 &&
      barButton(ui, parameters, icon::kPin, "panel/pin",
                pinned ? "Follow the selection again" : "Stay at this node while others are selected", pinned,
                x - 3 * each, y))
    panel.pinned = pinned ? "" : names.front();
  drawPanelMenu(ui, session, clock, parameters, names);
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({width, theme.px(30)});
}

void drawHeader(const ParameterRoom& room, const Names& names, const nodes::Node& node,
                const nodes::NodeType* type) {
  const Theme& theme = room.ui.theme;
  drawBar(room.ui, room.session, room.clock, room.parameters, names, node, type);
  if (names.size() == 1) {
    drawName(room.ui, room.session, room.shown, room.parameters, names.front());
  } else {
    ImGui::PushFont(theme.strong);
    ImGui::Text("%d nodes", static_cast<int>(names.size()));
    ImGui::PopFont();
    ImGui::SameLine(0, theme.space(2));
    ImGui::PushFont(theme.small);
    wrapped(palette::kTextDim, "", "edited together");
    ImGui::PopFont();
    room.ui.trace.note("edited together", std::to_string(names.size()));
  }
  if (!type)
    wrapped(
        palette::kWarning, icon::kWarning,
        "This version does not know the type " + node.type + ". The node is kept as it is and does nothing.");
  if (node.bypass)
    wrapped(palette::kWarning, icon::kBan, "Bypassed: its first fitting input passes through.");
}

void drawStatus(const Theme& theme, const Session& session, const Shown& shown, const std::string& name) {
  const nodes::NodeStatus& status = shown.preview.evaluator().status(session.document.scopedName(name));
  using State = nodes::NodeState;
  const bool notes = !status.notes.empty() && status.state != State::Idle;
  if (status.state == State::Idle && status.evaluations == 0) return;
  separator(theme);
  if (status.state == State::Failed) wrapped(palette::kError, icon::kError, status.error.message);
  if (status.state == State::Skipped) wrapped(palette::kTextDim, icon::kInfo, status.error.message);
  if (status.state != State::Idle)
    for (const std::string& w : status.warnings) wrapped(palette::kWarning, icon::kWarning, w);
  ImGui::PushFont(theme.small);
  if (notes)
    for (const std::string& n : status.notes) wrapped(palette::kTextDim, "", n);
  if (status.state == State::Pending)
    wrapped(palette::kTextDim, icon::kClock,
            fmt::format("{} {:.0f} %", status.what.empty() ? "Working" : status.what, 100 * status.fraction));
  std::string facts = fmt::format("CPU {:.1f} ms", status.cpuMs);
  if (status.gpuMs > 0) facts += fmt::format(", GPU {:.1f} ms", status.gpuMs);
  if (status.bytes > 0)
    facts += fmt::format(", {:.1f} MiB", static_cast<double>(status.bytes) / (1024.0 * 1024.0));
  wrapped(palette::kTextFaint, "", facts);
  ImGui::PopFont();
}

/// Rows below the header, which stays; where they were scrolled to is kept by node.
void beginRows(Parameters& parameters, const std::string& of) {
  Parameters& panel = parameters;
  ImGui::BeginChild("rows", {0, 0}, false);
  if (panel.scrollOf != of) {
    const auto it = panel.scrolls.find(of);
    ImGui::SetScrollY(it == panel.scrolls.end() ? 0 : it->second);
    panel.scrollOf = of;
  } else {
    panel.scrolls[of] = ImGui::GetScrollY();
  }
}

void drawRows(const ParameterRoom& room, const Names& names, const nodes::NodeType& type) {
  const float top = ImGui::GetCursorPosY();
  ParamTarget target{names, nullptr};
  for (const nodes::ParamSpec& spec : type.params) {
    target.spec = &spec;
    drawParamRow(room, target);
  }
  if (!room.parameters.onlyModified || ImGui::GetCursorPosY() > top) return;
  wrapped(palette::kTextDim, "", "Nothing is modified.");
  if (ImGui::Button("Show all parameters")) room.parameters.onlyModified = false;
  room.ui.trace.item("panel/show all");
}

void drawNodes(const ParameterRoom& room, const Names& names) {
  const nodes::NodePtr node =
      room.session.document.graph().nodes.at(names.front());  // an edit replaces the graph
  const nodes::NodeType* type = nodes::findNodeType(node->type);
  ImGui::PushID(names.front().c_str());
  drawHeader(room, names, *node, type);
  ImGui::PopID();
  gap(room.ui.theme, 0.5f);
  beginRows(room.parameters, names.front());
  ImGui::PushID(names.front().c_str());
  if (type) drawRows(room, names, *type);
  if (type && type->id == "volume.medium" && names.size() == 1) drawPhasePlot(room, names.front());
  if (names.size() == 1) drawStatus(room.ui.theme, room.session, room.shown, names.front());
  ImGui::PopID();
  ImGui::EndChild();
}

void drawDocument(const ParameterRoom& room) {
  ImGui::PushFont(room.ui.theme.title);
  ImGui::TextUnformatted("Document");
  ImGui::PopFont();
  wrapped(palette::kTextDim, "", "Select a node to see its parameters.");
  separator(room.ui.theme);
  beginRows(room.parameters, "");
  drawDocumentRows(room);
  ImGui::EndChild();
}

/// Nodes of several types: a list to choose from.
void drawMany(Ui& ui, Session& session) {
  const std::set<std::string> names = session.document.selection();
  ImGui::PushFont(ui.theme.title);
  ImGui::Text("%d nodes", static_cast<int>(names.size()));
  ImGui::PopFont();
  wrapped(palette::kTextDim, "", "Nodes of one type are edited together. Choose one to see its parameters.");
  separator(ui.theme);
  for (const std::string& name : names) {
    if (ImGui::Selectable(name.c_str())) session.document.select({name});
    ui.trace.item("choose/" + name);
  }
}

}  // namespace

Names shownNodes(const Session& session, const Parameters& parameters) {
  const nodes::Graph& graph = session.document.graph();
  const Parameters& panel = parameters;
  if (!panel.pinned.empty() && graph.nodes.contains(panel.pinned)) return {panel.pinned};
  Names names;
  for (const std::string& name : session.document.selection()) {
    const nodes::Node* node = nodes::findNode(graph, name);
    if (!node) continue;
    if (!names.empty() && node->type != graph.nodes.at(names.front())->type) return {};
    names.push_back(name);
  }
  return names;
}

bool keysAreTaken(const Fields& fields, const Parameters& panel) {
  return fields.busy() || panel.eyedropper.target || panel.points.dragging;
}

const ParamTarget* hoveredParam(const FrameState& now, const Parameters& panel) {
  return now.hovered == Panel::Parameters && panel.hovered ? &*panel.hovered : nullptr;
}

void drawParameters(const ParameterRoom& room, ImVec2 min, ImVec2 max) {
  const Theme& theme = room.ui.theme;
  Parameters& panel = room.parameters;
  panel.min = min;
  panel.hovered.reset();
  if (panel.points.dragging && !ImGui::IsMouseDown(0) && !ImGui::IsMouseReleased(0)) {
    panel.points.dragging = false;  // its widget went away
    room.session.document.endMerge();
  }
  if (!ImGui::IsMouseDown(1) && !ImGui::IsMouseReleased(1)) panel.points.removing = false;
  panel.litParam = std::exchange(panel.nextLit, {});
  if (!panel.pinned.empty() && !room.session.document.graph().nodes.contains(panel.pinned))
    panel.pinned.clear();
  updateRest(panel.rest, min, max);
  updateDisplayColors(room.shown, room.parameters.colors);
  const ImVec2 pad = {theme.space(3), theme.space(3)};
  ImGui::SetCursorScreenPos({min.x + pad.x, min.y + pad.y});
  ImGui::BeginChild("parameters", {max.x - min.x - 1.5f * pad.x, max.y - min.y - 1.5f * pad.y}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const Names names = shownNodes(room.session, room.parameters);
  if (!names.empty())
    drawNodes(room, names);
  else if (room.session.document.selection().empty())
    drawDocument(room);
  else
    drawMany(room.ui, room.session);
  ImGui::EndChild();
  drawHelpPage(room.ui, room.parameters);
  drawEyedropper(room);
  room.ui.trace.rect("parameters", min, max);
  if (panel.hovered) room.ui.trace.note("hovered param", panel.hovered->key());
}

}  // namespace pileus::editor
