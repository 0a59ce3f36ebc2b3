#include "editor/toolkit/ui.h"

#include <imgui.h>
#include <imgui_internal.h>  // menu rows with icons

namespace pileus::editor {

void commandMenuItem(Ui& ui, std::string_view id) {
  const std::optional<CommandLook> look = ui.commands(id);
  if (!look) return;
  if (ImGui::MenuItemEx(look->label, look->icon, look->keys.c_str(), look->checked, look->enabled))
    ui.requests.push(RunCommand{std::string(id)});
  ui.trace.item("menu/" + std::string(id));
}

}  // namespace pileus::editor
