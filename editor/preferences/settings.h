#pragma once
// What the editor remembers between sessions (never part of a document): settings.json in the configuration
// folder.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "editor/preferences/appearance.h"
#include "editor/preferences/bookmarks.h"
#include "editor/preferences/panel_layout.h"
#include "editor/preferences/view_settings.h"
#include "renderer/base/math.h"
#include "renderer/base/result.h"

namespace pileus::editor {

struct Settings : PanelLayout {
  ivec2 window{0};  ///< 0: by the screen
  Appearance theme = Appearance::Dark;
  double uiScale = 0;             ///< 0: the screen's
  double viewportResolution = 1;  ///< rendered pixels per panel pixel
  double draftMs = 60;            ///< what a picture may take while something is dragged
  bool showInspector = false;     ///< of the viewport: the strip below the picture
  bool showHistogram = false;
  bool showHud = false;
  bool showStart = true;  ///< the start view, where no file is given
  bool tourSeen = false;
  bool showTimes = false;       ///< milliseconds on nodes
  bool showThumbnails = false;  ///< pictures on nodes
  bool showMinimap = true;
  std::vector<NamedLayout> layouts;          ///< the user's own
  std::vector<std::string> recentCommands;   ///< action ids run from the palette, newest first
  ViewSettings view;                         ///< of the viewport
  std::vector<FileBookmarks> bookmarks;      ///< of the graph canvas, most recently marked file first
  std::vector<std::string> recentFiles;      ///< absolute, newest first
  std::vector<std::string> recentNodes;      ///< node type ids, newest first
  std::vector<std::string> recentFolders;    ///< of the file browser, newest first
  std::vector<std::string> folderBookmarks;  ///< of the file browser, as added
  std::vector<std::string> presetFolders;  ///< with presets beside the user's own, as added; may be read-only
  std::map<std::string, std::string>
      kindFolders;  ///< of it: where files of an ending were last taken from or put

  bool operator==(const Settings&) const = default;
};

/// Moves `entry` to the front and keeps at most `limit`.
void remember(std::vector<std::string>& list, const std::string& entry, std::size_t limit = 12);

/// Unknown keys are ignored, wrong or absurd values replaced by the default: a damaged file never stops the
/// editor.
Settings settingsFromText(std::string_view json);
std::string settingsText(const Settings& settings);

inline constexpr char kSettingsName[] = "settings.json";
/// settings.json under `folder`; defaults when there is none. One that cannot be read is set aside.
Settings loadSettings(const std::filesystem::path& folder);
/// Renames a file that cannot be read to settings.json.bad, with a line in the log: it is not overwritten.
void setDamagedAside(const std::filesystem::path& folder);
Result<void> saveSettings(const std::filesystem::path& folder, const Settings& settings);

}  // namespace pileus::editor
