#include "editor/document/drops.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "editor/exchange/messages.h"
#include "renderer/base/text.h"
#include "renderer/image/exr.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr std::size_t kMostFrames = 200;  // that are looked into for one that holds something

std::string nameOf(const fs::path& path) { return path.filename().string(); }

/// The files that differ from this one in the last number of their names and come after it, by that number.
std::vector<fs::path> framesAfter(const fs::path& path) {
  struct Name {
    std::string head, tail;
    std::string digits;
  };
  const auto split = [](const std::string& name) -> std::optional<Name> {
    const std::size_t last = name.find_last_of("0123456789");
    if (last == std::string::npos) return std::nullopt;
    std::size_t first = last;
    while (first > 0 && std::isdigit(static_cast<unsigned char>(name[first - 1]))) --first;
    if (last + 1 - first > 9) return std::nullopt;
    return Name{name.substr(0, first), name.substr(last + 1), name.substr(first, last + 1 - first)};
  };
  const std::optional<Name> own = split(nameOf(path));
  std::map<int, fs::path> found;
  std::error_code ec;
  if (own)
    for (fs::directory_iterator it(path.parent_path(), ec), end; !ec && it != end; it.increment(ec))
      if (const auto n = split(nameOf(it->path())); n && n->head == own->head && n->tail == own->tail)
        if (const int number = std::stoi(n->digits); number > std::stoi(own->digits))
          found.emplace(number, it->path());
  std::vector<fs::path> files;
  for (const auto& [number, file] : found)
    if (files.size() < kMostFrames) files.push_back(file);
  return files;
}

/// A sequence may begin with frames that hold nothing yet: the first one that holds something is taken.
Result<volume::VdbFit> firstFit(const fs::path& path, JobControl& control, std::vector<std::string>& notes) {
  Result<volume::VdbFit> fit = volume::fitVdb(path, control);
  if (fit && !fit->bounds.empty()) return fit;
  for (const fs::path& next : framesAfter(path)) {
    if (control.cancelled()) break;
    Result<volume::VdbFit> other = volume::fitVdb(next, control);
    if (!other || other->bounds.empty()) continue;
    notes.push_back(nameOf(path) + " holds nothing to see; the first frame that does is " + nameOf(next) +
                    ".");
    return other;
  }
  return fit;
}

}  // namespace

DropKind dropKind(const fs::path& path) {
  const std::string ending = lowered(path.extension().string());
  if (ending == ".json") return DropKind::Graph;
  if (ending == ".vdb") return DropKind::Volume;
  if (ending == ".exr") return DropKind::Still;
  if (ending == ".hdr") return DropKind::Environment;
  return DropKind::Unknown;
}

std::string whyNotDropped(const fs::path& path) {
  const std::string name = nameOf(path);
  if (path.extension() == ".nvdb")
    return name + " is a NanoVDB file, which cannot be read: convert it to .vdb (nanovdb_convert).";
  std::error_code ec;
  if (fs::is_directory(path, ec))
    return name +
           " is a folder. Graphs (.json), volumes (.vdb), stills and environments (.exr, .hdr) can be "
           "dropped.";
  return name +
         " cannot be used. Graphs (.json), volumes (.vdb), stills and environments (.exr, .hdr) can be "
         "dropped.";
}

DropContent readDrops(const std::vector<fs::path>& paths, JobControl& control) {
  DropContent out;
  for (const fs::path& path : paths) {
    if (control.cancelled()) break;
    const DropKind kind = dropKind(path);
    std::error_code ec;
    if (!fs::exists(path, ec)) {
      out.refusals.push_back(path.string() + ": there is no such file");
    } else if (kind == DropKind::Graph) {
      out.graphs.push_back(path);
    } else if (kind == DropKind::Volume) {
      Result<volume::VdbFit> fit = firstFit(path, control, out.notes);
      if (fit)
        out.volumes.push_back(std::move(*fit));
      else
        out.refusals.push_back(fit.error().message);
    } else if (kind == DropKind::Still) {
      const auto metadata = image::readExrMetadata(path);
      if (!metadata)
        out.refusals.push_back(metadata.error().message);
      else if (const auto it = metadata->find(image::kGraphAttribute); it != metadata->end())
        out.stills.emplace_back(path, it->second);
      else
        out.environments.push_back(path);
    } else if (kind == DropKind::Environment) {
      out.environments.push_back(path);
    } else {
      out.refusals.push_back(whyNotDropped(path));
    }
  }
  return out;
}

void Drops::take(std::vector<fs::path> paths) {
  std::error_code ec;
  for (fs::path& path : paths) waiting_.push_back(fs::absolute(path, ec).lexically_normal());
}

std::optional<DropContent> Drops::step(Messages& messages) {
  if (!job_ && !waiting_.empty()) {
    const auto volumes = std::count_if(waiting_.begin(), waiting_.end(),
                                       [](const fs::path& p) { return dropKind(p) == DropKind::Volume; });
    if (volumes > 0) messages.note("Reading " + nameOf(waiting_.front()) + "\xe2\x80\xa6");
    job_ = std::make_unique<Job<DropContent>>(
        [paths = std::exchange(waiting_, {})](JobControl& control) -> Result<DropContent> {
          return readDrops(paths, control);
        });
  }
  if (!job_ || !job_->done()) return std::nullopt;
  const std::unique_ptr<Job<DropContent>> done = std::move(job_);
  return *done->result();
}

}  // namespace pileus::editor
