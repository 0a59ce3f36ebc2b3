#include "editor/commands/menu.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>  // menu rows with icons
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "editor/commands/actions.h"
#include "editor/commands/files.h"
#include "editor/commands/look.h"
#include "editor/commands/panel_commands.h"
#include "editor/document/preset_shelf.h"
#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/preferences/settings.h"
#include "editor/start/start_view.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/ui_trace.h"
#include "embedded_presets.h"

namespace pileus::editor {
namespace {

void openMenus(Editor& editor) {
  std::vector<std::string>& recent = editor.settings.recentFiles;
  const bool list = ImGui::BeginMenuEx("Open Recent", icon::kClock, !recent.empty());
  editor.trace.item("menu/recent");
  if (list) {
    MenuBar& bar = editor.menuBar;
    if (!std::exchange(bar.recentOpen, true) || bar.recentThere.size() != recent.size()) {
      bar.recentThere.clear();
      std::error_code ec;
      for (const std::string& path : recent) bar.recentThere.push_back(std::filesystem::exists(path, ec));
    }
    for (std::size_t i = 0; i < recent.size(); ++i) {
      const std::filesystem::path path = recent[i];
      // The folder stands where other rows have their key: dimmed, at the right.
      ImGui::PushID(static_cast<int>(i));
      if (ImGui::MenuItem(path.filename().c_str(), path.parent_path().c_str(), false,
                          bar.recentThere[i] != 0))
        editor.requests.push(OpenFile{path});
      editor.trace.item(fmt::format("recent/{}", i));
      if (!bar.recentThere[i] && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("This file is no longer there.");
      ImGui::PopID();
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Clear List")) recent.clear();
    editor.trace.item("recent/clear");
    ImGui::EndMenu();
  } else {
    editor.menuBar.recentOpen = false;
  }
  const bool presets = ImGui::BeginMenuEx("Open Preset", icon::kCloud);
  editor.trace.item("menu/presets");
  if (!presets) return;
  for (const EmbeddedFile& file : embedded_presets()) {
    if (file.path.find('/') != std::string_view::npos || !file.path.ends_with(".json")) continue;
    if (ImGui::MenuItem(presetLabel(file.path).c_str()))
      editor.requests.push(OpenPreset{std::string(file.path)});
    editor.trace.item("preset/" + std::string(file.path));
  }
  bool any = false;
  for (const nodes::PresetEntry& e : editor.presets.entries()) {
    if (!e.fault.empty() || e.kind != nodes::PresetKind::Document) continue;
    if (!std::exchange(any, true)) ImGui::Separator();
    ImGui::PushID(e.file.c_str());
    if (ImGui::MenuItem(e.name.c_str())) editor.requests.push(UsePreset{e.file, {}, {}});
    editor.trace.item("preset/" + e.name);
    ImGui::PopID();
  }
  ImGui::EndMenu();
}

/// The user's own layouts, after the built-in ones of the table.
void ownLayouts(Editor& editor) {
  std::vector<NamedLayout>& own = editor.settings.layouts;
  ImGui::Separator();
  std::string chosen;
  for (const NamedLayout& l : own) {
    if (ImGui::MenuItem(l.name.c_str(), nullptr,
                        l.panels == static_cast<const PanelLayout&>(editor.settings)))
      chosen = l.name;
    editor.trace.item("layout/" + l.name);
  }
  if (!chosen.empty()) useLayout(editor, chosen);
  if (ImGui::BeginMenu("Save Layout As")) {
    std::string& name = editor.menuBar.layoutName;
    ImGui::SetNextItemWidth(editor.theme.px(180));
    if (ImGui::IsWindowAppearing()) editor.fields.focusHere();
    bool keep = ImGui::InputTextWithHint("##name", "Name", &name, ImGuiInputTextFlags_EnterReturnsTrue);
    editor.trace.item("layout name");
    ImGui::SameLine();
    keep |= ImGui::Button("Save");
    if (keep && !name.empty()) {
      keepLayout(own, name, editor.settings);
      editor.messages.note("Kept the layout as " + name + ".");
      name.clear();
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndMenu();
  }
  editor.trace.item("menu/save layout");
  if (ImGui::BeginMenu("Delete Layout", !own.empty())) {
    for (std::size_t i = 0; i < own.size(); ++i)
      if (ImGui::MenuItem(own[i].name.c_str())) own.erase(own.begin() + static_cast<std::ptrdiff_t>(i--));
    ImGui::EndMenu();
  }
}

void scaleMenu(Editor& editor) {
  ImGui::Separator();
  for (const float scale : uiScaleSteps()) {
    const std::string label = fmt::format("{:.0f} %", scale * 100);
    if (ImGui::MenuItem(label.c_str(), nullptr, std::abs(editor.now.uiScale - scale) < 0.005f))
      chooseUiScale(editor, scale);
    editor.trace.item("scale/" + label);
  }
}

void drawMenu(Editor& editor, std::string_view path);

/// The menus within `path` that have not been drawn yet open where their first action stands.
void drawSubmenu(Editor& editor, std::string_view path) {
  const std::string label(path.substr(path.find('/') + 1));
  const bool open = ImGui::BeginMenu(label.c_str());
  editor.trace.item("menu/" + label);
  if (!open) return;
  drawMenu(editor, path);
  if (label == "Layouts") ownLayouts(editor);
  if (label == "Interface Scale") scaleMenu(editor);
  ImGui::EndMenu();
}

void drawMenu(Editor& editor, std::string_view path) {
  std::vector<std::string_view> drawn;
  bool any = false;
  for (const Action& action : allActions()) {
    const std::string_view place = menuOf(action);
    const bool deeper = place.size() > path.size() && place.starts_with(path) && place[path.size()] == '/';
    if (place != path && !deeper) continue;
    if (deeper && std::find(drawn.begin(), drawn.end(), place) != drawn.end()) continue;
    if (action.separator && any && (!deeper)) ImGui::Separator();
    any = true;
    if (deeper) {
      drawn.push_back(place);
      drawSubmenu(editor, place);
    } else {
      commandMenuItem(editor.ui, action.id);
      if (std::string_view(action.id) == "file.open") openMenus(editor);
    }
  }
}

/// The document's name at the right end of the bar.
void drawName(Editor& editor, float height) {
  const Theme& theme = editor.theme;
  const std::string name =
      documentName(editor.session) + (editor.session.document.dirty() ? " \xe2\x80\xa2" : "");
  const float width = textWidth(theme.small, name), right = ImGui::GetWindowWidth() - theme.space(3);
  if (right - width > ImGui::GetCursorPosX())
    drawText(ImGui::GetWindowDrawList(), theme.small,
             {right - width, 0.5f * (height - theme.small->FontSize)}, palette::kTextDim, name, width + 1);
}

}  // namespace

std::string_view menuOf(const Action& action) {
  const std::string_view menu = action.menu;
  if (menu == "View" && action.panel == Panel::Graph) return "Graph";
  if (menu == "View" && action.panel == Panel::Viewport) return "Viewport";
  return menu;
}

const char* actionIcon(std::string_view id) {
  constexpr std::pair<std::string_view, const char*> kIcons[] = {
      {"file.new", icon::kFile},
      {"file.open", icon::kFolderOpen},
      {"file.save", icon::kSave},
      {"file.export", icon::kPicture},
      {"file.quit", icon::kPower},
      {"edit.undo", icon::kUndo},
      {"edit.redo", icon::kRedo},
      {"edit.cut", icon::kCut},
      {"edit.copy", icon::kCopy},
      {"edit.paste", icon::kPaste},
      {"graph.duplicate", icon::kClone},
      {"graph.delete", icon::kTrash},
      {"graph.add", icon::kPlus},
      {"graph.bypass", icon::kBan},
      {"graph.rename", icon::kPencil},
      {"graph.view", icon::kEye},
      {"graph.frame_all", icon::kExpand},
      {"viewport.frame", icon::kExpand},
      {"viewport.compare", icon::kAdjust},
      {"viewport.pick_ray", icon::kCrosshairs},
      {"viewport.reset_camera", icon::kCamera},
      {"view.pause", icon::kPause},
      {"view.theme", icon::kMoon},
      {"view.maximise", icon::kExpand},
      {"help.commands", icon::kSearch},
      {"help.shortcuts", icon::kKeyboard},
      {"help.about", icon::kInfo},
  };
  for (const auto& [name, mark] : kIcons)
    if (name == id) return mark;
  return nullptr;
}

std::string presetLabel(std::string_view path) {
  for (const PresetText& text : galleryTexts())
    if (path.substr(path.find_last_of('/') + 1) == text.file) return text.name;
  std::string label(path.substr(path.find_last_of('/') + 1));
  if (label.ends_with(".json")) label.resize(label.size() - 5);
  for (char& c : label)
    if (c == '_' || c == '-') c = ' ';
  if (!label.empty() && label[0] >= 'a' && label[0] <= 'z')
    label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

float drawMenuBar(Editor& editor) {
  const Theme& theme = editor.theme;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme.space(2), theme.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.space(3), theme.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(2), theme.space(2)});
  float height = 0;
  if (ImGui::BeginMainMenuBar()) {
    for (const char* menu : kMenus) {
      const bool open = ImGui::BeginMenu(menu);
      editor.trace.item("menubar/" + std::string(menu));
      if (!open) continue;
      drawMenu(editor, menu);
      ImGui::EndMenu();
    }
    height = ImGui::GetWindowHeight();
    drawName(editor, height);
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar(3);
  return height;
}

}  // namespace pileus::editor
