#include "editor/dialogs.h"

#include <imgui.h>

#include <algorithm>

#include "editor/actions.h"
#include "editor/files.h"
#include "editor/icons.h"

namespace pileus::editor {
namespace {

/// Opens when `wanted` and draws a centred modal; call endModal() when it returns true.
bool beginModal(const Editor& editor, const char* title, bool wanted, float width) {
  if (wanted && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.46f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({editor.theme.px(width), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {editor.theme.space(5), editor.theme.space(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, editor.theme.px(8));
  const bool open = ImGui::BeginPopupModal(
      title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar(2);
  return open;
}

void heading(const Editor& editor, const char* text) {
  ImGui::PushFont(editor.theme.title);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
  ImGui::Dummy({0, editor.theme.px(2)});
}

bool button(Editor& editor, const char* label, const char* trace, bool primary = false) {
  if (primary) {
    ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::kFieldFillHover);
  }
  const bool pressed = ImGui::Button(label, {editor.theme.px(124), 0});
  if (primary) ImGui::PopStyleColor(2);
  editor.trace.item(std::string("dialog/") + trace);
  return pressed;
}

bool pressedEnter() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) && !ImGui::IsWindowAppearing();
}
bool pressedEscape() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) && !ImGui::IsWindowAppearing();
}

void drawUnsaved(Editor& editor) {
  Dialogs& d = editor.dialogs;
  if (!beginModal(editor, "Unsaved changes", static_cast<bool>(d.afterUnsaved), 460)) return;
  heading(editor, ("Save changes to " + documentName(editor) + "?").c_str());
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted("What you changed since it was last saved is lost otherwise.");
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, editor.theme.space(2)});
  const auto close = [&] {
    ImGui::CloseCurrentPopup();
    return std::exchange(d.afterUnsaved, nullptr);
  };
  if (button(editor, "Save", "save", true) || pressedEnter()) save(editor, close());
  ImGui::SameLine();
  if (button(editor, "Discard", "discard")) close()(editor);
  ImGui::SameLine();
  if (button(editor, "Cancel", "cancel") || pressedEscape()) close();
  ImGui::EndPopup();
}

void drawFaults(Editor& editor) {
  Dialogs& d = editor.dialogs;
  if (!beginModal(editor, "Faults", !d.faults.empty(), 640)) return;
  heading(editor, (d.faultsOf + " was opened with some faults").c_str());
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(
      "What could not be understood is kept as far as possible and written back when you save.");
  ImGui::PopTextWrapPos();
  ImGui::BeginChild(
      "list", {0, editor.theme.px(std::min(260.0f, 30.0f + 26.0f * static_cast<float>(d.faults.size())))},
      true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  for (const nodes::Fault& f : d.faults) {
    ImGui::PushStyleColor(ImGuiCol_Text, f.error ? palette::kError : palette::kWarning);
    ImGui::TextUnformatted(f.error ? icon::kError : icon::kWarning);
    ImGui::PopStyleColor();
    ImGui::SameLine(0, editor.theme.space(2));
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted((f.where.empty() ? f.text : f.where + ": " + f.text).c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::EndChild();
  if (button(editor, "Close", "close", true) || pressedEnter() || pressedEscape()) {
    d.faults.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void drawError(Editor& editor) {
  Dialogs& d = editor.dialogs;
  if (!beginModal(editor, "Error", !d.errorText.empty(), 520)) return;
  heading(editor, d.errorTitle.c_str());
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(d.errorText.c_str());
  ImGui::PopTextWrapPos();
  editor.trace.note("dialog error", d.errorText);
  ImGui::Dummy({0, editor.theme.space(2)});
  if (button(editor, "Close", "close", true) || pressedEnter() || pressedEscape()) {
    d.errorText.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void shortcutRow(const Editor& editor, const char* label, const std::string& keys) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(label);
  ImGui::TableNextColumn();
  ImGui::PushFont(editor.theme.small);
  ImGui::TextDisabled("%s", keys.c_str());
  ImGui::PopFont();
}

void section(const Editor& editor, const char* title) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(editor.theme.strong);
  ImGui::TextUnformatted(title);
  ImGui::PopFont();
  ImGui::TableNextColumn();
}

void panelShortcuts(const Editor& editor, Panel panel, const char* title) {
  section(editor, title);
  for (const Action& a : allActions()) {
    if (a.panel != panel) continue;
    std::string keys;
    for (const Shortcut& s : a.keys)
      if (s.key) keys += (keys.empty() ? "" : ", ") + shortcutText(s);
    if (!keys.empty()) shortcutRow(editor, a.label, keys);
  }
}

void drawShortcuts(Editor& editor) {
  Dialogs& d = editor.dialogs;
  if (!beginModal(editor, "Shortcuts", d.shortcuts, 760)) return;
  heading(editor, "Keyboard and mouse");
  ImGui::TextDisabled("Keys act on the panel under the pointer.");
  const float height = std::min(editor.theme.px(520), ImGui::GetIO().DisplaySize.y * 0.68f);
  ImGui::BeginChild("sheet", {0, height});
  for (const int column : {0, 1}) {
    if (column == 1) ImGui::SameLine();
    ImGui::BeginChild(column ? "right" : "left", {column ? 0 : ImGui::GetContentRegionAvail().x * 0.5f, 0});
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingStretchProp)) {
      if (column == 0) {
        panelShortcuts(editor, Panel::Global, "Everywhere");
      } else {
        panelShortcuts(editor, Panel::Graph, "Graph");
        shortcutRow(editor, "Pan", "Middle drag, Alt+drag");
        shortcutRow(editor, "Zoom", "Wheel, Alt+right drag");
        shortcutRow(editor, "Add to, remove from selection", "Shift, Ctrl");
        panelShortcuts(editor, Panel::Viewport, "Viewport");
        shortcutRow(editor, "Orbit", "Drag, Alt+drag");
        shortcutRow(editor, "Pan", "Middle drag, Shift+drag");
        shortcutRow(editor, "Dolly", "Wheel, right drag");
        section(editor, "Values");
        shortcutRow(editor, "Fine, round steps", "Shift, Ctrl while dragging");
        shortcutRow(editor, "Type", "Double click, Ctrl+click");
      }
      ImGui::EndTable();
    }
    ImGui::EndChild();
  }
  ImGui::EndChild();
  if (button(editor, "Close", "close", true) || pressedEnter() || pressedEscape()) {
    d.shortcuts = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void drawAbout(Editor& editor) {
  Dialogs& d = editor.dialogs;
  if (!beginModal(editor, "About", d.about, 440)) return;
  heading(editor, "Pileus");
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted("A node-graph editor for volumetric lighting.");
  ImGui::TextDisabled(
      "Licensed under the Apache License 2.0. Fonts: Inter and JetBrains Mono (SIL Open Font License 1.1), "
      "Fork Awesome (SIL Open Font License 1.1).");
  ImGui::Dummy({0, editor.theme.px(2)});
  const gl::DeviceInfo& device = editor.renderer->device();
  ImGui::TextDisabled("%s\nOpenGL %s", device.renderer.c_str(), device.version.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, editor.theme.space(2)});
  if (button(editor, "Close", "close", true) || pressedEnter() || pressedEscape()) {
    d.about = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace

void drawDialogs(Editor& editor) {
  drawUnsaved(editor);
  drawFaults(editor);
  drawError(editor);
  drawShortcuts(editor);
  drawAbout(editor);
}

}  // namespace pileus::editor
