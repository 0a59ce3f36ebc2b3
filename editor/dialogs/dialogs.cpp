#include "editor/dialogs/dialogs.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "editor/commands/files.h"
#include "editor/commands/relink.h"
#include "editor/commands/shortcut_sheet.h"
#include "editor/dialogs/modal.h"
#include "editor/dialogs/preset_dialog.h"
#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/exchange/requests.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/modals.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui_trace.h"
#include "editor/toolkit/window.h"

namespace pileus::editor {
namespace {

void drawUnsaved(Editor& editor) {
  Modals& d = editor.modals;
  if (!beginModal(editor, "Unsaved changes", static_cast<bool>(d.afterUnsaved), 460)) return;
  heading(editor, ("Save changes to " + documentName(editor.session) + "?").c_str());
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted("What you changed since it was last saved is lost otherwise.");
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, editor.theme.space(2)});
  const auto close = [&] {
    ImGui::CloseCurrentPopup();
    return std::exchange(d.afterUnsaved, nullptr);
  };
  if (button(editor, "Save", "save", true) || pressedEnter())
    editor.requests.push([&editor, then = close()] { save(editor, then); });
  ImGui::SameLine();
  if (button(editor, "Discard", "discard")) editor.requests.push(close());
  ImGui::SameLine();
  if (button(editor, "Cancel", "cancel") || pressedEscape()) close();
  ImGui::EndPopup();
}

void drawFaults(Editor& editor) {
  Modals& d = editor.modals;
  if (!beginModal(editor, "Faults", !d.faults.empty(), 640)) return;
  heading(editor, (d.faultsOf + " was opened with some faults").c_str());
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(
      "What could not be understood is kept as far as possible and written back when you save.");
  ImGui::PopTextWrapPos();
  ImGui::BeginChild(
      "list", {0, editor.theme.px(std::min(260.0f, 30.0f + 26.0f * static_cast<float>(d.faults.size())))},
      true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  for (const Modals::Fault& f : d.faults) {
    ImGui::PushStyleColor(ImGuiCol_Text, f.error ? palette::kError : palette::kWarning);
    ImGui::TextUnformatted(f.error ? icon::kError : icon::kWarning);
    ImGui::PopStyleColor();
    ImGui::SameLine(0, editor.theme.space(2));
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(f.text.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::EndChild();
  if (button(editor, "Close", "close", true) || pressedEnter() || pressedEscape()) {
    d.faults.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void drawMissing(Editor& editor) {
  Modals& d = editor.modals;
  if (!beginModal(editor, "Missing files", !d.missing.empty(), 640)) return;
  heading(editor, d.missing.size() == 1 ? "A file is missing" : "Some files are missing");
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted("What is found in a folder or below it by its name is taken from there.");
  ImGui::PopTextWrapPos();
  const float line = ImGui::GetTextLineHeightWithSpacing(), most = ImGui::GetIO().DisplaySize.y * 0.4f;
  ImGui::BeginChild("list", {0, std::min(most, line * (2 * static_cast<float>(d.missing.size()) + 0.8f))},
                    true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  for (const Modals::Missing& m : d.missing) {
    ImGui::TextUnformatted(m.where.c_str());
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::TextDisabled("%s", endOfPath(editor.theme.body, m.path, room).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", m.path.c_str());
    editor.trace.note("missing " + m.where, m.path);
  }
  ImGui::EndChild();
  const auto close = [&] {
    d.missing.clear();
    ImGui::CloseCurrentPopup();
  };
  if (button(editor, "Find in Folder\xe2\x80\xa6", "relink", true) || pressedEnter()) {
    editor.requests.push([&editor] { askRelink(editor); });
    close();
  }
  ImGui::SameLine();
  if (button(editor, "Close", "close") || pressedEscape()) close();
  ImGui::EndPopup();
}

void drawError(Editor& editor) {
  Modals& d = editor.modals;
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

void drawShortcuts(Editor& editor) {
  Modals& d = editor.modals;
  const float room = (ImGui::GetIO().DisplaySize.x - editor.theme.space(10)) / editor.theme.scale;
  if (!beginModal(editor, "Shortcuts", d.shortcuts, std::min(1120.0f, room))) return;
  heading(editor, "Keyboard and mouse");
  drawShortcutSheet(editor);
  ImGui::Dummy({0, editor.theme.space(1)});
  if (button(editor, "Close", "close", true) || pressedEnter() || pressedEscape()) {
    d.shortcuts = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

struct Fact {
  const char* what;
  std::string value;
};

std::vector<Fact> facts(const Editor& editor) {
  const gl::DeviceInfo& device = editor.shown.renderer.device();
  const ivec2 size = editor.window.size();
  return {{"Version", PILEUS_VERSION},
          {"Graphics", device.renderer + (device.software ? " (software)" : "")},
          {"Driver", device.vendor + ", OpenGL " + device.version},
          {"Window", fmt::format("{} x {} at {:.0f} %, GLFW {}", size.x, size.y, editor.theme.scale * 100,
                                 Window::systemVersion())},
          {"Interface", std::string("Dear ImGui ") + ImGui::GetVersion()},
          {"Textures", fmt::format("{} in 2D, {} in 3D, {} layers", device.maxTextureSize,
                                   device.max3dTextureSize, device.maxArrayLayers)}};
}

void drawAbout(Editor& editor) {
  Modals& d = editor.modals;
  const Theme& theme = editor.theme;
  if (!beginModal(editor, "About", d.about, 560)) return;
  heading(editor, "Pileus");
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted("A node-graph editor for volumetric lighting.");
  ImGui::Dummy({0, theme.space(1)});
  const std::vector<Fact> all = facts(editor);
  for (const Fact& f : all) {
    ImGui::TextDisabled("%s", f.what);
    ImGui::SameLine(theme.px(120));
    ImGui::TextUnformatted(f.value.c_str());
  }
  ImGui::Dummy({0, theme.space(1)});
  ImGui::PushFont(theme.small);
  ImGui::TextDisabled(
      "Licensed under the Apache License 2.0. Fonts: Inter and JetBrains Mono, Fork Awesome (SIL Open Font "
      "License 1.1).");
  ImGui::PopFont();
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, theme.space(2)});
  if (button(editor, "Close", "close", true) || pressedEnter() || pressedEscape()) {
    d.about = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine();
  if (button(editor, "Copy", "copy")) {
    std::string text = "Pileus\n";
    for (const Fact& f : all) text += std::string(f.what) + ": " + f.value + "\n";
    ImGui::SetClipboardText(text.c_str());
    editor.messages.note("Copied: for a bug report, say.");
  }
  ImGui::EndPopup();
}

}  // namespace

void drawDialogs(Editor& editor) {
  // One at a time: two would close each other. The others come back once it is answered.
  Modals& m = editor.modals;
  if (!m.errorText.empty()) return drawError(editor);
  if (m.afterUnsaved) return drawUnsaved(editor);
  if (!m.faults.empty()) return drawFaults(editor);
  if (!m.missing.empty()) return drawMissing(editor);
  if (m.questions.open()) return drawQuestions(editor.ui, m.questions);
  if (m.preset) return drawPresetDialog(editor);
  if (m.shortcuts) return drawShortcuts(editor);
  if (m.about) return drawAbout(editor);
  m.browser.draw(editor.ui, editor.settings, editor.window.keys(),
                 editor.session.document.path().parent_path());
}

}  // namespace pileus::editor
