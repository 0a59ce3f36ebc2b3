#include "renderer/volume/vdb_file.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/points/PointDataGrid.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "renderer/volume/brick_builder.h"
#include "renderer/volume/grid_guess.h"
#include "renderer/volume/vdb_damage.h"
#include "renderer/volume/vdb_text.h"
#include "renderer/volume/vdb_tree.h"

namespace pileus::volume {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;

/// OpenVDB multiplies row vectors from the left, glm column vectors from the right: its rows are our columns.
dmat4 toMatrix(const openvdb::math::Transform& t) {
  const openvdb::math::Mat4d m = t.baseMap()->getAffineMap()->getMat4();
  dmat4 out;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) out[c][r] = m(c, r);
  return out;
}

std::string valueTypeOf(const openvdb::GridBase& g) {
  if (g.isType<openvdb::points::PointDataGrid>()) return "points";
  if (g.saveFloatAsHalf() && g.valueType() == "float") return "half";
  return cleanText(g.valueType());
}

/// Calls f with the grid as its own type if its values are scalars.
template <class F>
bool withScalar(const openvdb::GridBase& g, F&& f) {
  using ScalarGrids = openvdb::TypeList<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid,
                                        openvdb::Int64Grid, openvdb::BoolGrid, openvdb::MaskGrid>;
  return g.apply<ScalarGrids>(std::forward<F>(f));
}

bool isScalar(const openvdb::GridBase& g) {
  return withScalar(g, [](const auto&) {});
}

std::optional<std::string> absurdClaim(const openvdb::GridBase& g) {
  const auto lowest = g.getMetadata<openvdb::Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MIN);
  const auto highest = g.getMetadata<openvdb::Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MAX);
  if (!lowest || !highest) return std::nullopt;
  return absurdBounds(toIvec(Coord(lowest->value())), toIvec(Coord(highest->value())));
}

constexpr int kNeverDrawn = 9;

int rankOf(const openvdb::GridBase& g) {
  const GridRole role = roleOfGrid(g.getName());
  const bool scalar = isScalar(g), floating = g.valueType() == "float" || g.valueType() == "double";
  const bool fog = g.getGridClass() == openvdb::GRID_FOG_VOLUME, named = role == GridRole::Density;
  if (!scalar) return kNeverDrawn;
  if (!g.transform().isLinear()) return kNeverDrawn - 1;
  if (g.getGridClass() == openvdb::GRID_LEVEL_SET) return kNeverDrawn - 2;  // fog before surfaces
  if (floating && named) return fog ? 0 : 1;
  // Heat is no density, but a file that holds nothing else shows it rather than nothing.
  if (role != GridRole::Density && role != GridRole::Unknown) return 5;
  if (fog) return 2;
  return floating ? 3 : 4;
}

/// Why such a grid is never drawn; empty: it may be.
std::string undrawable(const openvdb::GridBase& g) {
  if (g.isType<openvdb::points::PointDataGrid>()) return "is a point grid; points are not drawn";
  if (!isScalar(g))
    return fmt::format("holds {} values; only scalar grids are drawn", cleanText(g.valueType()));
  return {};
}

/// Values so small beside the largest are nothing: no bounds, bricks or shadows are made for them.
constexpr double kNothing = 5e-6;

TreeValues valuesOf(const Range& r, double background, bool levelSet) {
  if (!levelSet) return {kNothing * std::max(std::abs(r.minimum), std::abs(r.maximum)), 0};
  // Both ends of the band are the background, except in files that were written carelessly.
  const double band = std::isfinite(background) && background > 0 ? background : std::abs(r.minimum);
  return {kNothing, band > 0 ? band : 1.0};
}

/// A background that counts fills all the space between what was set.
std::optional<std::string> tooMuchBackground(double background, const TreeValues& values, ivec3 bricks) {
  constexpr double kMostBricks = 1 << 18;  // 1024^3 voxels
  const double all = double(bricks.x) * bricks.y * bricks.z;
  if (!values.counts(background) || all <= kMostBricks) return std::nullopt;
  return fmt::format(
      "its background is {:.4g} and not 0, which would fill {:.3g} voxels between those that are set; write "
      "it with a background of 0",
      background, all * kBrickSize * kBrickSize * kBrickSize);
}

/// Bricks of one tree, and what is to be said of it.
template <class Tree>
Result<ImportedGrid> importTree(const Tree& tree, const std::string& name, const dmat4& worldFromIndex,
                                bool levelSet, JobControl& control) {
  const Range r = rangeOf(tree);
  const auto background = static_cast<double>(tree.background());
  const TreeValues values = valuesOf(r, background, levelSet);
  std::vector<std::string> warnings;
  const auto warn = [&](const std::string& text) {
    warnings.push_back(fmt::format("grid '{}'{}", name, text));
  };
  if (r.nonFinite > 0) warn(fmt::format(": {} voxels are not finite and were taken as 0", r.nonFinite));
  if (values.counts(background))
    warn(fmt::format(": its background is {}; outside its active bounds it is taken as 0", background));
  if (r.minimum < 0 && !levelSet)
    warn(fmt::format(" has negative values (down to {:.4g}); they are drawn as empty", r.minimum));
  const CoordBBox box = countingBounds(tree, values);
  if (box.empty()) {
    warn(levelSet ? " is a level set without an inside: nothing of it is drawn"
                  : ": all of its values are 0");
    return ImportedGrid{emptyGrid(name, worldFromIndex), std::move(warnings), {}};
  }
  VoxelSource source{name, worldFromIndex, toIvec(box.min()), toIvec(box.max()), {}, {}, {}};
  PILEUS_TRY(const ivec3 bricks, latticeSize(name, source.activeMin, source.activeMax));
  if (const auto why = tooMuchBackground(background, values, bricks))
    return fail(Code::Input, "grid '{}': {}", name, *why);
  // Of a level set the band is active and the inside is not: the builder counts.
  if (!levelSet)
    source.stats = ActiveStats{r.count, static_cast<float>(r.minimum), static_cast<float>(r.maximum)};
  const TreeBlocks blocks(tree, values, source.activeMin, source.activeMax, bricks);
  source.fill = [&](ivec3 lo, float* out) { return blocks.fill(lo, out); };
  source.touches = [&](ivec3 lo) { return blocks.touches(lo); };
  PILEUS_TRY(const BuildResult built, buildBricks(source, control, 0.4));
  return ImportedGrid{built.grid, std::move(warnings), {}, levelSet};
}

}  // namespace

struct VdbFile::Impl {
  struct Entry {
    std::string handle;  ///< how OpenVDB addresses it
    std::string base, name;
    openvdb::GridBase::ConstPtr metadata;  ///< null: nobody here knows what it is
    std::string strange;                   ///< then: what it says it is

    int rank() const { return metadata ? rankOf(*metadata) : kNeverDrawn + 1; }
    bool isLevelSet() const { return metadata && metadata->getGridClass() == openvdb::GRID_LEVEL_SET; }
    std::string undrawable() const;  ///< why it is never drawn; empty: it may be
  };
  std::unique_ptr<openvdb::io::File> file;
  std::vector<Entry> entries;

  void list(const std::vector<ListedGrid>& listed);
  /// Warnings of grids that are of a type nobody here knows, and so were left out.
  std::vector<std::string> strangers(const Entry& than) const;
  const Entry* choose() const;
  std::vector<std::string> others(const Entry& than) const;  ///< names of the other grids
  Result<const Entry*> find(const std::string& name) const;
  GridInfo describe(const Entry& entry) const;
};

std::string VdbFile::Impl::Entry::undrawable() const {
  return metadata ? volume::undrawable(*metadata) : strange;
}

void VdbFile::Impl::list(const std::vector<ListedGrid>& listed) {
  std::map<std::string, std::vector<Entry>> byName;
  const auto strangeType = [&](const std::string& handle) {
    for (const ListedGrid& g : listed)
      if (g.name == handle) return g.strange;
    return std::string();
  };
  for (auto it = file->beginName(); it != file->endName(); ++it) {
    Entry e{it.gridName(), {}, {}, {}, {}};
    std::string name = e.handle.substr(0, e.handle.rfind('['));
    const std::string type = strangeType(e.handle);
    if (!type.empty())
      e.strange = fmt::format("is of the type {}, which is not known here", cleanText(type));
    else
      try {
        e.metadata = file->readGridMetadata(e.handle);
        name = e.metadata->getName();
      } catch (const openvdb::LookupError& error) {  // the type of its transform
        e.strange = fmt::format("cannot be read ({})", cleanText(error.what(), 200));
      }
    e.base = name.empty() ? "unnamed" : cleanText(name);
    byName[e.base].push_back(std::move(e));
  }
  for (auto& [base, group] : byName) {
    const auto suffix = [](const Entry& e) {
      const auto at = e.handle.rfind('[');
      return at == std::string::npos ? -1L : std::strtol(e.handle.c_str() + at + 1, nullptr, 10);
    };
    std::stable_sort(group.begin(), group.end(),
                     [&](const Entry& a, const Entry& b) { return suffix(a) < suffix(b); });
    for (std::size_t i = 0; i < group.size(); ++i) {
      group[i].name = group.size() == 1 ? base : fmt::format("{}[{}]", base, i);
      entries.push_back(std::move(group[i]));
    }
  }
}

const VdbFile::Impl::Entry* VdbFile::Impl::choose() const {
  const auto it = std::min_element(entries.begin(), entries.end(),
                                   [](const Entry& a, const Entry& b) { return a.rank() < b.rank(); });
  return it == entries.end() ? nullptr : &*it;
}

std::vector<std::string> VdbFile::Impl::others(const Entry& than) const {
  std::vector<std::string> names;
  for (const Entry& e : entries)
    if (&e != &than && names.size() < 32) names.push_back(e.name);
  return names;
}

std::vector<std::string> VdbFile::Impl::strangers(const Entry& than) const {
  std::vector<std::string> out;
  for (const Entry& e : entries)
    if (&e != &than && !e.strange.empty() && out.size() < 8)
      out.push_back(fmt::format("grid '{}' {}: it is left out", e.name, e.strange));
  return out;
}

Result<const VdbFile::Impl::Entry*> VdbFile::Impl::find(const std::string& name) const {
  for (const Entry& e : entries)
    if (e.name == name) return &e;
  for (const Entry& e : entries)  // several share the name: the first
    if (e.base == name || e.handle == name) return &e;
  std::string names;
  for (const Entry& e : entries) names += fmt::format("{}{}", names.empty() ? "" : ", ", e.name);
  return fail(Code::Input, "it has no grid '{}'; its grids are: {}", cleanText(name), names);
}

GridInfo VdbFile::Impl::describe(const Entry& entry) const {
  GridInfo g;
  g.name = entry.name;
  g.reason = entry.undrawable();
  if (!entry.metadata) {
    g.gridClass = g.valueType = g.transform = "unknown";
    return g;
  }
  const openvdb::GridBase& meta = *entry.metadata;
  g.gridClass = openvdb::GridBase::gridClassToString(meta.getGridClass());
  g.valueType = valueTypeOf(meta);
  g.transform = transformWords(meta.transform().mapType());
  g.creator = cleanText(meta.getCreator());
  const bool affine = meta.transform().isLinear();
  if (affine) g.worldFromIndex = toMatrix(meta.transform());
  const auto size = meta.voxelSize();
  g.voxelSize = {size.x(), size.y(), size.z()};
  g.scalar = isScalar(meta);
  if (g.reason.empty() && !affine)
    g.reason = "its transform is not affine (a frustum); resample it to a uniform grid";

  const auto grid = file->readGrid(entry.handle);
  CoordBBox box = grid->evalActiveVoxelBoundingBox();
  g.activeVoxels = grid->activeVoxelCount();
  g.memoryBytes = grid->memUsage();
  bool counts = !g.scalar;
  withScalar(*grid, [&](const auto& typed) {
    const Range r = rangeOf(typed.tree());
    g.nonFinite = r.nonFinite;
    g.minimum = r.minimum;
    g.maximum = r.maximum;
    g.background = static_cast<double>(typed.background());
    const CoordBBox counting = countingBounds(typed.tree(), valuesOf(r, g.background, entry.isLevelSet()));
    counts = !counting.empty();
    if (counts) box = counting;
  });
  g.hasBounds = g.activeVoxels > 0 && !box.empty();
  if (g.hasBounds) {
    g.indexMin = toIvec(box.min());
    g.indexMax = toIvec(box.max());
    if (affine) g.worldBounds = transformed({dvec3(g.indexMin), dvec3(g.indexMax)}, g.worldFromIndex);
    if (auto lattice = latticeSize(g.name, g.indexMin, g.indexMax); counts && g.reason.empty() && !lattice) {
      g.reason = lattice.error().message;
      g.damaged = true;
    }
  } else if (auto claim = absurdClaim(*grid)) {
    g.damaged = true;
    g.reason = *claim;
  } else if (g.reason.empty()) {
    g.reason = "holds no active voxels";
  }
  g.drawable = g.reason.empty();
  return g;
}

VdbFile::VdbFile() : impl_(std::make_unique<Impl>()) {}
VdbFile::~VdbFile() = default;

Result<std::unique_ptr<VdbFile>> VdbFile::open(const std::filesystem::path& path) {
  openvdb::initialize();
  std::unique_ptr<VdbFile> out(new VdbFile);
  out->impl_->file = std::make_unique<openvdb::io::File>(path.string());
  try {
    PILEUS_TRY(const std::vector<ListedGrid> listed, listGrids(path));
    out->impl_->file->open(false);  // no delayed loading
    out->impl_->list(listed);
  } catch (
      const openvdb::LookupError& e) {  // of a file that was written to a stream, where none can be skipped
    return fail(Code::Input, "holds a grid that is not known here, and so cannot be read ({})",
                cleanText(e.what(), 300));
  } catch (const openvdb::Exception& e) {
    return fail(Code::Input, "is damaged or truncated ({})", cleanText(e.what(), 300));
  }
  return out;
}

Result<VdbInfo> VdbFile::info(JobControl& control) {
  VdbInfo info;
  info.version = cleanText(impl_->file->version());
  if (const auto metadata = impl_->file->getMetadata())
    for (auto it = metadata->beginMeta(); it != metadata->endMeta(); ++it)
      info.metadata.emplace_back(cleanText(it->first), cleanText(it->second->str(), 400));
  const auto* chosen = impl_->choose();
  for (const auto& entry : impl_->entries) {
    if (&entry == chosen && entry.rank() < kNeverDrawn - 1) info.chosen = static_cast<int>(info.grids.size());
    info.grids.push_back(impl_->describe(entry));
    control.progress(double(info.grids.size()) / double(impl_->entries.size()));
  }
  return info;
}

Result<ImportedGrid> VdbFile::import(const std::string& gridName, LevelSets levelSets, JobControl& control) {
  const Impl::Entry* entry = impl_->choose();
  if (!entry) return ImportedGrid{emptyGrid("empty"), {"the file holds no grids"}, {}};
  if (!gridName.empty()) {
    PILEUS_TRY(entry, impl_->find(gridName));
  }
  std::vector<std::string> warnings = impl_->strangers(*entry);
  const auto empty = [&](std::string_view why) {
    warnings.insert(warnings.begin(), fmt::format("grid '{}' {}", entry->name, why));
    return ImportedGrid{emptyGrid(entry->name), warnings, impl_->others(*entry)};
  };
  if (const std::string why = entry->undrawable(); !why.empty()) return empty(why);
  const openvdb::GridBase& meta = *entry->metadata;
  if (entry->isLevelSet() && levelSets == LevelSets::Ignore)
    return empty("is a level set (distances to a surface), which this node ignores");
  if (!meta.transform().isLinear())
    return fail(Code::Input, "grid '{}': its transform is not affine ({}); resample it to a uniform grid",
                entry->name, transformWords(meta.transform().mapType()));
  const auto grid = impl_->file->readGrid(entry->handle);
  control.progress(0.3);
  if (grid->activeVoxelCount() == 0 || grid->evalActiveVoxelBoundingBox().empty()) {
    if (auto claim = absurdClaim(*grid)) return fail(Code::Input, "grid '{}': {}", entry->name, *claim);
    return empty("holds no active voxels");
  }
  Result<ImportedGrid> out = fail(Code::Internal, "no voxels");
  withScalar(*grid, [&](const auto& typed) {
    out = importTree(typed.tree(), entry->name, toMatrix(meta.transform()), entry->isLevelSet(), control);
  });
  if (!out) return out.error();
  out->warnings.insert(out->warnings.end(), warnings.begin(), warnings.end());
  out->others = impl_->others(*entry);
  return out;
}

}  // namespace pileus::volume
