#include "editor/document/preset_shelf.h"

#include <algorithm>
#include <utility>

#include "editor/preferences/settings.h"
#include "renderer/base/text.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr std::size_t kMostUndone = 100;

}  // namespace

std::vector<fs::path> presetFolders(const Settings& settings) {
  std::vector<fs::path> out{nodes::ownPresetFolder()};
  for (const std::string& folder : settings.presetFolders) out.emplace_back(folder);
  return out;
}

bool presetFits(std::string_view text, std::string_view query) {
  const std::string all = lowered(text), words = lowered(query);
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    if (all.find(words.substr(at, end - at)) == all.npos) return false;
    at = end + 1;
  }
  return true;
}

bool presetFits(const nodes::PresetEntry& e, std::string_view query) {
  return presetFits(e.name + " " + e.about + " " + nodes::presetTagList(e.tags) + " " + e.type, query);
}

PresetShelf::~PresetShelf() = default;

const nodes::PresetEntry* PresetShelf::find(const fs::path& file) const {
  const auto it = std::find_if(entries_.begin(), entries_.end(),
                               [&](const nodes::PresetEntry& e) { return e.file == file; });
  return it == entries_.end() ? nullptr : &*it;
}

void PresetShelf::refresh(std::vector<fs::path> folders, bool known) {
  if (known && (read_ || reading_) && folders == folders_) return;
  folders_ = std::move(folders);
  if (reading_) return void(again_ = true);
  reading_ = std::make_unique<Job<std::vector<nodes::PresetEntry>>>(
      [all = folders_](JobControl& control) -> Result<std::vector<nodes::PresetEntry>> {
        std::vector<nodes::PresetEntry> out;
        for (const fs::path& folder : all) {
          if (control.cancelled()) return fail(Code::Cancelled, "cancelled");
          for (nodes::PresetEntry& e : nodes::presetsIn(folder)) out.push_back(std::move(e));
        }
        return out;
      });
}

bool PresetShelf::change(Change work) {
  if (changing_) return false;
  changing_ =
      std::make_unique<Job<nodes::PresetChange>>([work = std::move(work)](JobControl&) { return work(); });
  return true;
}

void PresetShelf::take(std::vector<nodes::PresetEntry> entries) {
  entries_ = std::move(entries);
  tags_.clear();
  for (const nodes::PresetEntry& e : entries_) tags_.insert(tags_.end(), e.tags.begin(), e.tags.end());
  std::sort(tags_.begin(), tags_.end());
  tags_.erase(std::unique(tags_.begin(), tags_.end()), tags_.end());
  ++revision_;
  read_ = true;
}

std::optional<Result<nodes::PresetChange>> PresetShelf::poll() {
  if (reading_ && reading_->done()) {
    if (reading_->result()) take(*reading_->result());
    reading_.reset();
    if (std::exchange(again_, false)) refresh(folders_);
  }
  if (!changing_ || !changing_->done()) return std::nullopt;
  Result<nodes::PresetChange> result = changing_->result();
  changing_.reset();
  if (result && !result->undone) {
    done_.push_back(*result);
    if (done_.size() > kMostUndone) done_.erase(done_.begin());
  }
  refresh(folders_);
  return result;
}

void PresetShelf::undo() {
  if (!canUndo()) return;
  const nodes::PresetChange last = done_.back();
  done_.pop_back();
  change([last]() -> Result<nodes::PresetChange> {
    PILEUS_CHECK(nodes::undoPresetChange(last));
    nodes::PresetChange undone = last;
    undone.label = "Undone: " + last.label;
    undone.undone = true;
    return undone;
  });
}

}  // namespace pileus::editor
