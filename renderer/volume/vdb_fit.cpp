#include "renderer/volume/vdb_fit.h"

#include <algorithm>
#include <cctype>

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

/// Its warnings, place and size; false: it is empty.
bool measure(VdbFit& out, const ImportedGrid& imported) {
  out.warnings.insert(out.warnings.end(), imported.warnings.begin(), imported.warnings.end());
  const BrickGrid& grid = *imported.grid;
  if (grid.empty()) return false;
  out.voxelSize = out.bounds.empty() ? grid.voxelSize : std::min(out.voxelSize, grid.voxelSize);
  const Box3 bulk = bulkBounds(grid);
  const dvec3 extent = bulk.size();
  out.longest = std::max({out.longest, extent.x, extent.y, extent.z});
  out.bounds.extend(transformed(bulk, grid.worldFromIndex));
  return true;
}

bool isFire(GridRole role) { return role == GridRole::Temperature || role == GridRole::Flame; }

/// The chosen grid, with an extinction for it; nothing where it is empty.
Result<std::optional<Instance>> addSmoke(VdbFit& out, JobControl& control) {
  PILEUS_TRY(const ImportedGrid imported, importVdb(out.file, out.byDefault ? "" : out.guess.grid, control));
  if (!measure(out, imported)) return std::optional<Instance>{};
  out.fit = autofit(*imported.grid);
  std::optional<Instance> smoke(std::in_place);
  smoke->shape = Shape::Grid;
  smoke->grid = imported.grid;
  smoke->worldFromLocal = imported.grid->worldFromIndex;
  smoke->medium.extinction = out.fit.extinction;
  return smoke;
}

/// The grid that glows; nothing where it is too cold.
Result<void> addFire(VdbFit& out, const VdbInfo& info, const GridInfo& fire, const Instance* smoke,
                     JobControl& control) {
  PILEUS_TRY(const ImportedGrid imported, importVdb(out.file, fire.name, control));
  FireFit fit = fitFire(imported.grid, control, smoke);
  if (!(fit.brightness > 0)) return {};
  measure(out, imported);
  fit.grid = fire.name;
  fit.why = "by its name";
  const bool flames = roleOfGrid(fire.name) == GridRole::Flame;
  fit.confidence = flames || fit.kelvins ? Confidence::Likely : Confidence::Guess;
  const bool noFlames = std::any_of(info.grids.begin(), info.grids.end(), [](const GridInfo& g) {
    return roleOfGrid(g.name) == GridRole::Flame && !(g.maximum > 0);
  });
  if (!flames && noFlames)
    fit.why += "; the file's flames are empty, so it may be hot smoke rather than fire";
  if (!out.smoke) {
    out.guess.grid = fire.name;
    out.guess.why = "no grid is called density or smoke, so it is fire alone";
  }
  std::vector<std::string> others;
  for (const GridInfo& g : info.grids)
    if (g.name != out.guess.grid && g.name != fire.name) others.push_back(g.name);
  out.guess.notes = notesOnOthers(others);
  out.fire = std::move(fit);
  return {};
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
  out.frames = framesBeside(path);
  const GridInfo* fire = fireGrid(info.grids);
  out.byDefault =
      info.chosen >= 0 && info.grids[static_cast<std::size_t>(info.chosen)].name == out.guess.grid;
  out.smoke = !fire || !isFire(roleOfGrid(out.guess.grid));
  std::optional<Instance> smoke;
  if (out.smoke) {
    PILEUS_TRY(smoke, addSmoke(out, control));
  }
  if (fire) PILEUS_CHECK(addFire(out, info, *fire, smoke ? &*smoke : nullptr, control));
  if (!out.smoke && !out.fire) {  // heat that does not glow is shown as smoke rather than not at all
    out.smoke = true;
    PILEUS_TRY(smoke, addSmoke(out, control));
  }
  return out;
}

}  // namespace pileus::volume
