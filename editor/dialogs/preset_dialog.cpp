#include "editor/dialogs/preset_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/commands/library/presets.h"
#include "editor/dialogs/modal.h"
#include "editor/document/preset_shelf.h"
#include "editor/editor.h"
#include "editor/exchange/requests.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/fields.h"
#include "editor/toolkit/modals.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui_trace.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

const char* titleOf(const PresetDialog& d) {
  if (!d.describing.empty()) return "Describe the preset";
  switch (d.preset.kind) {
    case nodes::PresetKind::Document:
      return "Save the scene as a preset";
    case nodes::PresetKind::Nodes:
      return "Save the nodes as a preset";
    case nodes::PresetKind::Parameters:
      return "Save the parameters as a preset";
  }
  return "";
}

void field(Editor& editor, const char* label, const char* hint, std::string& text, const char* trace) {
  ImGui::TextDisabled("%s", label);
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint((std::string("##") + trace).c_str(), hint, &text);
  editor.trace.item(std::string("preset dialog/") + trace);
  ImGui::Dummy({0, editor.theme.px(2)});
}

/// What the viewport shows, beside the fields.
void drawPicture(Editor& editor, const PresetDialog& d, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = width * 9 / 16;
  ImGui::Dummy({width, height});
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, {at.x + width, at.y + height}, palette::kPictureEmpty, editor.theme.px(4));
  const unsigned texture = editor.shown.displayed.texture;
  if (texture == 0 || d.picture.size.y < 1) return;
  const float own = static_cast<float>(d.picture.size.x) / static_cast<float>(d.picture.size.y);
  ImVec2 a(0, 0), b(1, 1);
  if (own > 16.0f / 9)
    a.x = 0.5f - 8 / (9 * own), b.x = 1 - a.x;
  else
    a.y = 0.5f - 0.5f * own * 9 / 16, b.y = 1 - a.y;
  draw->AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture)), at,
                        {at.x + width, at.y + height}, a, b, IM_COL32_WHITE, editor.theme.px(4));
}

/// Where there is a choice of folders.
void drawFolders(Editor& editor, PresetDialog& d) {
  if (!d.describing.empty() || d.folders.size() < 2) return;
  ImGui::TextDisabled("Folder");
  const auto label = [&](int i) {
    return i == 0 ? std::string("My presets") : d.folders[static_cast<std::size_t>(i)].string();
  };
  if (beginCombo(editor.theme, "##folder", label(d.folder), ImGui::GetContentRegionAvail().x)) {
    for (int i = 0; i < static_cast<int>(d.folders.size()); ++i) {
      if (ImGui::Selectable(label(i).c_str(), i == d.folder)) d.folder = i;
      editor.trace.item("preset dialog/folder/" + std::to_string(i));
    }
    ImGui::EndCombo();
  }
  editor.trace.item("preset dialog/folder");
}

/// What keeps the preset from being written, or what will happen to another one.
std::string warningOf(const Editor& editor, const PresetDialog& d, bool& good) {
  const Result<void> name = nodes::checkPresetName(d.name), about = nodes::checkPresetAbout(d.about);
  good = name && about;
  if (!name) return d.name.empty() ? "" : name.error().message;
  if (!about) return about.error().message;
  if (replacedBy(editor, d).empty()) return {};
  if (!d.describing.empty()) {
    good = false;
    return "There is a preset of this name in the folder.";
  }
  return "Replaces the preset of this name. It can be undone.";
}

}  // namespace

void drawPresetDialog(Editor& editor) {
  PresetDialog& d = editor.presetDialog;
  const Theme& theme = editor.theme;
  if (!beginModal(editor, "Preset", editor.modals.preset, 680)) return;
  heading(editor, titleOf(d));
  const bool pictured = d.describing.empty();
  if (pictured) {
    drawPicture(editor, d, theme.px(240));
    ImGui::SameLine(0, theme.space(4));
  }
  ImGui::BeginGroup();
  ImGui::PushItemWidth(-1);
  if (ImGui::IsWindowAppearing()) editor.fields.focusHere();
  field(editor, "Name", "What it is called in the gallery", d.name, "name");
  field(editor, "Sentence", "What it shows", d.about, "about");
  field(editor, "Tags", "Words to find it by, with commas between: evening, cloud", d.tags, "tags");
  drawFolders(editor, d);
  ImGui::PopItemWidth();
  ImGui::EndGroup();
  bool good = false;
  const std::string warning = warningOf(editor, d, good);
  const bool replaces = good && !warning.empty();
  if (!d.error.empty() || !warning.empty()) {
    ImGui::PushTextWrapPos();
    ImGui::PushStyleColor(ImGuiCol_Text, d.error.empty() ? palette::kWarning : palette::kError);
    ImGui::TextUnformatted(
        (d.error.empty() ? warning : d.error + ". Nothing is lost: what was there is as it was.").c_str());
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    editor.trace.note("preset dialog", d.error.empty() ? warning : d.error);
  }
  ImGui::Dummy({0, theme.space(2)});
  const bool busy = editor.presets.changing();
  ImGui::BeginDisabled(!good || busy);
  const char* label = busy ? "Savingâ¦" : replaces ? "Replace" : "Save";
  const bool pressed = button(editor, label, "preset/save", true) || pressedEnter();
  ImGui::EndDisabled();
  if (pressed && good && !busy) editor.requests.push([&editor] { keepPreset(editor); });
  ImGui::SameLine();
  if (button(editor, "Cancel", "preset/cancel") || (pressedEscape() && !busy)) editor.modals.preset = false;
  if (!editor.modals.preset) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace pileus::editor
