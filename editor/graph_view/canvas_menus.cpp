#include "editor/graph_view/canvas_menus.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>  // MenuItemEx, BeginMenuEx: rows with icons

#include "editor/app/editor.h"
#include "editor/commands/actions.h"
#include "editor/graph_view/bookmarks.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/frames.h"
#include "editor/graph_view/node_colors.h"
#include "editor/graph_view/scopes.h"
#include "editor/toolkit/icons.h"

namespace pileus::editor {
namespace {

constexpr char kMenu[] = "##canvas menu";
constexpr char kRoomForSwatch[] = "     ";

bool row(Editor& editor, const char* mark, const char* label, const std::string& keys,
         const std::string& trace, bool checked = false, bool enabled = true) {
  const bool chosen = ImGui::MenuItemEx(label, mark, keys.c_str(), checked, enabled);
  editor.trace.item("menu/" + trace);
  return chosen;
}

/// A row of the table of commands.
void row(Editor& editor, const char* mark, std::string_view id) {
  const Action* a = findAction(id);
  if (!a) return;
  const bool enabled = !a->enabled || a->enabled(editor);
  if (row(editor, mark, a->label, shortcutText(a->keys[0]), std::string(id), a->checked && a->checked(editor),
          enabled))
    a->run(editor);
}

bool beginSubmenu(Editor& editor, const char* mark, const char* label, const char* trace,
                  bool enabled = true) {
  const bool open = ImGui::BeginMenuEx(label, mark, enabled);
  editor.trace.item(std::string("menu/") + trace);
  return open;
}

void heading(const Editor& editor, const std::string& title, const std::string& below) {
  ImGui::PushFont(editor.theme.strong);
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  if (!below.empty()) ImGui::TextDisabled("%s", below.c_str());
  ImGui::Separator();
}

/// Swatches of the colours a node or frame may take; returns whether one was chosen.
bool chooseColor(Editor& editor, const std::string& current, std::string& chosen) {
  bool any = false;
  if (!beginSubmenu(editor, icon::kPaint, "Colour", "color")) return false;
  for (const NodeColor& color : nodeColors()) {
    ImGui::PushID(color.id);
    if (row(editor, kRoomForSwatch, color.label, "", std::string("color/") + color.id, current == color.id)) {
      chosen = color.id;
      any = true;
    }
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    const float size = editor.theme.px(14), y = 0.5f * (lo.y + hi.y - size);
    if (*color.id)
      ImGui::GetWindowDrawList()->AddRectFilled({lo.x + editor.theme.px(2), y},
                                                {lo.x + editor.theme.px(2) + size, y + size},
                                                nodeColor(color.id), editor.theme.px(3));
    ImGui::PopID();
  }
  ImGui::EndMenu();
  return any;
}

void nodeMenu(Editor& editor, const std::string& name) {
  const nodes::Node* node = nodes::findNode(editor.document.graph(), name);
  if (!node) return ImGui::CloseCurrentPopup();
  const nodes::NodeType* type = nodes::findNodeType(node->type);
  const std::size_t count = editor.document.selection().size();
  heading(editor, count > 1 ? fmt::format("{} nodes", count) : name,
          count == 1 && type && type->label != name ? type->label : "");
  row(editor, icon::kEye, "graph.view");
  if (isGroup(editor, name)) row(editor, icon::kSignIn, "graph.enter");
  row(editor, icon::kPencil, "graph.rename");
  std::string color;
  if (chooseColor(editor, node->color, color)) colorSelection(editor, color);
  row(editor, icon::kBan, "graph.bypass");
  row(editor, icon::kPower, "graph.disable");
  ImGui::Separator();
  row(editor, icon::kCut, "edit.cut");
  row(editor, icon::kCopy, "edit.copy");
  row(editor, icon::kClone, "graph.duplicate");
  row(editor, icon::kClone, "graph.duplicate_inputs");
  ImGui::Separator();
  row(editor, icon::kGroup, "graph.group");
  row(editor, icon::kUngroup, "graph.ungroup");
  row(editor, icon::kSquare, "graph.add_frame");
  ImGui::Separator();
  row(editor, icon::kArrowLeft, "graph.upstream");
  row(editor, icon::kArrowRight, "graph.downstream");
  row(editor, icon::kExpand, "graph.frame");
  ImGui::Separator();
  row(editor, icon::kUnlink, "graph.extract");
  row(editor, icon::kTrash, "graph.delete_reconnect");
  row(editor, icon::kTrash, "graph.delete");
}

void linkMenu(Editor& editor, const nodes::Link& link) {
  heading(editor, link.fromNode + " \xe2\x86\x92 " + link.toNode, "");
  row(editor, icon::kPlus, "graph.insert");
  row(editor, icon::kCircle, "graph.dot");
  row(editor, icon::kEyeSlash, "graph.mute");
  ImGui::Separator();
  row(editor, icon::kTrash, "graph.delete");
}

void frameMenu(Editor& editor, std::size_t index) {
  const auto& frames = editor.document.graph().frames;
  if (index >= frames.size()) return ImGui::CloseCurrentPopup();
  const nodes::Frame frame = frames[index];
  heading(editor, frame.title.empty() ? "Frame" : frame.title, frame.title.empty() ? "" : "Frame");
  row(editor, icon::kPencil, "graph.rename_frame");
  std::string color;
  if (chooseColor(editor, frame.color, color)) setFrameColor(editor, index, color);
  row(editor, icon::kList, "graph.select_content");
  ImGui::Separator();
  row(editor, icon::kTrash, "graph.delete");
}

/// Nine rows: view slots with the nodes in them, or bookmarks.
void numbered(Editor& editor, const char* mark, const char* label, const char* id, const char* trace) {
  if (!beginSubmenu(editor, mark, label, trace)) return;
  const bool slots = std::string_view(id) == "graph.slot_", going = std::string_view(id) == "graph.go_";
  for (int i = 1; i <= 9; ++i) {
    const Action* a = findAction(fmt::format("{}{}", id, i));
    if (!a) continue;
    const std::string& node = editor.canvas.slots[static_cast<std::size_t>(i - 1)];
    const std::string text = slots && !node.empty() ? node : a->label;
    if (row(editor, "", text.c_str(), shortcutText(a->keys[0]), a->id, false,
            !going || hasBookmark(editor, i)))
      a->run(editor);
  }
  if (slots) row(editor, "", "graph.clear_slots");
  ImGui::EndMenu();
}

void tool(Editor& editor, const char* mark, const char* label, const char* keys, Stroke stroke,
          const char* trace) {
  if (!row(editor, mark, label, keys, trace)) return;
  editor.canvas.interaction.armed = stroke;
  editor.messages.hint(stroke == Stroke::Lasso ? "Drag around nodes to select them; Esc leaves."
                                               : "Drag a line across links; Esc leaves.");
}

void canvasMenu(Editor& editor) {
  row(editor, icon::kPlus, "graph.add");
  row(editor, icon::kPaste, "edit.paste");
  row(editor, icon::kSquare, "graph.add_frame");
  ImGui::Separator();
  tool(editor, icon::kCut, "Cut Links", "Ctrl+right drag, Y+drag", Stroke::Cut, "tool/cut");
  tool(editor, icon::kEyeSlash, "Mute Links", "Ctrl+Alt+right drag", Stroke::Mute, "tool/mute");
  tool(editor, icon::kCircle, "Put Dots on Links", "Shift+right drag", Stroke::Dots, "tool/dots");
  tool(editor, icon::kExpand, "Lasso Select", "Ctrl+Alt+drag", Stroke::Lasso, "tool/lasso");
  ImGui::Separator();
  row(editor, icon::kCheck, "edit.select_all");
  row(editor, icon::kExpand, "graph.frame_all");
  numbered(editor, icon::kBookmark, "Go to Bookmark", "graph.go_", "bookmarks");
  numbered(editor, icon::kBookmark, "Save Bookmark", "graph.save_", "save bookmarks");
  numbered(editor, icon::kEye, "View Slots", "graph.slot_", "slots");
  row(editor, icon::kSignOut, "graph.leave");
}

}  // namespace

void openCanvasMenu(Editor& editor, const Hit& hit, vec2 at) {
  editor.canvas.menuHit = hit;
  editor.canvas.menuAt = at;
  editor.canvas.menuOpening = true;
}

void drawCanvasMenu(Editor& editor) {
  Canvas& canvas = editor.canvas;
  if (std::exchange(canvas.menuOpening, false)) {
    ImGui::OpenPopup(kMenu);
    ImGui::SetNextWindowPos({canvas.menuAt.x, canvas.menuAt.y});
  }
  if (!ImGui::BeginPopup(kMenu)) return;
  editor.trace.note("canvas menu", canvas.menuHit.node);
  switch (canvas.menuHit.kind) {
    case Hit::Kind::Link:
      linkMenu(editor, canvas.menuHit.link);
      break;
    case Hit::Kind::Frame:
      frameMenu(editor, canvas.menuHit.frame);
      break;
    case Hit::Kind::Canvas:
      canvasMenu(editor);
      break;
    default:
      nodeMenu(editor, canvas.menuHit.node);
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
