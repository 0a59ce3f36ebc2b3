#include "editor/commands/carry_out.h"

#include "editor/commands/actions.h"
#include "editor/commands/files.h"
#include "editor/commands/library/presets.h"
#include "editor/commands/panel_commands.h"
#include "editor/document/recovery.h"
#include "editor/editor.h"
#include "editor/exchange/requests.h"
#include "editor/start/start_view.h"

namespace pileus::editor {
namespace {

struct CarryOut {
  Editor& editor;

  void operator()(const RunCommand& r) { runCommand(editor, r.id); }
  void operator()(const OpenFile& r) {
    withSavedDocument(editor, [&e = editor, path = r.path] { openFile(e, path); });
  }
  void operator()(const OpenPreset& r) {
    withSavedDocument(editor, [&e = editor, name = r.name] { openPreset(e, name); });
  }
  void operator()(const UsePreset& r) { usePreset(editor, r); }
  void operator()(const ChangePreset& r) { changePreset(editor, r); }
  void operator()(const OpenLost& r) {
    withSavedDocument(editor, [&e = editor, lost = r.lost] {
      if (openLost(e, *lost))
        std::erase_if(e.start.found.lost, [&](const Lost& l) { return l.set == lost->set; });
    });
  }
  void operator()(const ShowPanel& r) {
    if (r.show)
      revealPanel(editor, r.panel);
    else
      setPanelOpen(editor, r.panel, false);
  }
  void operator()(const std::function<void()>& work) {
    if (work) work();
  }
};

}  // namespace

bool carryOutRequests(Editor& editor) {
  if (editor.requests.empty()) return false;
  while (!editor.requests.empty()) std::visit(CarryOut{editor}, editor.requests.pop());
  return true;
}

}  // namespace pileus::editor
