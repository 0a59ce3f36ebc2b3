#include "nodes/file/preset_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "renderer/base/file.h"
#include "renderer/base/text.h"

namespace fs = std::filesystem;

namespace pileus::nodes {
namespace {

constexpr std::size_t kLargestPreset = std::size_t(64) << 20, kMostFiles = 4096;
constexpr char kDeleted[] = ".deleted";

fs::path pictureOf(const fs::path& file) { return fs::path(file).replace_extension(".png"); }

fs::path whole(const fs::path& path) {
  std::error_code ec;
  return fs::absolute(path, ec).lexically_normal();
}

/// "Dusk / low sun" -> "dusk-low-sun": what any file system takes.
std::string fileName(std::string_view name) {
  std::string out = lowered(plainName(name, '-'));
  if (out.size() > 60) out.resize(60);
  return out.empty() ? "preset" : out;
}

bool mayWrite(const fs::path& path) { return ::access(path.c_str(), W_OK) == 0; }

PresetEntry entryOf(const fs::path& file, bool folderWritable) {
  PresetEntry e;
  e.file = file;
  e.stamp = fileStamp(file);
  e.writable = folderWritable && mayWrite(file);
  e.name = file.stem().string();
  const auto text = readFile(file, kLargestPreset);
  if (!text) {
    e.fault = text.error().message;
    return e;
  }
  const auto loaded = presetFromText(*text);
  if (!loaded) {
    e.fault = file.string() + ": " + loaded.error().message;
    return e;
  }
  const Preset& p = loaded->preset;
  e.kind = p.kind, e.name = p.name, e.about = p.about, e.tags = p.tags;
  e.nodes = static_cast<int>(p.graph.nodes.size());
  if (p.kind == PresetKind::Parameters) e.type = p.graph.nodes.begin()->second->type;
  return e;
}

/// A file keeps a second name in `.deleted`, or a copy of it where the disk has no second names. Nothing was
/// changed where that fails.
Result<fs::path> setAside(const fs::path& file) {
  const fs::path folder = file.parent_path() / kDeleted;
  std::error_code ec;
  fs::create_directories(folder, ec);
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto stamp = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
  for (int i = 0; i < 1000; ++i) {
    const fs::path aside = folder / fmt::format("{}-{}-{}", stamp, i, file.filename().string());
    if (fs::exists(fs::symlink_status(aside, ec))) continue;
    if (::link(file.c_str(), aside.c_str()) == 0) return aside;
    if (errno == EEXIST) continue;
    fs::copy_file(file, aside, ec);
    if (!ec) return aside;
    fs::remove(aside, ec);
    break;
  }
  return fail(Code::Input, "{}: it cannot be kept in {}, so it was left as it is", file.string(),
              folder.string());
}

/// The preset and its picture; the picture is no reason to stop.
Result<fs::path> setPairAside(const fs::path& file) {
  PILEUS_TRY(const fs::path aside, setAside(file));
  std::error_code ec;
  if (const fs::path picture = pictureOf(file); fs::exists(picture, ec)) {
    fs::remove(pictureOf(aside), ec);
    if (::link(picture.c_str(), pictureOf(aside).c_str()) != 0) fs::copy_file(picture, pictureOf(aside), ec);
  }
  return aside;
}

void removePair(const fs::path& file) {
  std::error_code ec;
  fs::remove(file, ec);
  fs::remove(pictureOf(file), ec);
}

/// A new file of this name that nobody else has, empty as yet.
Result<fs::path> reserve(const fs::path& folder, const std::string& name) {
  for (int i = 1; i < 10000; ++i) {
    const fs::path file = folder / (i == 1 ? name + ".json" : fmt::format("{}-{}.json", name, i));
    const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd >= 0) {
      ::close(fd);
      return file;
    }
    if (errno != EEXIST)
      return fail(Code::Input, "{}: cannot be written ({})", file.string(), std::strerror(errno));
  }
  return fail(Code::Input, "{}: no file name is free for '{}'", folder.string(), name);
}

/// Its words are as they must be, and no other preset of the folder than `but` has its name.
Result<void> checkFits(const Preset& preset, const fs::path& folder, const fs::path& but = {}) {
  PILEUS_CHECK(checkPresetName(preset.name));
  PILEUS_CHECK(checkPresetAbout(preset.about));
  for (const PresetEntry& e : presetsIn(folder))
    if (e.fault.empty() && e.name == preset.name && e.file != but)
      return fail(Code::Arguments, "there is a preset '{}' already: {}", preset.name, e.file.string());
  return {};
}

/// As the file's folder sees it.
std::string textFor(const fs::path& file, Preset preset, const fs::path& from) {
  const fs::path to = whole(file).parent_path();
  preset.graph = withRelativePaths(preset.graph, from.empty() ? to : whole(from), to);
  return presetText(preset);
}

Result<void> writePicture(const fs::path& file, const std::string& png) {
  if (png.empty()) return {};
  return writeFileAtomic(pictureOf(file), png);
}

}  // namespace

fs::path ownPresetFolder() { return configFolder() / "presets"; }

std::vector<PresetEntry> presetsIn(const fs::path& folder) {
  std::vector<PresetEntry> out;
  std::vector<fs::path> files;
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    const fs::path& path = it->path();
    std::error_code other;
    if (path.extension() != ".json" || path.filename().string().starts_with(".")) continue;
    // One that another program is just beginning to write is empty.
    if (!fs::is_regular_file(path, other) || fs::file_size(path, other) == 0) continue;
    files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  if (files.size() > kMostFiles) files.resize(kMostFiles);
  const bool writable = mayWrite(folder);
  for (const fs::path& file : files) out.push_back(entryOf(file, writable));
  std::stable_sort(out.begin(), out.end(), [](const PresetEntry& a, const PresetEntry& b) {
    return a.fault.empty() != b.fault.empty() ? a.fault.empty() : a.name < b.name;
  });
  return out;
}

Result<LoadedPreset> loadPreset(const fs::path& file, const fs::path& folder) {
  PILEUS_TRY(const std::string text, readFile(file, kLargestPreset));
  Result<LoadedPreset> loaded = presetFromText(text);
  if (!loaded) return fail(loaded.error().code, "{}: {}", file.string(), loaded.error().message);
  loaded->preset.graph = withRelativePaths(loaded->preset.graph, whole(file).parent_path(),
                                           folder.empty() ? fs::path("/") : whole(folder));
  return loaded;
}

Result<PresetChange> savePreset(const fs::path& folder, const Preset& preset, const std::string& png,
                                const fs::path& from) {
  PILEUS_CHECK(checkFits(preset, folder));
  std::error_code ec;
  fs::create_directories(folder, ec);
  PILEUS_TRY(const fs::path file, reserve(whole(folder), fileName(preset.name)));
  if (const auto written = writeFileAtomic(file, textFor(file, preset, from)); !written) {
    fs::remove(file, ec);
    return written.error();
  }
  if (const auto written = writePicture(file, png); !written) {
    removePair(file);
    return written.error();
  }
  return PresetChange{"Saved the preset " + preset.name, file, {}, false, false, fileStamp(file)};
}

Result<PresetChange> replacePreset(const fs::path& file, const Preset& preset, const std::string& png,
                                   const fs::path& from) {
  PILEUS_CHECK(checkFits(preset, file.parent_path(), file));
  PILEUS_TRY(const fs::path before, setPairAside(file));
  // The picture first: of the two it is what may be the wrong one.
  auto written = writePicture(file, png);
  if (written) written = writeFileAtomic(file, textFor(file, preset, from));
  if (!written) {
    std::error_code ec;
    if (fs::exists(pictureOf(before), ec))
      fs::rename(pictureOf(before), pictureOf(file), ec);
    else if (!png.empty())
      fs::remove(pictureOf(file), ec);
    // Two names of one file are not renamed, so that the second is left.
    removePair(before);
    return written.error();
  }
  return PresetChange{"Replaced the preset " + preset.name, file, before, false, false, fileStamp(file)};
}

Result<PresetChange> describePreset(const fs::path& file, const std::string& name, const std::string& about,
                                    const std::vector<std::string>& tags) {
  PILEUS_TRY(const std::string text, readFile(file, kLargestPreset));
  Result<LoadedPreset> loaded = presetFromText(text);
  if (!loaded) return fail(loaded.error().code, "{}: {}", file.string(), loaded.error().message);
  const std::string old = std::exchange(loaded->preset.name, name);
  loaded->preset.about = about;
  loaded->preset.tags = tags;
  PILEUS_TRY(PresetChange change, replacePreset(file, loaded->preset, {}));
  change.label = old == name ? "Described the preset " + name : "Renamed the preset " + old;
  return change;
}

Result<PresetChange> deletePreset(const fs::path& file) {
  if (!mayWrite(file)) return fail(Code::Input, "{}: it is read-only", file.string());
  const std::string name = entryOf(file, true).name;
  PILEUS_TRY(const fs::path before, setPairAside(file));
  std::error_code ec;
  if (!fs::remove(file, ec) || ec) {
    fs::remove(before, ec);
    return fail(Code::Input, "{}: cannot be deleted", file.string());
  }
  fs::remove(pictureOf(file), ec);
  return PresetChange{"Deleted the preset " + name, file, before, true, {}};
}

Result<void> undoPresetChange(const PresetChange& change) {
  std::error_code ec;
  const bool there = fs::exists(change.file, ec);
  if (there && (change.deleted || fileStamp(change.file) != change.stamp))
    return fail(Code::Input, "{}: it was written by another program since; what it was before is {}",
                change.file.string(), change.before.empty() ? "nothing" : change.before.string());
  if (there) {
    PILEUS_CHECK(setPairAside(change.file));
  }
  if (change.before.empty()) {
    removePair(change.file);
    return {};
  }
  // The picture first, so that one who sees the preset sees its picture.
  if (fs::exists(pictureOf(change.before), ec))
    fs::rename(pictureOf(change.before), pictureOf(change.file), ec);
  else
    fs::remove(pictureOf(change.file), ec);
  fs::remove(pictureOf(change.before), ec);
  fs::rename(change.before, change.file, ec);
  if (ec)
    return fail(Code::Input, "{}: cannot be put back ({}); it is kept as {}", change.file.string(),
                ec.message(), change.before.string());
  return {};
}

const PresetEntry* findPreset(const std::vector<PresetEntry>& all, std::string_view name) {
  const auto first = [&](const auto& fits) -> const PresetEntry* {
    for (const PresetEntry& e : all)
      if (e.fault.empty() && fits(e)) return &e;
    return nullptr;
  };
  if (const auto* e = first([&](const PresetEntry& p) { return p.name == name; })) return e;
  if (const auto* e = first([&](const PresetEntry& p) { return p.file.stem() == name; })) return e;
  return first([&](const PresetEntry& p) { return lowered(p.name) == lowered(name); });
}

}  // namespace pileus::nodes
