#include "editor/graph_view/canvas_menus.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>  // MenuItemEx, BeginMenuEx: rows with icons

#include "editor/document/preset_shelf.h"
#include "editor/document/session.h"
#include "editor/graph_view/bookmarks.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/node_colors.h"
#include "editor/graph_view/scopes.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

constexpr char kMenu[] = "##canvas menu";
constexpr char kRoomForSwatch[] = "     ";

bool row(Ui& ui, const char* mark, const char* label, const std::string& keys, const std::string& trace,
         bool checked = false, bool enabled = true) {
  const bool chosen = ImGui::MenuItemEx(label, mark, keys.c_str(), checked, enabled);
  ui.trace.item("menu/" + trace);
  return chosen;
}

/// A row of the table of commands.
void row(Ui& ui, const char* mark, std::string_view id) {
  const std::optional<CommandLook> look = ui.commands(id);
  if (look && row(ui, mark, look->label, look->keys, std::string(id), look->checked, look->enabled))
    ui.requests.push(RunCommand{std::string(id)});
}

bool beginSubmenu(Ui& ui, const char* mark, const char* label, const char* trace, bool enabled = true) {
  const bool open = ImGui::BeginMenuEx(label, mark, enabled);
  ui.trace.item(std::string("menu/") + trace);
  return open;
}

void heading(const Theme& theme, const std::string& title, const std::string& below) {
  ImGui::PushFont(theme.strong);
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  if (!below.empty()) ImGui::TextDisabled("%s", below.c_str());
  ImGui::Separator();
}

/// Swatches of the colours a node or frame may take; returns whether one was chosen.
bool chooseColor(Ui& ui, const std::string& current, std::string& chosen) {
  bool any = false;
  if (!beginSubmenu(ui, icon::kPaint, "Colour", "color")) return false;
  for (const NodeColor& color : nodeColors()) {
    ImGui::PushID(color.id);
    if (row(ui, kRoomForSwatch, color.label, "", std::string("color/") + color.id, current == color.id)) {
      chosen = color.id;
      any = true;
    }
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    const float size = ui.theme.px(14), y = 0.5f * (lo.y + hi.y - size);
    if (*color.id)
      ImGui::GetWindowDrawList()->AddRectFilled({lo.x + ui.theme.px(2), y},
                                                {lo.x + ui.theme.px(2) + size, y + size}, nodeColor(color.id),
                                                ui.theme.px(3));
    ImGui::PopID();
  }
  ImGui::EndMenu();
  return any;
}

/// Those of this node's parameters, and keeping it as one.
void presetMenu(const GraphRoom& room, const std::string& name, const std::string& type, bool one) {
  Ui& ui = room.ui;
  if (!beginSubmenu(ui, icon::kCloud, "Presets", "presets")) return;
  int i = 0;
  for (const nodes::PresetEntry& e : room.presets.entries()) {
    if (!one || !e.fault.empty() || e.type != type) continue;
    ImGui::PushID(i);
    if (row(ui, "", e.name.c_str(), "", fmt::format("preset/{}", i++)))
      ui.requests.push(UsePreset{e.file, name, {}});
    if (!e.about.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", e.about.c_str());
    ImGui::PopID();
  }
  if (one && i == 0) ImGui::TextDisabled("No preset of this node is kept yet.");
  ImGui::Separator();
  if (one) row(ui, icon::kSave, "presets.keep_parameters");
  row(ui, icon::kSave, "presets.keep_nodes");
  ImGui::EndMenu();
}

void nodeMenu(const GraphRoom& room, const std::string& name) {
  Ui& ui = room.ui;
  Session& session = room.session;
  const nodes::Node* node = nodes::findNode(session.document.graph(), name);
  if (!node) return ImGui::CloseCurrentPopup();
  const nodes::NodeType* type = nodes::findNodeType(node->type);
  const std::size_t count = session.document.selection().size();
  heading(ui.theme, count > 1 ? fmt::format("{} nodes", count) : name,
          count == 1 && type && type->label != name ? type->label : "");
  row(ui, icon::kEye, "graph.view");
  if (isGroup(session, name)) row(ui, icon::kSignIn, "graph.enter");
  row(ui, icon::kPencil, "graph.rename");
  std::string color;
  if (chooseColor(ui, node->color, color)) colorSelection(ui, session, color);
  row(ui, icon::kBan, "graph.bypass");
  row(ui, icon::kPower, "graph.disable");
  presetMenu(room, name, node->type, count == 1);
  ImGui::Separator();
  row(ui, icon::kCut, "edit.cut");
  row(ui, icon::kCopy, "edit.copy");
  row(ui, icon::kClone, "graph.duplicate");
  row(ui, icon::kClone, "graph.duplicate_inputs");
  ImGui::Separator();
  row(ui, icon::kGroup, "graph.group");
  row(ui, icon::kUngroup, "graph.ungroup");
  row(ui, icon::kSquare, "graph.add_frame");
  ImGui::Separator();
  row(ui, icon::kArrowLeft, "graph.upstream");
  row(ui, icon::kArrowRight, "graph.downstream");
  row(ui, icon::kExpand, "graph.frame");
  ImGui::Separator();
  row(ui, icon::kUnlink, "graph.extract");
  row(ui, icon::kTrash, "graph.delete_reconnect");
  row(ui, icon::kTrash, "graph.delete");
}

void linkMenu(Ui& ui, const nodes::Link& link) {
  heading(ui.theme, link.fromNode + " \xe2\x86\x92 " + link.toNode, "");
  row(ui, icon::kPlus, "graph.insert");
  row(ui, icon::kCircle, "graph.dot");
  row(ui, icon::kEyeSlash, "graph.mute");
  ImGui::Separator();
  row(ui, icon::kTrash, "graph.delete");
}

void frameMenu(Ui& ui, Session& session, std::size_t index) {
  const auto& frames = session.document.graph().frames;
  if (index >= frames.size()) return ImGui::CloseCurrentPopup();
  const nodes::Frame frame = frames[index];
  heading(ui.theme, frame.title.empty() ? "Frame" : frame.title, frame.title.empty() ? "" : "Frame");
  row(ui, icon::kPencil, "graph.rename_frame");
  std::string color;
  if (chooseColor(ui, frame.color, color)) setFrameColor(ui, session, index, color);
  row(ui, icon::kList, "graph.select_content");
  ImGui::Separator();
  row(ui, icon::kTrash, "graph.delete");
}

/// Nine rows: view slots with the nodes in them, or bookmarks.
void numbered(Ui& ui, const Session& session, const Shown& shown, const Settings& settings, const char* mark,
              const char* label, const char* id, const char* trace) {
  if (!beginSubmenu(ui, mark, label, trace)) return;
  const bool slots = std::string_view(id) == "graph.slot_", going = std::string_view(id) == "graph.go_";
  for (int i = 1; i <= 9; ++i) {
    const std::string command = fmt::format("{}{}", id, i);
    const std::optional<CommandLook> look = ui.commands(command);
    if (!look) continue;
    const std::string& node = shown.slots[static_cast<std::size_t>(i - 1)];
    const std::string text = slots && !node.empty() ? node : look->label;
    if (row(ui, "", text.c_str(), look->keys, command, false, !going || hasBookmark(session, settings, i)))
      ui.requests.push(RunCommand{command});
  }
  if (slots) row(ui, "", "graph.clear_slots");
  ImGui::EndMenu();
}

void tool(Ui& ui, Canvas& canvas, const char* mark, const char* label, const char* keys, Stroke stroke,
          const char* trace) {
  if (!row(ui, mark, label, keys, trace)) return;
  canvas.interaction.armed = stroke;
  ui.messages.hint(stroke == Stroke::Lasso ? "Drag around nodes to select them; Esc leaves."
                                           : "Drag a line across links; Esc leaves.");
}

void canvasMenu(const GraphRoom& room) {
  row(room.ui, icon::kPlus, "graph.add");
  row(room.ui, icon::kPaste, "edit.paste");
  row(room.ui, icon::kSquare, "graph.add_frame");
  ImGui::Separator();
  tool(room.ui, room.canvas, icon::kCut, "Cut Links", "Ctrl+right drag, Y+drag", Stroke::Cut, "tool/cut");
  tool(room.ui, room.canvas, icon::kEyeSlash, "Mute Links", "Ctrl+Alt+right drag", Stroke::Mute, "tool/mute");
  tool(room.ui, room.canvas, icon::kCircle, "Put Dots on Links", "Shift+right drag", Stroke::Dots,
       "tool/dots");
  tool(room.ui, room.canvas, icon::kExpand, "Lasso Select", "Ctrl+Alt+drag", Stroke::Lasso, "tool/lasso");
  ImGui::Separator();
  row(room.ui, icon::kCheck, "edit.select_all");
  row(room.ui, icon::kExpand, "graph.frame_all");
  numbered(room.ui, room.session, room.shown, room.settings, icon::kBookmark, "Go to Bookmark", "graph.go_",
           "bookmarks");
  numbered(room.ui, room.session, room.shown, room.settings, icon::kBookmark, "Save Bookmark", "graph.save_",
           "save bookmarks");
  numbered(room.ui, room.session, room.shown, room.settings, icon::kEye, "View Slots", "graph.slot_",
           "slots");
  row(room.ui, icon::kSignOut, "graph.leave");
}

}  // namespace

void openCanvasMenu(Canvas& canvas, const Hit& hit, vec2 at) {
  canvas.menuHit = hit;
  canvas.menuAt = at;
  canvas.menuOpening = true;
}

void drawCanvasMenu(const GraphRoom& room) {
  Canvas& canvas = room.canvas;
  if (std::exchange(canvas.menuOpening, false)) {
    ImGui::OpenPopup(kMenu);
    ImGui::SetNextWindowPos({canvas.menuAt.x, canvas.menuAt.y});
  }
  if (!ImGui::BeginPopup(kMenu)) return;
  room.ui.trace.note("canvas menu", canvas.menuHit.node);
  switch (canvas.menuHit.kind) {
    case Hit::Kind::Link:
      linkMenu(room.ui, canvas.menuHit.link);
      break;
    case Hit::Kind::Frame:
      frameMenu(room.ui, room.session, canvas.menuHit.frame);
      break;
    case Hit::Kind::Canvas:
      canvasMenu(room);
      break;
    default:
      nodeMenu(room, canvas.menuHit.node);
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
