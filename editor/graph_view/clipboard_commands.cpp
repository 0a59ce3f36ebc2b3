// Copies of nodes: through the system's clipboard as JSON text, or beside the originals.
#include <imgui.h>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/toolkit/ui.h"
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

void copySelection(Ui& ui, const Session& session, Canvas& canvas) {
  const std::set<std::string>& names = session.document.selection();
  if (names.empty()) return ui.messages.hint("Select the nodes to copy.");
  ImGui::SetClipboardText(
      nodes::copyText(session.document.graph(), names, session.document.path().parent_path()).c_str());
  ui.messages.note(named("Copied", names));
  canvas.pastes = 0;
}

void cutSelection(Ui& ui, Session& session, Canvas& canvas) {
  const std::set<std::string> names = session.document.selection();
  if (names.empty()) return ui.messages.hint("Select the nodes to cut.");
  copySelection(ui, session, canvas);
  if (tryEdit(session, ui.messages, nodes::removeNodes(session.document.graph(), names, true),
              named("Cut", names)))
    ui.messages.note(named("Cut", names));
}

void pasteNodes(Ui& ui, Session& session, Canvas& canvas) {
  const char* text = ImGui::GetClipboardText();
  if (!text || !*text) return ui.messages.hint("The clipboard is empty: copy some nodes first.");
  if (std::string_view(text).find("\"pileus\"") == std::string_view::npos)
    return ui.messages.hint("The clipboard holds other text, but no Pileus nodes.");
  std::set<std::string> pasted;
  const dvec2 at = pastePlace(canvas);
  if (tryEdit(session, ui.messages, nodes::pasteText(session.document.graph(), text, at, &pasted), "Paste"))
    session.document.select(std::move(pasted));
}

namespace {

void duplicate(Ui& ui, Session& session, bool keepInputs) {
  const std::set<std::string> names = session.document.selection();
  if (names.empty()) return;
  std::set<std::string> copies;
  if (tryEdit(session, ui.messages,
              nodes::duplicateNodes(session.document.graph(), names, keepInputs, dvec2(kStep), &copies),
              named("Duplicate", names)))
    session.document.select(std::move(copies));
}

}  // namespace

void duplicateSelection(Ui& ui, Session& session) { duplicate(ui, session, false); }
void duplicateWithInputs(Ui& ui, Session& session) { duplicate(ui, session, true); }

}  // namespace pileus::editor
