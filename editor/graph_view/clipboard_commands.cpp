// Copies of nodes: through the system's clipboard as JSON text, or beside the originals.
#include <imgui.h>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_commands.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/graph_edits.h"

namespace pileus::editor {
namespace {

constexpr double kStep = 40;  // canvas units between copies of one thing

std::string named(const char* verb, const std::set<std::string>& names) {
  return verb + (names.size() == 1 ? " " + *names.begin() : std::string(" nodes"));
}

/// Where the next paste goes: at the pointer, a step further for each one in the same place.
dvec2 pastePlace(Canvas& canvas) {
  const dvec2 at = canvas.pointerInside ? dvec2(canvas.pointer) : canvas.center;
  canvas.pastes = canvas.pastes > 0 && glm::length(at - canvas.pastedAt) < 2 ? canvas.pastes + 1 : 1;
  canvas.pastedAt = at;
  return at + dvec2(kStep * (canvas.pastes - 1));
}

}  // namespace

void copySelection(Editor& editor) {
  const std::set<std::string>& names = editor.document.selection();
  if (names.empty()) return editor.messages.hint("Select the nodes to copy.");
  ImGui::SetClipboardText(nodes::copyText(editor.document.graph(), names).c_str());
  editor.messages.note(named("Copied", names));
  editor.canvas.pastes = 0;
}

void cutSelection(Editor& editor) {
  const std::set<std::string> names = editor.document.selection();
  if (names.empty()) return editor.messages.hint("Select the nodes to cut.");
  copySelection(editor);
  if (tryEdit(editor, nodes::removeNodes(editor.document.graph(), names, true), named("Cut", names)))
    editor.messages.note(named("Cut", names));
}

void pasteNodes(Editor& editor) {
  const char* text = ImGui::GetClipboardText();
  if (!text || !*text) return editor.messages.hint("The clipboard is empty: copy some nodes first.");
  if (std::string_view(text).find("\"pileus\"") == std::string_view::npos)
    return editor.messages.hint("The clipboard holds other text, but no Pileus nodes.");
  std::set<std::string> pasted;
  const dvec2 at = pastePlace(editor.canvas);
  if (tryEdit(editor, nodes::pasteText(editor.document.graph(), text, at, &pasted), "Paste"))
    editor.document.select(std::move(pasted));
}

namespace {

void duplicate(Editor& editor, bool keepInputs) {
  const std::set<std::string> names = editor.document.selection();
  if (names.empty()) return;
  std::set<std::string> copies;
  if (tryEdit(editor,
              nodes::duplicateNodes(editor.document.graph(), names, keepInputs, dvec2(kStep), &copies),
              named("Duplicate", names)))
    editor.document.select(std::move(copies));
}

}  // namespace

void duplicateSelection(Editor& editor) { duplicate(editor, false); }
void duplicateWithInputs(Editor& editor) { duplicate(editor, true); }

}  // namespace pileus::editor
