#include "renderer/volume/vdb_fit.h"

#include <algorithm>
#include <cctype>

#include "renderer/volume/instance.h"

namespace fs = std::filesystem;

namespace pileus::volume {
namespace {

/// A name cut at its last number: "smoke_0012.vdb" -> "smoke_", "0012", ".vdb". False: it has none.
struct Numbered {
  std::string before, digits, after;
};

bool cut(const std::string& name, Numbered& out) {
  std::size_t end = name.rfind('.');
  if (end == std::string::npos) end = name.size();
  while (end > 0 && !std::isdigit(static_cast<unsigned char>(name[end - 1]))) --end;
  std::size_t begin = end;
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1]))) --begin;
  if (begin == end || end - begin > 9) return false;
  out = {name.substr(0, begin), name.substr(begin, end - begin), name.substr(end)};
  return true;
}

}  // namespace

FileFrames framesBeside(const fs::path& path) {
  FileFrames out{1, path.filename().string(), path.filename().string()};
  Numbered mine;
  if (!cut(out.first, mine)) return out;
  long lowest = std::stol(mine.digits), highest = lowest;
  int count = 0;
  std::error_code ec;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec)) {
    Numbered other;
    const std::string name = it->path().filename().string();
    if (!cut(name, other) || other.before != mine.before || other.after != mine.after) continue;
    ++count;
    const long number = std::stol(other.digits);
    if (number < lowest) lowest = number, out.first = name;
    if (number > highest) highest = number, out.last = name;
  }
  out.count = std::max(count, 1);
  return out;
}

Result<VdbFit> fitVdb(const fs::path& path, JobControl& control) {
  VdbFit out;
  out.file = path;
  PILEUS_TRY(const VdbInfo info, inspectVdb(path, control));
  out.guess = guessGrid(info.grids);
  if (out.guess.grid.empty()) {
    std::string all;
    for (const std::string& note : out.guess.notes) all += (all.empty() ? "" : "; ") + note;
    return fail(Code::Input, "{}: {}{}", path.string(), out.guess.why, all.empty() ? "" : " (" + all + ")");
  }
  out.byDefault =
      info.chosen >= 0 && info.grids[static_cast<std::size_t>(info.chosen)].name == out.guess.grid;
  PILEUS_TRY(ImportedGrid imported, importVdb(path, out.byDefault ? "" : out.guess.grid, control));
  out.warnings = std::move(imported.warnings);
  out.frames = framesBeside(path);
  if (imported.grid->empty()) return out;
  out.fit = autofit(*imported.grid);
  out.voxelSize = imported.grid->voxelSize;
  const dvec3 extent = imported.grid->indexBounds.size();
  out.longest = std::max({extent.x, extent.y, extent.z});
  Instance instance;
  instance.shape = Shape::Grid;
  instance.grid = imported.grid;
  instance.worldFromLocal = imported.grid->worldFromIndex;
  out.bounds = worldBounds(instance);
  return out;
}

}  // namespace pileus::volume
