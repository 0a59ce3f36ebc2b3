#include "editor/timeline_view/timeline_clipboard.h"

#include <fmt/core.h>
#include <imgui.h>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/time/timeline_edits.h"
#include "nodes/file/serialize.h"

namespace pileus::editor {

void copySelectedKeys(Messages& messages, const Session& session, const Clock& clock) {
  const KeySelection& selected = clock.keys.selected;
  ImGui::SetClipboardText(nodes::copyKeysText(session.document.graph(), selected).c_str());
  messages.note("Copied " + keysText(selected.size()));
}

void cutSelectedKeys(Messages& messages, Session& session, Clock& clock) {
  const std::string what = keysText(clock.keys.selected.size());
  copySelectedKeys(messages, session, clock);
  deleteSelectedKeys(messages, session, clock, "Cut " + what);
  messages.note("Cut " + what);
}

void pasteKeys(Messages& messages, Session& session, Clock& clock) {
  stopPlayback(clock);
  const char* text = ImGui::GetClipboardText();
  // With another node selected, keys of one node are meant for that.
  const auto& chosen = session.document.selection();
  const std::string onto = chosen.size() == 1 ? *chosen.begin() : std::string();
  KeySelection pasted;
  Result<nodes::Graph> graph =
      nodes::pasteKeysText(session.document.graph(), text ? text : "", clock.frame, onto, &pasted);
  if (!graph) return messages.warn("Not pasted: " + graph.error().message);
  const std::string what = keysText(pasted.size());
  if (!tryEdit(session, messages, std::move(graph), fmt::format("Paste {} at frame {}", what, clock.frame)))
    return;
  clock.keys.selected = std::move(pasted);
  messages.note(fmt::format("Pasted {} at frame {}", what, clock.frame));
}

}  // namespace pileus::editor
