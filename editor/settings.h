#pragma once
// What the editor remembers between sessions (never part of a document): settings.json in the configuration
// folder.
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/math.h"
#include "renderer/base/result.h"

namespace pileus::editor {

struct Settings {
  ivec2 window{1440, 900};
  double viewportShare = 0.56;    ///< of the height that viewport and graph divide
  double parametersWidth = 340;   ///< design pixels
  double logHeight = 160;         ///< design pixels
  double viewportResolution = 1;  ///< rendered pixels per panel pixel
  bool showTimes = false;         ///< milliseconds on nodes
  double scopeWidth = 420;        ///< design pixels
  double labHeight = 300;         ///< design pixels
  bool showLog = false;
  bool showScope = false;
  bool showLab = false;
  std::vector<std::string> recentFiles;    ///< absolute, newest first
  std::vector<std::string> recentNodes;    ///< node type ids, newest first
  std::vector<std::string> recentFolders;  ///< of the file browser, newest first

  bool operator==(const Settings&) const = default;
};

/// Moves `entry` to the front and keeps at most `limit`.
void remember(std::vector<std::string>& list, const std::string& entry, std::size_t limit = 12);

/// Unknown keys are ignored, wrong or absurd values replaced by the default: a damaged file never stops the
/// editor.
Settings settingsFromText(std::string_view json);
std::string settingsText(const Settings& settings);

/// settings.json under `folder`; defaults when there is none.
Settings loadSettings(const std::filesystem::path& folder);
Result<void> saveSettings(const std::filesystem::path& folder, const Settings& settings);

}  // namespace pileus::editor
