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

namespace pileus::volume {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;

ivec3 toIvec(const Coord& c) { return {c.x(), c.y(), c.z()}; }

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

/// Calls f(value, box) for each active tile and f(value, one voxel) for each active voxel.
template <class Tree, class F>
void forActive(const Tree& tree, F&& f) {
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    for (auto v = leaf->cbeginValueOn(); v; ++v) f(static_cast<double>(*v), std::uint64_t(1));
  auto tile = tree.cbeginValueOn();
  tile.setMaxDepth(Tree::DEPTH - 2);
  for (; tile; ++tile) f(static_cast<double>(*tile), static_cast<std::uint64_t>(tile.getVoxelCount()));
}

struct Range {
  std::uint64_t count = 0, nonFinite = 0;
  double minimum = std::numeric_limits<double>::infinity(), maximum = -minimum;
};

template <class Tree>
Range rangeOf(const Tree& tree) {
  Range r;
  forActive(tree, [&](double v, std::uint64_t n) {
    r.count += n;
    if (!std::isfinite(v))
      r.nonFinite += n;
    else {
      r.minimum = std::min(r.minimum, v);
      r.maximum = std::max(r.maximum, v);
    }
  });
  if (r.minimum > r.maximum) r.minimum = r.maximum = 0;
  return r;
}

/// Hands blocks of a tree to the brick builder.
template <class Tree>
class TreeBlocks {
 public:
  TreeBlocks(const Tree& tree, ivec3 activeMin, ivec3 activeMax, ivec3 bricks)
      : tree_(tree),
        origin_(activeMin - 1),
        bricks_(bricks),
        touched_(std::size_t(bricks.x) * std::size_t(bricks.y) * std::size_t(bricks.z), 0) {
    if (static_cast<double>(tree.background()) != 0.0) {
      std::fill(touched_.begin(), touched_.end(), std::uint8_t(1));
      return;
    }
    const CoordBBox active(Coord(activeMin.x, activeMin.y, activeMin.z),
                           Coord(activeMax.x, activeMax.y, activeMax.z));
    const auto mark = [&](CoordBBox box) {
      box.intersect(active);
      if (!box.empty()) markBricks(toIvec(box.min()), toIvec(box.max()));
    };
    for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf) mark(leaf->getNodeBoundingBox());
    auto tile = tree.cbeginValueAll();  // an inactive tile may hold a value as well
    tile.setMaxDepth(Tree::DEPTH - 2);
    for (; tile; ++tile) {
      if (static_cast<double>(*tile) == 0.0) continue;
      CoordBBox box;
      tile.getBoundingBox(box);
      mark(box);
    }
  }

  bool touches(ivec3 lo) const { return touched_[flat((lo + kApron - origin_) / kBrickSize)] != 0; }

  Fill fill(ivec3 lo, float* out) const {
    openvdb::tree::ValueAccessor<const Tree, false> access(tree_);
    constexpr int dim = Tree::LeafNodeType::DIM;
    const ivec3 first = (lo >> 3) << 3;
    static_assert(dim == 8);
    constexpr int most = (kStoredSize + dim - 2) / dim + 1;
    const typename Tree::LeafNodeType* leaves[most * most * most];
    float tiles[most * most * most];
    bool uniform = true;
    for (int k = 0, i = 0; k < most; ++k)
      for (int j = 0; j < most; ++j)
        for (int m = 0; m < most; ++m, ++i) {
          const Coord at(first.x + m * dim, first.y + j * dim, first.z + k * dim);
          leaves[i] = access.probeConstLeaf(at);
          tiles[i] = leaves[i] ? 0.0f : static_cast<float>(access.getValue(at));
          uniform = uniform && !leaves[i] && tiles[i] == tiles[0];
        }
    if (uniform) {
      out[0] = tiles[0];
      return out[0] == 0 ? Fill::Zero : Fill::Constant;
    }
    for (int z = 0; z < kStoredSize; ++z)
      for (int y = 0; y < kStoredSize; ++y)
        for (int x = 0; x < kStoredSize; ++x) {
          const ivec3 p = lo + ivec3(x, y, z) - first;
          const int i = ((p.z >> 3) * most + (p.y >> 3)) * most + (p.x >> 3);
          const auto offset = static_cast<openvdb::Index>(((p.x & 7) << 6) | ((p.y & 7) << 3) | (p.z & 7));
          *out++ = leaves[i] ? static_cast<float>(leaves[i]->getValue(offset)) : tiles[i];
        }
    return Fill::Voxels;
  }

 private:
  std::size_t flat(ivec3 b) const {
    return (std::size_t(b.z) * std::size_t(bricks_.y) + std::size_t(b.y)) * std::size_t(bricks_.x) +
           std::size_t(b.x);
  }
  /// Bricks whose block (own voxels and apron: 16 b - 1 .. 16 b + 16 of the lattice) meets the box.
  void markBricks(ivec3 lowest, ivec3 highest) {
    const ivec3 b0 = glm::max(ivec3(0), (lowest - origin_ - 1) / kBrickSize);
    const ivec3 b1 = glm::min(bricks_ - 1, (highest - origin_ + 1) / kBrickSize);
    for (int z = b0.z; z <= b1.z; ++z)
      for (int y = b0.y; y <= b1.y; ++y)
        for (int x = b0.x; x <= b1.x; ++x) touched_[flat({x, y, z})] = 1;
  }

  const Tree& tree_;
  ivec3 origin_, bricks_;
  std::vector<std::uint8_t> touched_;
};

std::optional<std::string> absurdClaim(const openvdb::GridBase& g) {
  const auto lowest = g.getMetadata<openvdb::Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MIN);
  const auto highest = g.getMetadata<openvdb::Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MAX);
  if (!lowest || !highest) return std::nullopt;
  return absurdBounds(toIvec(Coord(lowest->value())), toIvec(Coord(highest->value())));
}

int rankOf(const openvdb::GridBase& g) {
  const GridRole role = roleOfGrid(g.getName());
  const bool scalar = isScalar(g), floating = g.valueType() == "float" || g.valueType() == "double";
  const bool fog = g.getGridClass() == openvdb::GRID_FOG_VOLUME, named = role == GridRole::Density;
  if (!scalar) return 9;
  if (g.getGridClass() == openvdb::GRID_LEVEL_SET) return 8;
  if (!g.transform().isLinear()) return 7;
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
  if (g.getGridClass() == openvdb::GRID_LEVEL_SET)
    return "is a level set (distances to a surface); only fog volumes are drawn";
  return {};
}

}  // namespace

struct VdbFile::Impl {
  struct Entry {
    std::string handle;  ///< how OpenVDB addresses it
    std::string base, name;
    openvdb::GridBase::ConstPtr metadata;
  };
  std::unique_ptr<openvdb::io::File> file;
  std::vector<Entry> entries;

  void list();
  const Entry* choose() const;
  std::vector<std::string> others(const Entry& than) const;  ///< names of the other grids
  Result<const Entry*> find(const std::string& name) const;
  GridInfo describe(const Entry& entry) const;
};

void VdbFile::Impl::list() {
  std::map<std::string, std::vector<Entry>> byName;
  for (auto it = file->beginName(); it != file->endName(); ++it) {
    Entry e{it.gridName(), {}, {}, file->readGridMetadata(it.gridName())};
    e.base = e.metadata->getName().empty() ? "unnamed" : cleanText(e.metadata->getName());
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
  const auto it = std::min_element(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return rankOf(*a.metadata) < rankOf(*b.metadata);
  });
  return it == entries.end() ? nullptr : &*it;
}

std::vector<std::string> VdbFile::Impl::others(const Entry& than) const {
  std::vector<std::string> names;
  for (const Entry& e : entries)
    if (&e != &than && names.size() < 32) names.push_back(e.name);
  return names;
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
  const openvdb::GridBase& meta = *entry.metadata;
  GridInfo g;
  g.name = entry.name;
  g.gridClass = openvdb::GridBase::gridClassToString(meta.getGridClass());
  g.valueType = valueTypeOf(meta);
  g.transform = transformWords(meta.transform().mapType());
  g.creator = cleanText(meta.getCreator());
  const bool affine = meta.transform().isLinear();
  if (affine) g.worldFromIndex = toMatrix(meta.transform());
  const auto size = meta.voxelSize();
  g.voxelSize = {size.x(), size.y(), size.z()};
  g.scalar = isScalar(meta);
  g.reason = undrawable(meta);
  if (g.reason.empty() && !affine)
    g.reason = "its transform is not affine (a frustum); resample it to a uniform grid";

  const auto grid = file->readGrid(entry.handle);
  const CoordBBox box = grid->evalActiveVoxelBoundingBox();
  g.activeVoxels = grid->activeVoxelCount();
  g.memoryBytes = grid->memUsage();
  withScalar(*grid, [&](const auto& typed) {
    const Range r = rangeOf(typed.tree());
    g.nonFinite = r.nonFinite;
    g.minimum = r.minimum;
    g.maximum = r.maximum;
    g.background = static_cast<double>(typed.background());
  });
  g.hasBounds = g.activeVoxels > 0 && !box.empty();
  if (g.hasBounds) {
    g.indexMin = toIvec(box.min());
    g.indexMax = toIvec(box.max());
    if (affine) g.worldBounds = transformed({dvec3(g.indexMin), dvec3(g.indexMax)}, g.worldFromIndex);
    if (auto lattice = latticeSize(g.name, g.indexMin, g.indexMax); g.reason.empty() && !lattice) {
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
    if (const std::string missing = whatIsMissing(path); !missing.empty()) return Error{Code::Input, missing};
    out->impl_->file->open(false);  // no delayed loading
    out->impl_->list();
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
    if (&entry == chosen && rankOf(*entry.metadata) < 7) info.chosen = static_cast<int>(info.grids.size());
    info.grids.push_back(impl_->describe(entry));
    control.progress(double(info.grids.size()) / double(impl_->entries.size()));
  }
  return info;
}

Result<ImportedGrid> VdbFile::import(const std::string& gridName, JobControl& control) {
  const Impl::Entry* entry = impl_->choose();
  if (!entry) return ImportedGrid{emptyGrid("empty"), {"the file holds no grids"}, {}};
  if (!gridName.empty()) {
    PILEUS_TRY(entry, impl_->find(gridName));
  }
  const openvdb::GridBase& meta = *entry->metadata;
  const auto empty = [&](std::string_view why) {
    return ImportedGrid{
        emptyGrid(entry->name), {fmt::format("grid '{}' {}", entry->name, why)}, impl_->others(*entry)};
  };
  if (const std::string why = undrawable(meta); !why.empty()) return empty(why);
  if (!meta.transform().isLinear())
    return fail(Code::Input, "grid '{}': its transform is not affine ({}); resample it to a uniform grid",
                entry->name, transformWords(meta.transform().mapType()));
  const auto grid = impl_->file->readGrid(entry->handle);
  control.progress(0.3);
  const CoordBBox box = grid->evalActiveVoxelBoundingBox();
  if (grid->activeVoxelCount() == 0 || box.empty()) {
    if (auto claim = absurdClaim(*grid)) return fail(Code::Input, "grid '{}': {}", entry->name, *claim);
    return empty("holds no active voxels");
  }
  VoxelSource source{entry->name, toMatrix(meta.transform()), toIvec(box.min()), toIvec(box.max()), {}, {},
                     {}};
  PILEUS_TRY(const ivec3 bricks, latticeSize(source.name, source.activeMin, source.activeMax));
  std::vector<std::string> warnings;
  Result<BuildResult> built = fail(Code::Internal, "no voxels");
  withScalar(*grid, [&](const auto& typed) {
    const auto& tree = typed.tree();
    const Range r = rangeOf(tree);
    source.stats = ActiveStats{r.count, static_cast<float>(r.minimum), static_cast<float>(r.maximum)};
    const TreeBlocks blocks(tree, source.activeMin, source.activeMax, bricks);
    source.fill = [&](ivec3 lo, float* out) { return blocks.fill(lo, out); };
    source.touches = [&](ivec3 lo) { return blocks.touches(lo); };
    built = buildBricks(source, control, 0.4);
    if (r.nonFinite > 0)
      warnings.push_back(
          fmt::format("grid '{}': {} voxels are not finite and were taken as 0", source.name, r.nonFinite));
    if (static_cast<double>(tree.background()) != 0.0)
      warnings.push_back(
          fmt::format("grid '{}': its background is {}; outside its active bounds it is taken as 0",
                      source.name, static_cast<double>(tree.background())));
    if (r.minimum < 0)
      warnings.push_back(fmt::format(
          "grid '{}' has negative values (down to {:.4g}); they are drawn as empty", source.name, r.minimum));
    if (r.minimum == 0 && r.maximum == 0)
      warnings.push_back(fmt::format("grid '{}': all of its values are 0", source.name));
  });
  if (!built) return built.error();
  return ImportedGrid{built->grid, std::move(warnings), impl_->others(*entry)};
}

}  // namespace pileus::volume
