#pragma once
// Folders with presets: what is in them, and every change of them so that it can be taken back. A preset is
// NAME.json, its picture NAME.png beside it; the name a preset goes by stands in the file, so it may hold
// what a file name may not. What is replaced or deleted goes to the folder `.deleted` in there. Any thread;
// two programs may use one folder.
#include <filesystem>
#include <string>
#include <vector>

#include "nodes/file/preset.h"
#include "renderer/base/hash.h"

namespace pileus::nodes {

/// The user's own folder: `presets` beside the settings. It may not be there yet.
std::filesystem::path ownPresetFolder();

/// A file of a folder, without its graph.
struct PresetEntry {
  PresetKind kind = PresetKind::Document;
  std::string name, about;
  std::vector<std::string> tags;
  std::filesystem::path file;
  std::string type;       ///< Parameters: of its node
  int nodes = 0;          ///< how many it holds
  bool writable = false;  ///< the folder and the file are
  Key stamp{};            ///< fileStamp() when it was read
  std::string fault;      ///< not "": it cannot be read, and why; the name is then the file's
};

/// Sorted by name; a folder that is not there has none, damaged files stand behind the others. At most 4096
/// files of a folder are read.
std::vector<PresetEntry> presetsIn(const std::filesystem::path& folder);

/// The preset with its files as seen from `folder` (absolute where they share the root only, or where
/// `folder` is ""). Errors (Input) name the file.
Result<LoadedPreset> loadPreset(const std::filesystem::path& file, const std::filesystem::path& folder = {});

/// What a change did, so that it can be undone.
struct PresetChange {
  std::string label;             ///< "Saved the preset Dusk"
  std::filesystem::path file;    ///< of the preset
  std::filesystem::path before;  ///< what was there, in `.deleted`; "" = nothing
  bool deleted = false;          ///< nothing is there now
  bool undone = false;           ///< it was taken back
  Key stamp{};                   ///< of `file` when the change was done
};

/// Writes a new preset; its files become relative to it (relative ones in it start in `from`). `png`: its
/// picture, "" = none. Error (Arguments): a bad name, or one that a preset of the folder has; Error (Input):
/// it cannot be written, and then nothing has changed.
Result<PresetChange> savePreset(const std::filesystem::path& folder, const Preset& preset,
                                const std::string& png, const std::filesystem::path& from = {});
/// The same in the place of a file. The old one is kept in `.deleted`; without a `png` its picture stays.
Result<PresetChange> replacePreset(const std::filesystem::path& file, const Preset& preset,
                                   const std::string& png, const std::filesystem::path& from = {});
/// Another name, sentence and tags; the file keeps its own name. Error (Arguments) as savePreset().
Result<PresetChange> describePreset(const std::filesystem::path& file, const std::string& name,
                                    const std::string& about, const std::vector<std::string>& tags);
Result<PresetChange> deletePreset(const std::filesystem::path& file);
/// Puts back what was there. What is there now is kept in `.deleted`. Error (Input): somebody else has
/// changed the preset since; nothing is done then.
Result<void> undoPresetChange(const PresetChange& change);

/// The preset that goes by this name, or whose file does ("dusk" of dusk.json), exactly before regardless of
/// case; null: none. Damaged ones are left out.
const PresetEntry* findPreset(const std::vector<PresetEntry>& all, std::string_view name);

}  // namespace pileus::nodes
