#include "editor/menu.h"

#include <imgui.h>

#include "editor/actions.h"
#include "editor/files.h"
#include "editor/graph_view/canvas_view.h"
#include "embedded_presets.h"

namespace pileus::editor {
namespace {

/// "first_light.json" -> "First light".
std::string presetLabel(std::string_view path) {
  std::string label(path.substr(path.find_last_of('/') + 1));
  if (label.ends_with(".json")) label.resize(label.size() - 5);
  for (char& c : label)
    if (c == '_' || c == '-') c = ' ';
  if (!label.empty() && label[0] >= 'a' && label[0] <= 'z')
    label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

void openMenus(Editor& editor) {
  if (ImGui::BeginMenu("Open Recent", !editor.settings.recentFiles.empty())) {
    for (const std::string& path : std::vector<std::string>(editor.settings.recentFiles))
      if (ImGui::MenuItem(path.c_str())) withSavedDocument(editor, [path](Editor& e) { openFile(e, path); });
    ImGui::EndMenu();
  }
  const bool open = ImGui::BeginMenu("Open Preset");
  editor.trace.item("menu/presets");
  if (!open) return;
  for (const EmbeddedFile& file : embedded_presets()) {
    if (file.path.find('/') != std::string_view::npos || !file.path.ends_with(".json")) continue;
    if (ImGui::MenuItem(presetLabel(file.path).c_str()))
      withSavedDocument(editor, [name = std::string(file.path)](Editor& e) { openPreset(e, name); });
    editor.trace.item("preset/" + std::string(file.path));
  }
  ImGui::EndMenu();
}

}  // namespace

float drawMenuBar(Editor& editor) {
  const Theme& theme = editor.theme;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme.space(2), theme.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.space(3), theme.px(6)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(2), theme.space(2)});
  float height = 0;
  if (ImGui::BeginMainMenuBar()) {
    for (const char* menu : {"File", "Edit", "View", "Help"}) {
      const bool open = ImGui::BeginMenu(menu);
      editor.trace.item("menubar/" + std::string(menu));
      if (!open) continue;
      for (const Action& action : allActions()) {
        if (std::string_view(action.menu) != menu) continue;
        if (action.separator) ImGui::Separator();
        actionMenuItem(editor, action.id);
        if (std::string_view(action.id) == "file.open") openMenus(editor);
      }
      ImGui::EndMenu();
    }
    height = ImGui::GetWindowHeight();
    const std::string name = documentName(editor) + (editor.document.dirty() ? " \xe2\x80\xa2" : "");
    const float width = textWidth(theme.small, name), right = ImGui::GetWindowWidth() - theme.space(3);
    if (right - width > ImGui::GetCursorPosX())
      drawText(ImGui::GetWindowDrawList(), theme.small,
               {right - width, 0.5f * (height - theme.small->FontSize)}, palette::kTextDim, name, width + 1);
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar(3);
  return height;
}

}  // namespace pileus::editor
