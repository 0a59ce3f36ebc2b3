#include "editor/parameters/parameters.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/parameters/document_rows.h"
#include "editor/parameters/param_row.h"
#include "editor/toolkit/icons.h"
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

void drawName(Editor& editor, const std::string& name) {
  Parameters& panel = editor.parameters;
  if (panel.nameOf != name) panel.nameOf = name, panel.nameText = name;
  if (panel.focusName) ImGui::SetKeyboardFocusHere();
  panel.focusName = false;
  ImGui::SetNextItemWidth(-1);
  ImGui::PushFont(editor.theme.strong);
  ImGui::InputText("##name", &panel.nameText, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopFont();
  editor.trace.item("node name");
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive() && panel.rest.short_)
    tooltip(editor.theme, "Name of this node (F2)");
  if (!ImGui::IsItemDeactivated()) {
    if (!ImGui::IsItemActive()) panel.nameText = name;
    return;
  }
  if (panel.nameText != name &&
      tryEdit(editor, nodes::renameNode(editor.document.graph(), name, panel.nameText), "Rename " + name)) {
    std::set<std::string> selection = editor.document.selection();
    if (selection.erase(name)) selection.insert(panel.nameText);
    editor.document.select(std::move(selection));
    viewsFollow(editor, name, panel.nameText);
    if (panel.pinned == name) panel.pinned = panel.nameText;
  }
  panel.nameOf.clear();
}

/// A quiet button in the header's bar; `on` keeps it lit.
bool barButton(Editor& editor, const char* mark, const char* trace, const char* help, bool on, float x,
               float y) {
  const Theme& theme = editor.theme;
  const float size = theme.px(22);
  ImGui::SetCursorScreenPos({x, y});
  const bool clicked = ImGui::InvisibleButton(trace, {size, size});
  editor.trace.item(trace);
  const bool hovered = ImGui::IsItemHovered();
  if (on || hovered)
    ImGui::GetWindowDrawList()->AddRectFilled({x, y}, {x + size, y + size},
                                              faded(palette::kTextStrong, on ? 0.22f : 0.12f), theme.px(4));
  const float w = textWidth(theme.body, mark);
  drawText(ImGui::GetWindowDrawList(), theme.body,
           {x + 0.5f * (size - w), y + 0.5f * (size - theme.body->FontSize)},
           faded(palette::kTextStrong, on || hovered ? 1 : 0.65f), mark, size);
  if (hovered && editor.parameters.rest.short_) tooltip(theme, help);
  return clicked;
}

void drawPanelMenu(Editor& editor, const Names& names) {
  if (!ImGui::BeginPopup("panel menu")) return;
  const auto item = [&](const char* id, const char* label, const char* key, bool on = false) {
    const bool chosen = ImGui::MenuItem(label, key, on);
    editor.trace.item(std::string("panel menu/") + id);
    return chosen;
  };
  if (item("reset", names.size() == 1 ? "Reset All Parameters" : "Reset All Parameters of These Nodes", ""))
    resetNodes(editor, names);
  if (item("paste", "Paste All Values of the Copied Node", "Ctrl+Shift+V")) pasteValues(editor, names);
  ImGui::Separator();
  if (item("modified", "Show Only Modified", "", editor.parameters.onlyModified))
    editor.parameters.onlyModified ^= true;
  if (item("pin", "Pin to This Node", "", !editor.parameters.pinned.empty()))
    editor.parameters.pinned = editor.parameters.pinned.empty() ? names.front() : "";
  if (item("help", "Help on This Node", "F1")) openHelpPage(editor, names.front(), "");
  ImGui::EndPopup();
}

void drawBar(Editor& editor, const Names& names, const nodes::Node& node, const nodes::NodeType* type) {
  const Theme& theme = editor.theme;
  Parameters& panel = editor.parameters;
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
  if (barButton(editor, icon::kMore, "panel/menu", "More", false, x, y)) ImGui::OpenPopup("panel menu");
  if (type && barButton(editor, icon::kQuestion, "panel/help", "Help on this node (F1)", false, x - each, y))
    openHelpPage(editor, names.front(), "");
  if (barButton(editor, icon::kFilter, "panel/modified", "Show only what is modified", panel.onlyModified,
                x - 2 * each, y))
    panel.onlyModified ^= true;
  const bool pinned = !panel.pinned.empty();
  if (names.size() == 1 &&
      barButton(editor, icon::kPin, "panel/pin",
                pinned ? "Follow the selection again" : "Stay at this node while others are selected", pinned,
                x - 3 * each, y))
    panel.pinned = pinned ? "" : names.front();
  drawPanelMenu(editor, names);
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({width, theme.px(30)});
}

void drawHeader(Editor& editor, const Names& names, const nodes::Node& node, const nodes::NodeType* type) {
  const Theme& theme = editor.theme;
  drawBar(editor, names, node, type);
  if (names.size() == 1) {
    drawName(editor, names.front());
  } else {
    ImGui::PushFont(theme.strong);
    ImGui::Text("%d nodes", static_cast<int>(names.size()));
    ImGui::PopFont();
    ImGui::SameLine(0, theme.space(2));
    ImGui::PushFont(theme.small);
    wrapped(palette::kTextDim, "", "edited together");
    ImGui::PopFont();
    editor.trace.note("edited together", std::to_string(names.size()));
  }
  if (!type)
    wrapped(
        palette::kWarning, icon::kWarning,
        "This version does not know the type " + node.type + ". The node is kept as it is and does nothing.");
  if (node.bypass)
    wrapped(palette::kWarning, icon::kBan, "Bypassed: its first fitting input passes through.");
}

void drawStatus(Editor& editor, const std::string& name) {
  const nodes::NodeStatus& status = editor.preview.evaluator().status(editor.document.scopedName(name));
  const Theme& theme = editor.theme;
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
void beginRows(Editor& editor, const std::string& of) {
  Parameters& panel = editor.parameters;
  ImGui::BeginChild("rows", {0, 0}, false);
  if (panel.scrollOf != of) {
    const auto it = panel.scrolls.find(of);
    ImGui::SetScrollY(it == panel.scrolls.end() ? 0 : it->second);
    panel.scrollOf = of;
  } else {
    panel.scrolls[of] = ImGui::GetScrollY();
  }
}

void drawRows(Editor& editor, const Names& names, const nodes::NodeType& type) {
  const float top = ImGui::GetCursorPosY();
  ParamTarget target{names, nullptr};
  for (const nodes::ParamSpec& spec : type.params) {
    target.spec = &spec;
    drawParamRow(editor, target);
  }
  if (!editor.parameters.onlyModified || ImGui::GetCursorPosY() > top) return;
  wrapped(palette::kTextDim, "", "Nothing is modified.");
  if (ImGui::Button("Show all parameters")) editor.parameters.onlyModified = false;
  editor.trace.item("panel/show all");
}

void drawNodes(Editor& editor, const Names& names) {
  const nodes::NodePtr node = editor.document.graph().nodes.at(names.front());  // an edit replaces the graph
  const nodes::NodeType* type = nodes::findNodeType(node->type);
  ImGui::PushID(names.front().c_str());
  drawHeader(editor, names, *node, type);
  ImGui::PopID();
  gap(editor.theme, 0.5f);
  beginRows(editor, names.front());
  ImGui::PushID(names.front().c_str());
  if (type) drawRows(editor, names, *type);
  if (names.size() == 1) drawStatus(editor, names.front());
  ImGui::PopID();
  ImGui::EndChild();
}

void drawDocument(Editor& editor) {
  ImGui::PushFont(editor.theme.title);
  ImGui::TextUnformatted("Document");
  ImGui::PopFont();
  wrapped(palette::kTextDim, "", "Select a node to see its parameters.");
  separator(editor.theme);
  beginRows(editor, "");
  drawDocumentRows(editor);
  ImGui::EndChild();
}

/// Nodes of several types: a list to choose from.
void drawMany(Editor& editor) {
  const std::set<std::string> names = editor.document.selection();
  ImGui::PushFont(editor.theme.title);
  ImGui::Text("%d nodes", static_cast<int>(names.size()));
  ImGui::PopFont();
  wrapped(palette::kTextDim, "", "Nodes of one type are edited together. Choose one to see its parameters.");
  separator(editor.theme);
  for (const std::string& name : names) {
    if (ImGui::Selectable(name.c_str())) editor.document.select({name});
    editor.trace.item("choose/" + name);
  }
}

}  // namespace

Names shownNodes(const Editor& editor) {
  const nodes::Graph& graph = editor.document.graph();
  const Parameters& panel = editor.parameters;
  if (!panel.pinned.empty() && graph.nodes.contains(panel.pinned)) return {panel.pinned};
  Names names;
  for (const std::string& name : editor.document.selection()) {
    const nodes::Node* node = nodes::findNode(graph, name);
    if (!node) continue;
    if (!names.empty() && node->type != graph.nodes.at(names.front())->type) return {};
    names.push_back(name);
  }
  return names;
}

bool keysAreTaken(const Parameters& panel) {
  return panel.numbers.typing || (panel.numbers.active && panel.numbers.moved) || panel.eyedropper.target ||
         panel.points.dragging;
}

bool onHoveredParam(Editor& editor, void (*run)(Editor&, const ParamTarget&)) {
  if (editor.hovered != Panel::Parameters || !editor.parameters.hovered) return false;
  const ParamTarget target = *editor.parameters.hovered;
  run(editor, target);
  return true;
}

void drawParameters(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  Parameters& panel = editor.parameters;
  panel.min = min;
  panel.hovered.reset();
  if (panel.points.dragging && !ImGui::IsMouseDown(0) && !ImGui::IsMouseReleased(0)) {
    panel.points.dragging = false;  // its widget went away
    editor.document.endMerge();
  }
  if (!ImGui::IsMouseDown(1) && !ImGui::IsMouseReleased(1)) panel.points.removing = false;
  panel.litParam = std::exchange(panel.nextLit, {});
  if (!panel.pinned.empty() && !editor.document.graph().nodes.contains(panel.pinned)) panel.pinned.clear();
  updateRest(panel.rest, min, max);
  updateDisplayColors(editor);
  const ImVec2 pad = {theme.space(3), theme.space(3)};
  ImGui::SetCursorScreenPos({min.x + pad.x, min.y + pad.y});
  ImGui::BeginChild("parameters", {max.x - min.x - 1.5f * pad.x, max.y - min.y - 1.5f * pad.y}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  const Names names = shownNodes(editor);
  if (!names.empty())
    drawNodes(editor, names);
  else if (editor.document.selection().empty())
    drawDocument(editor);
  else
    drawMany(editor);
  ImGui::EndChild();
  drawHelpPage(editor);
  drawEyedropper(editor);
  editor.trace.rect("parameters", min, max);
  if (panel.hovered) editor.trace.note("hovered param", panel.hovered->key());
}

}  // namespace pileus::editor
