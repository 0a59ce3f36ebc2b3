#pragma once
// What stops everything else until it is answered: questions, notices and the file dialog.
#include <functional>
#include <string>
#include <vector>

#include "editor/toolkit/file_browser.h"
#include "editor/toolkit/question.h"

namespace pileus::editor {

struct Modals {
  struct Fault {
    bool error = false;
    std::string text;
  };

  std::function<void()> afterUnsaved;  ///< set: ask about unsaved changes, then do this
  std::vector<Fault> faults;           ///< not empty: list them
  std::string faultsOf;                ///< the file they were found in
  struct Missing {
    std::string where, path;
  };
  std::vector<Missing> missing;       ///< not empty: list these files that are not there
  std::string errorTitle, errorText;  ///< not empty: an error that needs reading
  bool shortcuts = false, about = false;
  bool preset = false;  ///< the words of a preset are asked for
  Questions questions;  ///< any others, one after the other
  FileBrowser browser;

  /// Is there one of them, the file dialog aside?
  bool anyOpen() const {
    return afterUnsaved || !faults.empty() || !missing.empty() || !errorText.empty() || shortcuts || about ||
           preset || questions.open();
  }
};

}  // namespace pileus::editor
