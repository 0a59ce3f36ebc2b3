#pragma once
// Modal questions and notices: unsaved changes, faults of a loaded file, the shortcut sheet, about.
#include <functional>
#include <string>
#include <vector>

#include "editor/commands/shortcut_sheet.h"
#include "editor/toolkit/question.h"
#include "nodes/file/serialize.h"

namespace pileus::editor {

struct Editor;

struct Dialogs {
  std::function<void(Editor&)> afterUnsaved;  ///< set: ask about unsaved changes, then do this
  std::vector<nodes::Fault> faults;           ///< not empty: list them
  std::string faultsOf;                       ///< the file they were found in
  std::string errorTitle, errorText;          ///< not empty: an error that needs reading
  bool shortcuts = false, about = false;
  ShortcutSheet sheet;
  Questions questions;  ///< any others, one after the other

  bool anyOpen() const {
    return afterUnsaved || !faults.empty() || !errorText.empty() || shortcuts || about || questions.open();
  }
};

void drawDialogs(Editor& editor);

}  // namespace pileus::editor
