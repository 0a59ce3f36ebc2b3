#pragma once
// The presets of the user's folders as the window knows them: read by a job, changed by a job, each change
// with the way back. UI thread.
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nodes/file/preset_folder.h"
#include "renderer/base/jobs.h"

namespace pileus::editor {

struct Settings;

/// The user's own folder, then those of the settings.
std::vector<std::filesystem::path> presetFolders(const Settings& settings);

/// The words of a search that a preset must all have in its name, its sentence, its tags or its node type.
bool presetFits(const nodes::PresetEntry& entry, std::string_view query);
bool presetFits(std::string_view text, std::string_view query);  ///< the same of a text

class PresetShelf {
 public:
  using Change = std::function<Result<nodes::PresetChange>()>;

  ~PresetShelf();
  /// What was last read, folder by folder, each sorted by name.
  const std::vector<nodes::PresetEntry>& entries() const { return entries_; }
  /// Counts what was read: others sort their own lists anew.
  unsigned revision() const { return revision_; }
  const nodes::PresetEntry* find(const std::filesystem::path& file) const;
  /// Sorted, each once.
  const std::vector<std::string>& tags() const { return tags_; }

  /// Reads the folders again, soon. `known`: not where they were read already.
  void refresh(std::vector<std::filesystem::path> folders, bool known = false);
  /// Begins a change, unless one is going on; refreshes when it is done.
  bool change(Change work);
  bool changing() const { return changing_ != nullptr; }
  /// Once a frame: takes what jobs have found. What came of a change, once.
  std::optional<Result<nodes::PresetChange>> poll();

  bool canUndo() const { return !done_.empty() && !changing_; }
  std::string undoLabel() const { return done_.empty() ? std::string() : done_.back().label; }
  /// Takes the last change back.
  void undo();

 private:
  void take(std::vector<nodes::PresetEntry> entries);

  std::vector<nodes::PresetEntry> entries_;
  std::vector<std::string> tags_;
  std::vector<std::filesystem::path> folders_;
  std::vector<nodes::PresetChange> done_;  ///< oldest first
  unsigned revision_ = 0;
  bool again_ = false, read_ = false;
  std::unique_ptr<Job<std::vector<nodes::PresetEntry>>> reading_;
  std::unique_ptr<Job<nodes::PresetChange>> changing_;
};

}  // namespace pileus::editor
