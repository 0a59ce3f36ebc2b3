#include "editor/graph_view/search/find_nodes.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/scopes.h"
#include "editor/time/clock.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

constexpr char kPopup[] = "##find nodes";
constexpr float kWidth = 340, kRow = 42, kRows = 7;

const nodes::Node* nodeOf(const nodes::Graph& root, const FindMatch& match) {
  const nodes::Graph* graph = &root;
  for (const std::string& group : match.scope) {
    const nodes::Node* node = nodes::findNode(*graph, group);
    if (!node || !node->group) return nullptr;
    graph = node->group.get();
  }
  return nodes::findNode(*graph, match.node);
}

std::string joined(const std::vector<std::string>& scope) {
  std::string text;
  for (const std::string& group : scope) text += group + " \xe2\x80\xba ";
  return text;
}

void searchAgain(const Session& session, const Clock& clock, Canvas& canvas) {
  FindNodes& find = canvas.find;
  find.revision = session.document.revision();
  find.frame = clock.frame;
  const std::vector<FindMatch> before = std::move(find.all);
  find.all = findMatches(session.document.root(), find.query, clock.frame);
  find.matches.clear();
  const std::vector<std::string>& here = session.document.scope();
  for (const FindMatch& m : find.all)
    if (m.scope == here) find.matches.insert(m.node);
  // The chosen row stays chosen where it is still found.
  if (find.chosen < static_cast<int>(before.size())) {
    const FindMatch& chosen = before[static_cast<std::size_t>(find.chosen)];
    const auto same = std::find_if(find.all.begin(), find.all.end(), [&](const FindMatch& m) {
      return m.scope == chosen.scope && m.node == chosen.node;
    });
    if (same != find.all.end()) find.chosen = static_cast<int>(same - find.all.begin());
  }
  find.chosen = std::clamp(find.chosen, 0, std::max(0, static_cast<int>(find.all.size()) - 1));
}

void goTo(Ui& ui, Session& session, Canvas& canvas, const FindMatch& match) {
  if (match.scope != session.document.scope() && !goToScope(session, canvas, match.scope))
    return ui.messages.hint("The group of " + match.node + " is gone.");
  session.selectedLink.reset();
  canvas.selectedFrame.reset();
  session.document.select({match.node});
  canvas.frameSelection = true;
}

void drawRow(Ui& ui, Session& session, Canvas& canvas, const FindMatch& match, int row, float width) {
  FindNodes& find = canvas.find;
  const Theme& theme = ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = theme.px(kRow);
  ImGui::PushID(row);
  if (ImGui::InvisibleButton("row", {width, height})) {
    goTo(ui, session, canvas, match);
    ImGui::CloseCurrentPopup();
  }
  if (ImGui::IsItemHovered() && (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0))
    find.chosen = row;
  if (ui.trace.on()) {
    ui.trace.item("find/" + std::to_string(row));
    ui.trace.note("find/" + std::to_string(row), joined(match.scope) + match.node + ": " + match.where);
  }
  ImGui::PopID();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (row == find.chosen)
    draw->AddRectFilled(at, {at.x + width, at.y + height}, palette::kAccentDim, theme.px(4));
  const nodes::Node* node = nodeOf(session.document.root(), match);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  draw->AddRectFilled(
      {at.x + theme.px(6), at.y + theme.px(8)}, {at.x + theme.px(9), at.y + height - theme.px(8)},
      type ? mixed(categoryColor(type->category), palette::kHighlight, 0.2f) : palette::kTextFaint,
      theme.px(2));
  const float x = at.x + theme.space(4), room = width - theme.space(6);
  drawText(draw, theme.body, {x, at.y + theme.px(4)}, palette::kTextStrong, joined(match.scope) + match.node,
           room);
  const std::string below = match.where == match.node ? (type   ? type->label
                                                         : node ? node->type
                                                                : "")
                                                      : match.where;
  drawText(draw, theme.small, {x, at.y + theme.px(22)}, palette::kTextDim, below, room);
}

void drawField(Ui& ui, const Session& session, const Clock& clock, Canvas& canvas) {
  FindNodes& find = canvas.find;
  const Theme& theme = ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + theme.space(6));
  char count[48];
  const auto end = find.query.empty()
                       ? count
                       : fmt::format_to_n(count, sizeof count, "{} of {}",
                                          find.all.empty() ? 0 : find.chosen + 1, find.all.size())
                             .out;
  const std::string_view counted(count, static_cast<std::size_t>(end - count));
  ImGui::SetNextItemWidth(-theme.px(70));
  if (ImGui::IsWindowAppearing()) ui.fields.focusHere();
  const std::string before = find.query;
  ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
  ImGui::InputTextWithHint("##query", "Name, type, parameter or value", &find.query,
                           ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleColor();
  ui.trace.item("find/field");
  // Every parameter of the graph is looked at: not for each frame that plays past.
  const bool otherFrame = find.frame != clock.frame && !clock.play.playing();
  if (find.query != before || find.revision != session.document.revision() || otherFrame) {
    if (find.query != before) find.all.clear(), find.chosen = 0, find.scroll = true;
    searchAgain(session, clock, canvas);
  }
  drawText(draw, theme.body, {at.x + theme.px(5), at.y + theme.px(5)}, palette::kTextDim, icon::kSearch,
           1e3f);
  const float right = at.x + theme.px(kWidth) - theme.space(5);
  drawText(draw, theme.small, {right - textWidth(theme.small, counted), at.y + theme.px(7)},
           palette::kTextFaint, counted, 1e3f);
  ui.trace.note("find", std::string(counted));
  const float y = ImGui::GetItemRectMax().y + theme.px(2);
  draw->AddLine({at.x, y}, {at.x + theme.px(kWidth) - theme.space(4), y}, palette::kLine);
  ImGui::Dummy({0, theme.px(2)});
}

void walk(FindNodes& find) {
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  const auto count = static_cast<int>(find.all.size());
  const int before = find.chosen;
  if (pressed(ImGuiKey_DownArrow)) ++find.chosen;
  if (pressed(ImGuiKey_UpArrow)) --find.chosen;
  if (count > 0) find.chosen = (find.chosen + count) % count;
  find.scroll |= find.chosen != before;
}

}  // namespace

void openFind(Canvas& canvas) {
  canvas.find.opening = true;
  canvas.find.revision = 0;
}

void drawFind(Ui& ui, Session& session, const Clock& clock, Canvas& canvas) {
  FindNodes& find = canvas.find;
  const Theme& theme = ui.theme;
  if (!find.opening && !find.open) return;
  if (find.opening) {
    ImGui::OpenPopup(kPopup);
    find.opening = false;
  }
  // At the upper right, where it covers little of what it finds.
  ImGui::SetNextWindowPos(
      {std::max(canvas.max.x - theme.px(kWidth) - theme.px(12), canvas.min.x), canvas.min.y + theme.px(12)});
  ImGui::SetNextWindowSize({theme.px(kWidth), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(2), theme.space(2)});
  find.open = ImGui::BeginPopup(kPopup, ImGuiWindowFlags_NoMove);
  if (find.open) {
    drawField(ui, session, clock, canvas);
    walk(find);
    if (!find.query.empty()) {
      ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
      const float rows = std::clamp(static_cast<float>(find.all.size()), 1.0f, kRows);
      ImGui::BeginChild("rows", {0, rows * theme.px(kRow)});
      const float width = ImGui::GetContentRegionAvail().x;
      for (int row = 0; row < static_cast<int>(find.all.size()); ++row) {
        if (row == find.chosen && find.scroll) {
          ImGui::SetScrollHereY(0.5f);
          find.scroll = false;
        }
        drawRow(ui, session, canvas, find.all[static_cast<std::size_t>(row)], row, width);
      }
      if (find.all.empty()) {
        ImGui::SetCursorPos({theme.space(4), theme.px(11)});
        ImGui::TextDisabled("No node has this in its name, type or values.");
      }
      ImGui::EndChild();
      ImGui::PopStyleVar();
    }
    const bool enter = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
    if (enter && !find.all.empty()) {
      goTo(ui, session, canvas, find.all[static_cast<std::size_t>(find.chosen)]);
      ImGui::CloseCurrentPopup();
    }
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) ImGui::CloseCurrentPopup();
    ui.trace.rect("find", ImGui::GetWindowPos(),
                  {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
                   ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace pileus::editor
