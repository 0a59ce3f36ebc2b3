#include "renderer/volume/brick_builder.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

#include "renderer/volume/brick_quantize.h"
#include "renderer/volume/payload_buffer.h"

namespace pileus::volume {
namespace {

constexpr int kBrickVoxels = kBrickSize * kBrickSize * kBrickSize;
constexpr std::size_t kGroupsPerChunk =
    2048;  // up to 16384 bricks (96 MB) of scratch before empty slots are given back

/// The voxels of one level as floats, a pointer per brick; null: all zero.
struct SparseFloats {
  ivec3 bricks{0};
  std::vector<std::unique_ptr<float[]>> data;

  explicit SparseFloats(ivec3 size)
      : bricks(size), data(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z)) {}
  const float* at(ivec3 b) const {
    if (glm::any(glm::lessThan(b, ivec3(0))) || glm::any(glm::greaterThanEqual(b, bricks))) return nullptr;
    return data[(std::size_t(b.z) * std::size_t(bricks.y) + std::size_t(b.y)) * std::size_t(bricks.x) +
                std::size_t(b.x)]
        .get();
  }
};

struct Stats {
  std::uint64_t count = 0, nonFinite = 0;
  float minimum = std::numeric_limits<float>::infinity(), maximum = -std::numeric_limits<float>::infinity();
  void merge(const Stats& s) {
    count += s.count;
    nonFinite += s.nonFinite;
    minimum = std::min(minimum, s.minimum);
    maximum = std::max(maximum, s.maximum);
  }
};

ivec3 unflatten(std::size_t i, ivec3 size) {
  const auto x = static_cast<std::size_t>(size.x), y = static_cast<std::size_t>(size.y);
  return {static_cast<int>(i % x), static_cast<int>(i / x % y), static_cast<int>(i / x / y)};
}

std::size_t volumeOf(ivec3 s) { return std::size_t(s.x) * std::size_t(s.y) * std::size_t(s.z); }

std::size_t storedIndex(int x, int y, int z) {
  return (static_cast<std::size_t>(z) * kStoredSize + static_cast<std::size_t>(y)) * kStoredSize +
         static_cast<std::size_t>(x);
}

/// Zeroes what lies outside the active bounds, so that a source may answer with its background there.
void clip(float* block, ivec3 lo, ivec3 activeMin, ivec3 activeMax) {
  if (glm::all(glm::greaterThanEqual(lo, activeMin)) &&
      glm::all(glm::lessThanEqual(lo + (kStoredSize - 1), activeMax)))
    return;
  for (int z = 0; z < kStoredSize; ++z)
    for (int y = 0; y < kStoredSize; ++y)
      for (int x = 0; x < kStoredSize; ++x) {
        const ivec3 p = lo + ivec3(x, y, z);
        if (glm::any(glm::lessThan(p, activeMin)) || glm::any(glm::greaterThan(p, activeMax)))
          block[storedIndex(x, y, z)] = 0;
      }
}

/// One brick of a level with its apron, from the sparse floats of that level.
Fill gather(const SparseFloats& level, ivec3 brick, float* out) {
  bool any = false;
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const float* source = level.at(brick + ivec3(dx, dy, dz));
        const ivec3 d(dx, dy, dz);
        ivec3 from, to,
            shift;  // stored range of `out` that this neighbour covers, and where it starts in the neighbour
        for (int a = 0; a < 3; ++a) {
          from[a] = d[a] < 0 ? 0 : d[a] == 0 ? kApron : kBrickSize + kApron;
          to[a] = d[a] < 0 ? kApron : d[a] == 0 ? kBrickSize + kApron : kStoredSize;
          shift[a] = -kApron - d[a] * kBrickSize;
        }
        any |= source != nullptr;
        for (int z = from.z; z < to.z; ++z)
          for (int y = from.y; y < to.y; ++y) {
            const int row = ((z + shift.z) * kBrickSize + y + shift.y) * kBrickSize + shift.x;
            for (int x = from.x; x < to.x; ++x) out[storedIndex(x, y, z)] = source ? source[row + x] : 0.0f;
          }
      }
  return any ? Fill::Voxels : Fill::Zero;
}

/// Writes the 2x2x2 means of a brick's own voxels into its octant of the parent.
void reduceInto(std::unique_ptr<float[]>& parent, ivec3 octant, const float* block) {
  if (!parent) parent = std::make_unique<float[]>(kBrickVoxels);
  constexpr int half = kBrickSize / 2;
  for (int z = 0; z < half; ++z)
    for (int y = 0; y < half; ++y)
      for (int x = 0; x < half; ++x) {
        double sum = 0;
        for (int c = 0; c < 8; ++c)
          sum += static_cast<double>(
              block[storedIndex(2 * x + 1 + (c & 1), 2 * y + 1 + ((c >> 1) & 1), 2 * z + 1 + (c >> 2))]);
        const ivec3 at = octant * half + ivec3(x, y, z);
        parent[static_cast<std::size_t>((at.z * kBrickSize + at.y) * kBrickSize + at.x)] =
            static_cast<float>(sum / 8);
      }
}

void addStats(Stats& stats, const float* block) {
  for (int z = 1; z <= kBrickSize; ++z)
    for (int y = 1; y <= kBrickSize; ++y)
      for (int x = 1; x <= kBrickSize; ++x) {
        const float v = block[storedIndex(x, y, z)];
        if (v == 0) continue;
        ++stats.count;
        stats.minimum = std::min(stats.minimum, v);
        stats.maximum = std::max(stats.maximum, v);
      }
}

struct Build {
  JobControl& control;
  const BuildLimits& limits;
  PayloadBuffer payload;
  std::uint64_t used = 0;   ///< payloads kept so far
  double from = 0, to = 1;  ///< progress of the level being built
};

using BrickFill = std::function<Fill(ivec3 brick, float* out, Stats& stats)>;
using BrickTest = std::function<bool(ivec3 brick)>;

/// Builds one level: its table, its payloads, and the floats of the next level. Work goes by groups of 2x2x2
/// bricks, the bricks of one brick of the next level, so that no two threads write one float brick; and by
/// chunks, so that the scratch stays small.
Result<Stats> buildLevel(Build& build, Level& level, const BrickFill& fill, const BrickTest& touches,
                         SparseFloats& next) {
  level.table.assign(volumeOf(level.bricks), Brick{});
  const std::size_t groups = next.data.size();
  Stats total;
  for (std::size_t begin = 0; begin < groups; begin += kGroupsPerChunk) {
    const std::size_t end = std::min(groups, begin + kGroupsPerChunk);
    std::vector<std::size_t> order;  // table index of each touched brick of the chunk
    std::vector<std::size_t> firstOfGroup;
    for (std::size_t g = begin; g < end; ++g) {
      firstOfGroup.push_back(order.size());
      for (int c = 0; c < 8; ++c) {
        const ivec3 b = unflatten(g, next.bricks) * 2 + ivec3(c & 1, (c >> 1) & 1, c >> 2);
        if (glm::any(glm::greaterThanEqual(b, level.bricks)) || !touches(b)) continue;
        order.push_back((std::size_t(b.z) * std::size_t(level.bricks.y) + std::size_t(b.y)) *
                            std::size_t(level.bricks.x) +
                        std::size_t(b.x));
      }
    }
    firstOfGroup.push_back(order.size());
    if (!build.payload.resize(build.used + order.size()))
      return fail(Code::Input, "out of memory after {} MiB of bricks", build.used * kStoredVoxels >> 20);
    std::vector<Stats> stats(end - begin);
    tbb::parallel_for(begin, end, [&](std::size_t g) {
      alignas(64) float block[kStoredVoxels];
      for (std::size_t i = firstOfGroup[g - begin]; i < firstOfGroup[g - begin + 1]; ++i) {
        if (build.control.cancelled()) return;
        const ivec3 b = unflatten(order[i], level.bricks);
        if (fill(b, block, stats[g - begin]) == Fill::Zero) continue;
        const bool firstBrick[3] = {b.x == 0, b.y == 0, b.z == 0};
        Brick brick = quantize(block, firstBrick, build.payload.at(build.used + i));
        if (brick.payload != kConstantBrick) brick.payload = static_cast<std::uint32_t>(i);
        level.table[order[i]] = brick;
        if (brick.payload != kConstantBrick || brick.offset != 0) reduceInto(next.data[g], b & 1, block);
      }
    });
    if (build.control.cancelled()) return fail(Code::Cancelled, "cancelled");
    for (const Stats& s : stats) total.merge(s);
    const std::uint64_t base = build.used;
    for (std::size_t index : order) {  // close the gaps that constant bricks left
      Brick& brick = level.table[index];
      if (brick.payload == kConstantBrick) continue;
      const std::uint64_t at = base + brick.payload;
      if (at != build.used) std::memcpy(build.payload.at(build.used), build.payload.at(at), kStoredVoxels);
      brick.payload = static_cast<std::uint32_t>(build.used++);
    }
    if (build.used * kStoredVoxels > build.limits.payloadBytes)
      return fail(Code::Input, "needs more than {} MiB of bricks", build.limits.payloadBytes >> 20);
    build.control.progress(build.from + (build.to - build.from) * double(end) / double(groups));
  }
  return total;
}

double voxelEdge(const dmat4& m) {
  return std::min({glm::length(dvec3(m[0])), glm::length(dvec3(m[1])), glm::length(dvec3(m[2]))});
}

}  // namespace

Key contentKeyOf(const BrickGrid& g) {
  Hasher h;
  h.add(g.name);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) h.add(g.worldFromIndex[c][r]);
  for (int a = 0; a < 3; ++a) h.add(g.origin[a]).add(g.indexBounds.min[a]).add(g.indexBounds.max[a]);
  h.add(g.levels.size());
  for (const Level& level : g.levels) {
    for (int a = 0; a < 3; ++a) h.add(level.bricks[a]);
    static_assert(std::is_trivially_copyable_v<Brick> && sizeof(Brick) == 20);
    h.bytes(level.table.data(), level.table.size() * sizeof(Brick));
  }
  h.add(g.payloadCount).bytes(g.payload.get(), std::size_t(g.payloadCount) * kStoredVoxels);
  h.add(g.voxelSize).add(g.minimum).add(g.maximum).add(g.activeVoxels);
  return h.key();
}

GridPtr emptyGrid(std::string name, const dmat4& worldFromIndex) {
  auto grid = std::make_shared<BrickGrid>();
  grid->name = std::move(name);
  grid->worldFromIndex = worldFromIndex;
  grid->voxelSize = voxelEdge(worldFromIndex);
  grid->content = contentKeyOf(*grid);
  return grid;
}

Result<ivec3> latticeSize(const std::string& name, ivec3 activeMin, ivec3 activeMax,
                          const BuildLimits& limits) {
  ivec3 bricks;
  double lattice = 1;
  for (int a = 0; a < 3; ++a) {
    const std::int64_t extent = std::int64_t(activeMax[a]) - activeMin[a] + 1;
    constexpr std::int64_t reach = std::int64_t(1) << 30;  // index arithmetic stays far from the ends of int
    if (extent > limits.extent || activeMin[a] < -reach || activeMax[a] > reach)
      return fail(Code::Input,
                  "grid '{}': its active voxels span {} along {}, from {} to {}; the limit is {}", name,
                  extent, "XYZ"[a], activeMin[a], activeMax[a], limits.extent);
    bricks[a] = static_cast<int>((extent + 1 + kBrickSize - 1) / kBrickSize);
    lattice *= bricks[a];
  }
  if (lattice > double(limits.latticeBricks))
    return fail(Code::Input, "grid '{}': its bounds hold {:.3g} bricks; the limit is {}", name, lattice,
                limits.latticeBricks);
  return bricks;
}

Result<BuildResult> buildBricks(const VoxelSource& source, JobControl& control, double from,
                                const BuildLimits& limits) {
  const dmat4& m = source.worldFromIndex;
  const double det = glm::determinant(glm::dmat3(m));
  if (!std::isfinite(det) || det == 0 || !std::isfinite(glm::dot(m[3], m[3])))
    return fail(Code::Input, "grid '{}': its transform is singular", source.name);
  if (glm::any(glm::lessThan(source.activeMax, source.activeMin)))
    return BuildResult{emptyGrid(source.name, m), 0};

  auto grid = std::make_shared<BrickGrid>();
  grid->name = source.name;
  grid->worldFromIndex = m;
  grid->voxelSize = voxelEdge(m);
  PILEUS_TRY(const ivec3 bricks, latticeSize(source.name, source.activeMin, source.activeMax, limits));
  grid->origin = source.activeMin - 1;
  grid->indexBounds = {dvec3(source.activeMin) - 1.0, dvec3(source.activeMax) + 1.0};

  Build build{control, limits, {}, 0, from, from + (1 - from) * 0.85};
  const auto blockOrigin = [&](ivec3 b) { return grid->origin + b * kBrickSize - kApron; };
  const auto fillSource = [&](ivec3 b, float* out, Stats& stats) {
    const ivec3 lo = blockOrigin(b);
    const Fill answer = source.fill(lo, out);
    if (answer == Fill::Zero) return answer;
    if (answer == Fill::Constant) std::fill_n(out + 1, kStoredVoxels - 1, out[0]);
    clip(out, lo, source.activeMin, source.activeMax);
    stats.nonFinite += sanitize(out);
    if (!source.stats) addStats(stats, out);
    return Fill::Voxels;
  };
  const auto touchesSource = [&](ivec3 b) { return !source.touches || source.touches(blockOrigin(b)); };

  BuildResult result;
  grid->levels.push_back({bricks, {}});
  auto floats = std::make_unique<SparseFloats>((bricks + 1) / 2);
  auto stats = buildLevel(build, grid->levels[0], fillSource, touchesSource, *floats);
  if (!stats)
    return Error{stats.error().code, fmt::format("grid '{}': {}", source.name, stats.error().message)};
  result.nonFinite = stats->nonFinite;
  const ActiveStats active = source.stats       ? *source.stats
                             : stats->count > 0 ? ActiveStats{stats->count, stats->minimum, stats->maximum}
                                                : ActiveStats{};
  grid->activeVoxels = active.count;
  if (build.used == 0 && std::all_of(grid->levels[0].table.begin(), grid->levels[0].table.end(),
                                     [](const Brick& b) { return b.offset == 0; })) {
    grid->levels.clear();  // nothing but zeros
    grid->indexBounds = {};
    grid->content = contentKeyOf(*grid);
    result.grid = std::move(grid);
    return result;
  }
  grid->minimum = active.minimum;
  grid->maximum = active.maximum;

  build.from = build.to;
  build.to = 1;
  while (grid->levels.back().bricks != ivec3(1)) {
    Level level{floats->bricks, {}};
    auto next = std::make_unique<SparseFloats>((level.bricks + 1) / 2);
    const SparseFloats& current = *floats;
    const auto fillMip = [&](ivec3 b, float* out, Stats&) { return gather(current, b, out); };
    // A brick answers for its own voxels and the far apron; the near apron counts for the first bricks only,
    // where it is outside.
    const auto touchesMip = [&](ivec3 b) {
      for (int c = 0; c < 8; ++c)
        if (current.at(b + ivec3(c & 1, (c >> 1) & 1, c >> 2))) return true;
      return false;
    };
    auto done = buildLevel(build, level, fillMip, touchesMip, *next);
    if (!done)
      return Error{done.error().code, fmt::format("grid '{}': {}", source.name, done.error().message)};
    build.from = build.from + (1 - build.from) * 0.8;
    grid->levels.push_back(std::move(level));
    floats = std::move(next);
  }
  build.payload.resize(build.used);
  grid->payloadCount = static_cast<std::uint32_t>(build.used);
  grid->payload = build.payload.release();
  for (const Brick& b : grid->levels[0].table)
    grid->maximum = std::max(grid->maximum, b.maximum);  // zeros of inactive voxels
  grid->content = contentKeyOf(*grid);
  control.progress(1);
  result.grid = std::move(grid);
  return result;
}

}  // namespace pileus::volume
