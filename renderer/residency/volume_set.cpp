#include "renderer/residency/volume_set.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>

#include "renderer/scene/peak.h"
#include "renderer/shaders/shared/records.h"
#include "renderer/shaders/shared/scatter.h"

namespace pileus::residency {
namespace {

static_assert(sizeof(gpu::VolumeRecord) == VOLUME_ROWS * sizeof(vec4));
static_assert(PEAK_DEPTH == scene::kPeakDepth);
static_assert(REMAP_ENTRIES == volume::kRemapEntries);

/// The section's texels: records, then each table and the levels of each grid once.
class Texels {
 public:
  explicit Texels(std::size_t records) : texels_(records * VOLUME_ROWS) {}
  void put(std::size_t index, const gpu::VolumeRecord& record) {
    std::memcpy(texels_.data() + index * VOLUME_ROWS, &record, sizeof record);
  }
  /// The first texel of what is there once by that key; made by `rows()` where it is not there yet.
  template <class Rows>
  std::size_t addMade(const Key& content, const Rows& rows) {
    const auto [it, isNew] = firsts_.emplace(content, texels_.size());
    if (isNew) {
      const auto& made = rows();
      static_assert(sizeof(made[0]) == sizeof(vec4));
      texels_.resize(texels_.size() + made.size());
      if (!made.empty()) std::memcpy(&texels_[it->second], made.data(), made.size() * sizeof(vec4));
    }
    return it->second;
  }
  template <class T>
  std::size_t add(const Key& content, std::span<const T> rows) {
    return addMade(content, [&] { return rows; });
  }
  std::vector<vec4> all() { return std::move(texels_); }

 private:
  std::vector<vec4> texels_;
  std::map<Key, std::size_t> firsts_;
};

/// The table that its voxels go through: of what emits, that of the emission.
const volume::DensityRemap* tableOf(const volume::Instance& i) {
  return i.shape != volume::Shape::Grid ? nullptr : i.emission ? i.emission.get() : i.remap.get();
}

vec4 remapRow(const volume::Instance& i, Texels& texels) {
  const volume::DensityRemap* table = tableOf(i);
  if (!table) return vec4(-1, 0, 0, 0);
  const double perDensity = (REMAP_ENTRIES - 1) / (table->highest - table->lowest);
  const double most = std::numeric_limits<float>::max();
  return vec4(float(texels.add(table->content, std::span<const vec4>(table->entries))), float(perDensity),
              float(-table->lowest * perDensity), float(std::clamp(table->emptyUpTo, -most, most)));
}

/// The first texel of its table.
std::size_t peakRows(const scene::Phase& phase, Texels& texels) {
  Hasher h;
  h.add("peaks").add(phase.first.g).add(phase.first.alpha).add(phase.second.g).add(phase.second.alpha);
  return texels.addMade(h.add(phase.blend).key(), [&] {
    const std::vector<float> table = scene::scatteredPeaks(phase, PEAK_ANGLES, PEAK_DEPTHS);
    std::vector<vec4> rows;
    for (std::size_t i = 0; i < table.size(); i += 4)
      rows.emplace_back(table[i], table[i + 1], table[i + 2], table[i + 3]);
    return rows;
  });
}

constexpr double kFar = 1e30;  ///< metres: no end

/// `lobes`: the variant reads two lobes of a phase function.
gpu::VolumeRecord record(const volume::Instance& i, const BrickPool& pool, const dvec3& origin, bool lobes,
                         Texels& texels) {
  gpu::VolumeRecord r{};
  dmat4 worldFromLocal = i.worldFromLocal;
  Box3 bounds = volume::localBounds(i);
  if (i.shape == volume::Shape::Grid) {
    // The GPU counts from the lattice's origin: small numbers keep float precision.
    const dvec3 first(i.grid->origin);
    worldFromLocal = glm::translate(worldFromLocal, first);
    bounds = {bounds.min - first, bounds.max - first};
    if (const ResidentGrid* place = pool.find(*i.grid))
      r.shape =
          ivec4(SHAPE_GRID, texels.add(i.grid->content, std::span<const gpu::LevelRecord>(place->levels)),
                place->levels.size(), place->finest);
  } else {
    r.shape = ivec4(i.shape == volume::Shape::Box ? SHAPE_BOX : SHAPE_BALL, 0, 0, 0);
  }
  worldFromLocal[3] -= dvec4(origin, 0);
  r.worldFromLocal = mat4(worldFromLocal);
  r.localFromWorld = mat4(glm::inverse(worldFromLocal));
  r.boundsMin = vec4(vec3(bounds.min), float(i.medium.meanExtinction()));
  r.boundsMax = vec4(vec3(bounds.max), float(i.density));
  const scene::Phase& phase = i.medium.phase;
  r.albedo = vec4(i.medium.albedo, float(lobes ? phase.blend : phase.first.g));
  r.phase = vec4(phase.first.g, phase.first.alpha, phase.second.g, phase.second.alpha);
  r.tint = vec4(i.medium.tint(), 0);
  if (i.emission) {
    r.boundsMin.w = -1, r.boundsMax.w = 1;
    r.albedo = vec4(i.shape == volume::Shape::Grid ? vec3(1) : vec3(i.emission->at(i.density)), 0);
  }
  const double coarse = i.shape == volume::Shape::Grid ? std::exp2(double(r.shape.w)) : 1.0;
  const double majorant = volume::majorant(i);
  const scene::ScaledPhase scaled = scene::scaledPhase(phase);
  r.detail = vec4(float(volume::detailSize(i) * coarse),
                  float(majorant > 1 / kFar ? std::min(1 / majorant, kFar) : kFar), float(scaled.forward),
                  float(scaled.cosine));
  return r;
}

volume::InstanceList sorted(const volume::InstanceList& instances, bool withEmission) {
  std::vector<std::pair<Key, volume::Instance>> keyed;
  for (const volume::Instance& i : instances) {
    const bool seen = volume::majorant(i) > 0 || (withEmission && volume::emits(i));
    if (volume::localBounds(i).empty() || !seen ||
        std::abs(glm::determinant(glm::dmat3(i.worldFromLocal))) < 1e-300)
      continue;
    keyed.emplace_back(volume::contentKey({i}), i);
  }
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  volume::InstanceList out;
  for (auto& [key, i] : keyed) out.push_back(std::move(i));
  return out;
}

}  // namespace

volume::InstanceList canonical(const volume::InstanceList& instances) { return sorted(instances, false); }

volume::InstanceList canonicalWithEmission(const volume::InstanceList& instances) {
  return sorted(instances, true);
}

Result<Residency> VolumeSet::prepare(BrickPool& pool, const volume::InstanceList& instances, double ms,
                                     const dvec3& origin, bool peaks) {
  const Key content = volume::contentKey(instances);
  if (content != content_ || origin != origin_ || peaks != peaks_ || generation_ == ~std::uint64_t(0)) {
    instances_ = instances;
    content_ = content;
    origin_ = origin;
    peaks_ = peaks;
    shapes_ = 0;
    dense_ = lobes_ = false;
    constexpr double kDenseVoxel = 4;  // optical depth
    for (const volume::Instance& i : instances_)
      dense_ |= i.shape == volume::Shape::Grid && volume::majorant(i) * volume::detailSize(i) > kDenseVoxel;
    for (const volume::Instance& i : instances_) lobes_ |= !i.emission && !i.medium.phase.simple();
    for (const volume::Instance& i : instances_)
      shapes_ |=
          (i.shape == volume::Shape::Grid ? SHAPES_GRID : SHAPES_EXACT) | (tableOf(i) ? SHAPES_REMAPPED : 0);
    generation_ = ~std::uint64_t(0) - 1;
  }
  std::vector<volume::GridPtr> grids;
  for (const volume::Instance& i : instances_)
    if (i.grid) grids.push_back(i.grid);
  PILEUS_TRY(const Residency residency, pool.ensure(grids, ms));
  if (residency.fraction >= 1 && generation_ != pool.generation()) {
    Texels texels(instances_.size());
    for (std::size_t i = 0; i < instances_.size(); ++i) {
      gpu::VolumeRecord r = record(instances_[i], pool, origin_, lobes_, texels);
      r.remap = remapRow(instances_[i], texels);
      if (peaks_ && !instances_[i].emission) r.tint.w = float(peakRows(instances_[i].medium.phase, texels));
      texels.put(i, r);
    }
    texels_ = texels.all();
    generation_ = pool.generation();
  }
  return residency;
}

void VolumeSet::bind(const BrickPool& pool, SceneTable& table, gl::Program& program) const {
  table.set(SceneTable::Section::Volumes, std::span(texels_));
  pool.bind();
  program.set("atlasTexel", 1.0f / vec3(pool.atlasSize()));
}

}  // namespace pileus::residency
