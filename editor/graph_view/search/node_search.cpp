#include "editor/graph_view/search/node_search.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <numeric>

#include "editor/document/preset_shelf.h"
#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_menus.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/layout/layout.h"
#include "editor/graph_view/search/fuzzy.h"
#include "editor/graph_view/search/search_chips.h"
#include "editor/picture/node_placement.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::editor {
namespace {

constexpr char kPopup[] = "##node search";
constexpr float kWidth = 380, kRows = 9;

constexpr char kPresets[] = "Preset";

void addChosen(const GraphRoom& room, const SearchItem& item) {
  Ui& ui = room.ui;
  if (!item.preset.empty())
    return ui.requests.push(UsePreset{item.preset, {}, dvec2(room.canvas.search.place)});
  Session& session = room.session;
  NodeSearch& search = room.canvas.search;
  const nodes::Graph& graph = session.document.graph();
  const std::string name = nodes::freeName(graph, item.type->label);
  Result<nodes::Graph> added = nodes::addNode(graph, item.type->id, dvec2(search.place), name);
  std::string label = "Add " + name;
  if (added && search.link) {
    const LinkDrag& drag = *search.link;
    const nodes::Link link = drag.fromOutput ? nodes::Link{drag.node, drag.socket, name, item.socket}
                                             : nodes::Link{name, item.socket, drag.node, drag.socket};
    if (drag.replaces) added = nodes::disconnect(*added, *drag.replaces);
    added = nodes::connect(*added, link);
    // The socket comes to lie where the link was dropped.
    const Layout layout = added ? layoutGraph(*added, {}) : Layout{};
    if (const NodePlace* place = findPlace(layout, name))
      if (const SocketPlace* socket = findSocket(*place, item.socket, drag.fromOutput))
        added = nodes::moveNodes(*added, {name}, dvec2(search.place - socket->at));
  }
  if (added && !search.link && session.selectedLink) {
    // A new node goes into the selected link where it fits.
    if (Result<nodes::Graph> inserted = nodes::insertOnLink(*added, name, *session.selectedLink)) {
      added = std::move(inserted);
      label = "Insert " + name;
    }
  }
  FittedNode fitted;
  if (added) {
    fitted = fittedToScene(*added, name, room.shown.scene.bounds);
    added = std::move(fitted.graph);
  }
  if (!tryEdit(session, ui.messages, std::move(added), label)) return;
  if (!fitted.note.empty()) ui.messages.note(fitted.note);
  session.document.select({name});
  remember(room.settings.recentNodes, item.type->id);
}

void drawRow(const GraphRoom& room, const SearchItem& item, int row, bool chosen, float width) {
  Ui& ui = room.ui;
  const Theme& theme = ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = theme.px(40);
  ImGui::PushID(row);
  if (ImGui::InvisibleButton("row", {width, height})) {
    addChosen(room, item);
    ImGui::CloseCurrentPopup();
  }
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0))
    room.canvas.search.chosen = row;
  ui.trace.item("search/" + std::to_string(row));
  ui.trace.note("search/" + std::to_string(row), item.label);
  ImGui::PopID();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (chosen) draw->AddRectFilled(at, {at.x + width, at.y + height}, palette::kAccentDim, theme.px(4));
  draw->AddRectFilled({at.x + theme.px(6), at.y + theme.px(8)},
                      {at.x + theme.px(9), at.y + height - theme.px(8)},
                      mixed(categoryColor(categoryOf(item)), palette::kHighlight, 0.2f), theme.px(2));
  const float x = at.x + theme.space(4), space = width - theme.space(6);
  const std::string& category = categoryOf(item);
  const float categoryWidth = textWidth(theme.small, category);
  drawText(draw, theme.body, {x, at.y + theme.px(3)}, palette::kTextStrong, item.label,
           space - categoryWidth - theme.space(2));
  drawText(draw, theme.small, {at.x + width - categoryWidth - theme.space(2), at.y + theme.px(4)},
           palette::kTextFaint, category, categoryWidth + 1);
  drawText(draw, theme.small, {x, at.y + theme.px(21)}, palette::kTextDim,
           item.preset.empty() ? item.type->help : item.about, space);
}

void moveChosen(NodeSearch& search, int count) {
  const int before = search.chosen;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow))) ++search.chosen;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow))) --search.chosen;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageDown)))
    search.chosen += static_cast<int>(kRows) - 1;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_PageUp))) search.chosen -= static_cast<int>(kRows) - 1;
  search.chosen = count > 0 ? std::clamp(search.chosen, 0, count - 1) : 0;
  if (search.chosen != before) search.scrollToChosen = true;
}

/// Everything else that the canvas can do, for those who came with a right click.
void drawMore(Ui& ui, Canvas& canvas, float width) {
  const Theme& theme = ui.theme;
  const float height = ImGui::GetItemRectSize().y;
  ImGui::SameLine(0, 0);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("more", {width, height})) {
    ImGui::CloseCurrentPopup();
    openCanvasMenu(canvas, {}, canvas.search.at);
  }
  ui.trace.item("search/more");
  const ImU32 ink = ImGui::IsItemHovered() ? palette::kTextStrong : palette::kTextDim;
  if (ImGui::IsItemHovered()) tooltip(theme, "All commands of the canvas");
  drawText(ImGui::GetWindowDrawList(), theme.body,
           {at.x + 0.5f * (width - textWidth(theme.body, icon::kList)),
            at.y + 0.5f * (height - theme.body->FontSize)},
           ink, icon::kList, width);
}

void drawField(Ui& ui, Canvas& canvas) {
  NodeSearch& search = canvas.search;
  const Theme& theme = ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float indent = theme.space(6);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
  const float more = search.link ? 0 : theme.px(32);  // room for the way to the other commands
  ImGui::SetNextItemWidth(more > 0 ? -more : -1);
  if (ImGui::IsWindowAppearing()) ui.fields.focusHere();
  const std::string before = search.query;
  ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
  ImGui::InputTextWithHint("##query", search.link ? "Nodes that fit this link" : "Search nodes",
                           &search.query);
  ImGui::PopStyleColor();
  ui.trace.item("search/field");
  if (more > 0) drawMore(ui, canvas, more);
  if (search.query != before) search.chosen = 0, search.scrollToChosen = true;
  draw->AddText(theme.body, theme.body->FontSize, {at.x + theme.px(5), at.y + theme.px(5)}, palette::kTextDim,
                icon::kSearch);
  const float y = ImGui::GetItemRectMax().y + theme.px(2);
  draw->AddLine({at.x, y}, {at.x + theme.px(kWidth) - theme.space(4), y}, palette::kLine);
  ImGui::Dummy({0, theme.px(2)});
}

}  // namespace

const std::string& categoryOf(const SearchItem& item) {
  static const std::string presets = kPresets;
  return item.preset.empty() ? item.type->category : presets;
}

std::vector<SearchItem> presetItems(const PresetShelf& shelf) {
  std::vector<SearchItem> items;
  for (const nodes::PresetEntry& e : shelf.entries()) {
    if (!e.fault.empty() || e.kind == nodes::PresetKind::Document) continue;
    SearchItem item;
    if (e.kind == nodes::PresetKind::Parameters && !(item.type = nodes::findNodeType(e.type))) continue;
    const std::string what = item.type ? item.type->label : fmt::format("{} nodes", e.nodes);
    item.label = e.name;
    item.preset = e.file;
    item.about = e.about.empty() ? what : what + ": " + e.about;
    item.words = nodes::presetTagList(e.tags) + " " + what + " " + kPresets;
    items.push_back(std::move(item));
  }
  return items;
}

std::vector<SearchItem> searchItems(const std::optional<LinkFilter>& filter) {
  std::vector<SearchItem> items;
  for (const nodes::NodeType& type : nodes::allNodeTypes()) {
    if (!filter) {
      items.push_back({&type, {}, type.label});
      continue;
    }
    const std::size_t first = items.size();
    for (const nodes::SocketSpec& s : filter->fromOutput ? type.inputs : type.outputs)
      if (filter->fromOutput ? nodes::convertible(filter->type, s.type)
                             : nodes::convertible(s.type, filter->type))
        items.push_back({&type, s.id, s.label});
    const bool several = items.size() - first > 1;
    for (std::size_t i = first; i < items.size(); ++i)
      items[i].label = several ? type.label + ": " + items[i].label : type.label;
  }
  // Parameters that the link would make a socket of come after what is one already.
  if (filter && filter->fromOutput)
    for (const nodes::NodeType& type : nodes::allNodeTypes())
      for (const nodes::ParamSpec& p : type.params)
        if (nodes::convertible(filter->type, nodes::socketType(p.type)))
          items.push_back({&type, p.id, type.label + ": " + p.label});
  return items;
}

std::vector<int> rankItems(const std::vector<SearchItem>& items, std::string_view query,
                           const std::vector<std::string>& recent) {
  struct Rank {
    int item, score;
    std::size_t age;
  };
  std::vector<Rank> ranks;
  for (int i = 0; i < static_cast<int>(items.size()); ++i) {
    const SearchItem& item = items[static_cast<std::size_t>(i)];
    const auto label = fuzzyScore(query, item.label);
    // Keywords and the category find a node too, but a name that matches comes first.
    const auto other =
        fuzzyScore(query, item.preset.empty() ? item.type->keywords + " " + item.type->category : item.words);
    if (!label && !(other && query.size() > 1)) continue;
    const int score = std::max(label.value_or(-1000), other && query.size() > 1 ? *other / 2 - 10 : -1000);
    const auto found =
        item.preset.empty() ? std::find(recent.begin(), recent.end(), item.type->id) : recent.end();
    const auto age = static_cast<std::size_t>(found - recent.begin());
    ranks.push_back({i, score, age});
  }
  std::stable_sort(ranks.begin(), ranks.end(), [](const Rank& a, const Rank& b) {
    return a.score != b.score ? a.score > b.score : a.age < b.age;
  });
  std::vector<int> out;
  for (const Rank& r : ranks) out.push_back(r.item);
  return out;
}

void openSearch(const Session& session, Canvas& canvas, vec2 screen, vec2 place,
                std::optional<LinkDrag> link) {
  NodeSearch& search = canvas.search;
  search = NodeSearch{};
  search.opening = true;
  search.at = screen;
  search.place = place;
  std::optional<LinkFilter> filter;
  if (link) {
    const Layout layout = layoutGraph(session.document.graph(), {});
    const NodePlace* node = findPlace(layout, link->node);
    const SocketPlace* socket = node ? findSocket(*node, link->socket, !link->fromOutput) : nullptr;
    if (!socket) return void(search.opening = false);
    filter = LinkFilter{link->fromOutput, socket->type};
  }
  search.link = std::move(link);
  search.items = searchItems(filter);
}

void drawSearch(const GraphRoom& room) {
  Ui& ui = room.ui;
  Canvas& canvas = room.canvas;
  const Settings& settings = room.settings;
  NodeSearch& search = canvas.search;
  const Theme& theme = ui.theme;
  if (search.opening) {
    ImGui::OpenPopup(kPopup);
    search.opening = false;
    const float height =
        theme.px(130 + 40 * std::clamp(static_cast<float>(search.items.size()), 1.0f, kRows));
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(
        {std::clamp(search.at.x - theme.px(20), 4.0f, std::max(4.0f, display.x - theme.px(kWidth) - 4)),
         std::clamp(search.at.y - theme.px(16), 4.0f, std::max(4.0f, display.y - height - 4))});
  }
  ImGui::SetNextWindowSize({theme.px(kWidth), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(2), theme.space(2)});
  search.open = ImGui::BeginPopup(kPopup, ImGuiWindowFlags_NoMove);
  if (search.open) {
    // A link that was dropped is for nodes that it fits.
    if (!search.link && search.shelf != room.presets.revision()) {
      search.shelf = room.presets.revision();
      std::erase_if(search.items, [](const SearchItem& item) { return !item.preset.empty(); });
      for (SearchItem& item : presetItems(room.presets)) search.items.push_back(std::move(item));
    }
    drawField(ui, canvas);
    drawCategoryChips(ui, canvas);
    std::vector<int> ranked = rankItems(search.items, search.query, settings.recentNodes);
    if (!search.category.empty())
      std::erase_if(ranked, [&](int i) {
        return categoryOf(search.items[static_cast<std::size_t>(i)]) != search.category;
      });
    moveChosen(search, static_cast<int>(ranked.size()));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const float rows = std::clamp(static_cast<float>(ranked.size()), 1.0f, kRows);
    ImGui::BeginChild("rows", {0, rows * theme.px(40)});
    const float width = ImGui::GetContentRegionAvail().x;
    for (int row = 0; row < static_cast<int>(ranked.size()); ++row) {
      if (row == search.chosen && search.scrollToChosen) {
        ImGui::SetScrollHereY(0.5f);
        search.scrollToChosen = false;
      }
      drawRow(room, search.items[static_cast<std::size_t>(ranked[static_cast<std::size_t>(row)])], row,
              row == search.chosen, width);
    }
    if (ranked.empty()) {
      ImGui::SetCursorPos({theme.space(4), theme.px(10)});
      ImGui::TextDisabled(search.items.empty() ? "No node fits this link." : "No node has this name.");
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    drawSearchKeys(ui.theme, width);
    const bool enter = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) ||
                       ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false);
    if (enter && !ranked.empty()) {
      addChosen(room,
                search.items[static_cast<std::size_t>(ranked[static_cast<std::size_t>(search.chosen)])]);
      ImGui::CloseCurrentPopup();
    }
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) ImGui::CloseCurrentPopup();
    ui.trace.rect("search", ImGui::GetWindowPos(),
                  {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
                   ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace pileus::editor
