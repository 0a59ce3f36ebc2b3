#include "editor/panels/parameters.h"

#include <fmt/core.h>
#include <imgui_stdlib.h>

#include "editor/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/icons.h"
#include "editor/panels/param_row.h"

namespace pileus::editor {
namespace {

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
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive()) ImGui::SetTooltip("Name of this node (F2)");
  if (!ImGui::IsItemDeactivated()) {
    if (!ImGui::IsItemActive()) panel.nameText = name;
    return;
  }
  if (panel.nameText != name &&
      tryEdit(editor, nodes::renameNode(editor.document.graph(), name, panel.nameText), "Rename " + name)) {
    std::set<std::string> selection = editor.document.selection();
    selection.erase(name);
    selection.insert(panel.nameText);
    editor.document.select(std::move(selection));
    if (editor.viewport.activeView == name) editor.viewport.activeView = panel.nameText;
  }
  panel.nameOf.clear();
}

void drawHeader(Editor& editor, const std::string& name, const nodes::Node& node,
                const nodes::NodeType* type) {
  const Theme& theme = editor.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImU32 color = type ? categoryColor(type->category) : IM_COL32(96, 60, 60, 255);
  const char* mark = type ? categoryIcon(type->category) : icon::kWarning;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, {at.x + width, at.y + theme.px(26)}, color, theme.px(4));
  drawText(draw, theme.body, {at.x + theme.px(9), at.y + theme.px(5)}, faded(palette::kTextStrong, 0.8f),
           mark, width);
  drawText(draw, theme.strong, {at.x + theme.px(32), at.y + theme.px(5)}, palette::kTextStrong,
           type ? type->label : node.type, width - theme.px(90));
  if (type) {
    const float right = textWidth(theme.small, type->category);
    drawText(draw, theme.small, {at.x + width - right - theme.px(9), at.y + theme.px(6)},
             faded(palette::kTextStrong, 0.7f), type->category, right + 1);
  }
  ImGui::Dummy({width, theme.px(28)});
  drawName(editor, name);
  if (type && !type->help.empty()) {
    ImGui::PushFont(theme.small);
    wrapped(palette::kTextDim, "", type->help);
    ImGui::PopFont();
  }
  if (!type)
    wrapped(
        palette::kWarning, icon::kWarning,
        "This version does not know the type " + node.type + ". The node is kept as it is and does nothing.");
  if (node.bypass)
    wrapped(palette::kWarning, icon::kBan, "Bypassed: its first fitting input passes through.");
}

void drawStatus(Editor& editor, const std::string& name) {
  const nodes::NodeStatus& status = editor.preview.evaluator().status(name);
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

void drawNode(Editor& editor, const std::string& name) {
  const nodes::Node* node = nodes::findNode(editor.document.graph(), name);
  if (!node) return;
  const nodes::NodePtr keep =
      editor.document.graph().nodes.at(name);  // an edit while drawing replaces the graph
  const nodes::NodeType* type = nodes::findNodeType(node->type);
  ImGui::PushID(name.c_str());
  drawHeader(editor, name, *keep, type);
  if (type && !type->params.empty()) {
    separator(editor.theme);
    for (const nodes::ParamSpec& spec : type->params) drawParamRow(editor, name, spec);
  }
  drawStatus(editor, name);
  ImGui::PopID();
}

void settingNumber(Editor& editor, const char* id, const std::string& label, double value, NumberField field,
                   void (*apply)(nodes::Settings&, double)) {
  ImGui::PushID(id);
  const float width = beginRow(editor, label, false, nullptr);
  const NumberEdit edit = numberField(editor.parameters.numbers, editor.theme, id, value, field, width);
  editor.trace.item(std::string("setting/") + id);
  if (edit.changed) {
    nodes::Graph graph = editor.document.graph();
    apply(graph.settings, value);
    editor.document.edit(std::move(graph), label,
                         edit.dragging ? std::string("setting ") + id : std::string());
    editor.preview.touch();
  }
  if (edit.finished) editor.document.endMerge();
  ImGui::PopID();
}

void drawDocument(Editor& editor) {
  const Theme& theme = editor.theme;
  ImGui::PushFont(theme.title);
  ImGui::TextUnformatted("Document");
  ImGui::PopFont();
  wrapped(palette::kTextDim, "", "Select a node to see its parameters.");
  separator(theme);
  const nodes::Settings s = editor.document.graph().settings;
  const NumberField pixels{64, 4096, 1, 65536, true, false, "px"};
  settingNumber(editor, "width", "Picture width", s.size.x, pixels,
                [](nodes::Settings& t, double v) { t.size.x = static_cast<int>(v); });
  settingNumber(editor, "height", "Picture height", s.size.y, pixels,
                [](nodes::Settings& t, double v) { t.size.y = static_cast<int>(v); });
  separator(theme);
  ImGui::PushFont(theme.small);
  wrapped(palette::kTextFaint, "",
          fmt::format("{} nodes, {} links", editor.document.graph().nodes.size(),
                      editor.document.graph().links.size()));
  wrapped(palette::kTextFaint, "", "Working space " + s.workingSpace);
  if (editor.viewport.colors)
    wrapped(palette::kTextFaint, "", "Colour configuration " + editor.viewport.colors->description());
  ImGui::PopFont();
}

void drawMany(Editor& editor) {
  const std::set<std::string> names = editor.document.selection();
  ImGui::PushFont(editor.theme.title);
  ImGui::Text("%d nodes", static_cast<int>(names.size()));
  ImGui::PopFont();
  wrapped(palette::kTextDim, "", "Choose one to see its parameters.");
  separator(editor.theme);
  for (const std::string& name : names)
    if (ImGui::Selectable(name.c_str())) editor.document.select({name});
}

}  // namespace

void drawParameters(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  const ImVec2 pad = {theme.space(3), theme.space(3)};
  ImGui::SetCursorScreenPos({min.x + pad.x, min.y + pad.y});
  ImGui::BeginChild("parameters", {max.x - min.x - 2 * pad.x, max.y - min.y - 2 * pad.y}, false);
  const std::set<std::string>& selection = editor.document.selection();
  if (selection.empty())
    drawDocument(editor);
  else if (selection.size() == 1)
    drawNode(editor, std::string(*selection.begin()));
  else
    drawMany(editor);
  ImGui::EndChild();
  editor.trace.rect("parameters", min, max);
}

}  // namespace pileus::editor
