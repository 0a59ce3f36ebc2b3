#pragma once
// What a start without a file shows over the window: unsaved work of a session that crashed, presets and
// recent files as pictures, new, open and the tour. Esc or a click beside it closes it.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "editor/document/recovery.h"
#include "renderer/base/jobs.h"

namespace pileus::editor {

struct Settings;
struct StartRoom;
struct Ui;

/// What a job finds out before anything is shown.
struct StartFindings {
  std::vector<Lost> lost;
  std::vector<std::filesystem::path> crashes;
  std::vector<std::string> missing;  ///< recent files that are not there
};

struct StartView {
  bool open = false;
  bool appearing = false;
  bool fileGiven = false;  ///< what was asked for is shown: unsaved work is a notice, not this view
  StartFindings found;
  std::unique_ptr<Job<StartFindings>> search;
  std::string query, tag;  ///< what the gallery shows: "" = all
};

/// At the start of the program: looks for unsaved work and crash reports. With a file that was given the view
/// stays closed and a notice tells of unsaved work; otherwise it opens where the settings say so, and in any
/// case when there is unsaved work.
void beginStart(const Settings& settings, StartView& start, bool fileGiven);
/// Help > Start view.
void openStart(StartView& start);
/// Once a frame.
void drawStart(const StartRoom& room);
/// The desktop's file manager, where there is one; the path is said in any case.
void showInFolder(Ui& ui, const std::filesystem::path& path);

/// "default.json" -> "Broken cumulus": the gallery's name of a preset, one line about it, and its tags.
struct PresetText {
  const char* file;
  const char* name;
  const char* about;
  const char* tags = "";  ///< "cloud, evening"
};
/// In the order of the gallery.
const std::vector<PresetText>& galleryTexts();

}  // namespace pileus::editor
