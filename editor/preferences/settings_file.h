#pragma once
// Settings on the disk while the editor runs: written a moment after each change, so that a crash loses none,
// and joined with what another window or a newer version has written meanwhile. UI thread.
#include <filesystem>

#include "editor/preferences/settings.h"
#include "renderer/base/profile.h"

namespace pileus::editor {

class SettingsFile {
 public:
  /// `loaded`: what loadSettings(folder) gave. `restSeconds`: after the last change.
  SettingsFile(std::filesystem::path folder, Settings loaded, double restSeconds = 2);

  /// Once a frame; writes when it is time. An error is told once for each change.
  Result<void> watch(const Settings& now);
  /// Seconds until watch() has something to do; negative: nothing is due.
  double dueSeconds() const;
  /// At once. Of the file only what was changed here is replaced: keys that another window has written, or
  /// that this version does not know, stay. New entries of both are kept in lists of recent things.
  Result<void> save(const Settings& now);

 private:
  std::filesystem::path folder_;
  Settings written_;  ///< as the file was last read or written here
  Settings seen_;
  double rest_;
  bool due_ = false;
  Stopwatch age_;
};

}  // namespace pileus::editor
