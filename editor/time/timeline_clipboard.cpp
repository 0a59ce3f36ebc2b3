#include "editor/time/timeline_clipboard.h"

#include <fmt/core.h>
#include <imgui.h>

#include "editor/app/editor.h"
#include "editor/time/playback.h"
#include "editor/time/timeline_edits.h"
#include "nodes/file/serialize.h"

namespace pileus::editor {

void copySelectedKeys(Editor& editor) {
  const KeySelection& selected = editor.timeline.selected;
  ImGui::SetClipboardText(nodes::copyKeysText(editor.document.graph(), selected).c_str());
  editor.messages.note("Copied " + keysText(selected.size()));
}

void cutSelectedKeys(Editor& editor) {
  const std::string what = keysText(editor.timeline.selected.size());
  copySelectedKeys(editor);
  deleteSelectedKeys(editor, "Cut " + what);
  editor.messages.note("Cut " + what);
}

void pasteKeys(Editor& editor) {
  stopPlayback(editor);
  const char* text = ImGui::GetClipboardText();
  // With another node selected, keys of one node are meant for that.
  const auto& chosen = editor.document.selection();
  const std::string onto = chosen.size() == 1 ? *chosen.begin() : std::string();
  KeySelection pasted;
  Result<nodes::Graph> graph =
      nodes::pasteKeysText(editor.document.graph(), text ? text : "", editor.frame, onto, &pasted);
  if (!graph) return editor.messages.warn("Not pasted: " + graph.error().message);
  const std::string what = keysText(pasted.size());
  if (!tryEdit(editor, std::move(graph), fmt::format("Paste {} at frame {}", what, editor.frame))) return;
  editor.timeline.selected = std::move(pasted);
  editor.messages.note(fmt::format("Pasted {} at frame {}", what, editor.frame));
}

}  // namespace pileus::editor
