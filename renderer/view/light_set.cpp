#include "renderer/view/light_set.h"

#include <algorithm>
#include <map>

#include "renderer/shaders/shared/bindings.h"

namespace pileus::view {
namespace {

static_assert(MAX_LIGHTS * sizeof(gpu::LightRecord) <= 16384, "what a uniform block is guaranteed");
static_assert(SUN_HEIGHTS == scene::kSunHeights && AIR_TOP == scene::kAirTop);

const scene::Light kNoLight{.towards = {0, 1, 0}, .emitted = vec3(0.0f)};

gpu::SolidRecord makeRecord(const scene::Solid& solid, const dvec3& origin) {
  const float shape = solid.shape == scene::SolidShape::Plane ? SOLID_PLANE : SOLID_BOX;
  dmat4 placed = solid.worldFromLocal;
  placed[3] -= dvec4(origin, 0);
  return {mat4(glm::inverse(placed)), mat4(placed), vec4(solid.albedo, shape)};
}

}  // namespace

LightSet::LightSet(std::vector<shadow::ShadowedLight> lights, const volume::InstanceList& volumes,
                   const scene::SolidList& solids, bool emission, Casters casters)
    : lights_(std::move(lights)),
      volumes_(emission ? residency::canonicalWithEmission(volumes) : residency::canonical(volumes)),
      drawnVolumes_(volumes_.size()),
      drawnSolids_(solids.size()),
      selected_(0, lights_.size()) {
  // Lights mostly share one list of solids, the drawn one: each different list is stored once.
  std::vector<std::pair<const scene::SolidList*, int>> lists;
  const auto rangeOf = [&](const scene::SolidList& list) {
    const auto known =
        std::find_if(lists.begin(), lists.end(), [&](const auto& l) { return *l.first == list; });
    if (known != lists.end()) return ivec2(known->second, int(list.size()));
    const int first = int(solids_.size());
    lists.push_back({&list, first});
    solids_.insert(solids_.end(), list.begin(), list.end());
    return ivec2(first, int(list.size()));
  };
  rangeOf(solids);
  std::vector<Key> keys;  // of volumes_
  for (const volume::Instance& i : volumes_) keys.push_back(volume::contentKey({i}));
  for (const shadow::ShadowedLight& l : lights_) {
    blockers_.push_back(l.shadow ? rangeOf(l.shadow->solids) : ivec2(0));
    const int first = int(marchItems_.size());
    if (l.shadow && (casters == Casters::All || l.shadow->kind == shadow::ShadowMap::Kind::RayMarch)) {
      for (const volume::Instance& i : residency::canonical(l.shadow->volumes)) {
        const Key key = volume::contentKey({i});
        const auto at = std::find(keys.begin(), keys.end(), key);
        marchItems_.push_back(int(at - keys.begin()));
        if (at != keys.end()) continue;
        volumes_.push_back(i);
        keys.push_back(key);
      }
    }
    marched_.push_back({first, int(marchItems_.size()) - first});
  }
  std::map<const scene::SunAir*, int> air;
  for (const shadow::ShadowedLight& l : lights_) {
    int& first = air[l.light.air.get()];
    if (l.light.air && first == 0) {
      first = 1 + int(airTexels_.size());
      for (const vec3& passes : l.light.air->passes) airTexels_.emplace_back(passes, 1.0f);
    }
    air_.push_back(first);
  }
  const volume::InstanceList drawn(volumes_.begin(), volumes_.begin() + std::ptrdiff_t(drawnVolumes_));
  drawnBounds_ = volume::worldBounds(drawn);
  std::vector<int> media;  // that cast shadows, if something does
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (!drawn[i].emission) media.push_back(int(i));
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const std::span<const int> cast = castersOf(i);
    std::vector<int> sorted(cast.begin(), cast.end());
    std::sort(sorted.begin(), sorted.end());
    const scene::Light& l = lights_[i].light;
    const bool all = sorted == media && blockers_[i] == ivec2(0, int(drawnSolids_));
    const bool inside = l.kind != scene::LightKind::Sun && !drawnBounds_.empty() &&
                        glm::all(glm::greaterThanEqual(l.position, drawnBounds_.min)) &&
                        glm::all(glm::lessThanEqual(l.position, drawnBounds_.max));
    flags_.push_back((all ? LIGHT_BEHIND_ALL : 0) | (inside ? LIGHT_INSIDE : 0));
  }
}

bool LightSet::anyDisc() const {
  return std::any_of(lights_.begin(), lights_.end(), [](const auto& l) {
    return l.light.kind == scene::LightKind::Sun && l.light.angle > 0;
  });
}

gl::Defines LightSet::defines() const {
  const auto [first, count] = selected_;
  const auto any = [first = first, count = count](const auto& list, const auto& is) {
    const auto begin = list.begin() + std::ptrdiff_t(first);
    return std::any_of(begin, begin + std::ptrdiff_t(count), is);
  };
  gl::Defines out = shadow::lookupDefines(selected());
  out.insert(out.end(), {{"LOCAL_LIGHTS",
                          any(lights_, [](const auto& l) { return l.light.kind != scene::LightKind::Sun; })},
                         {"BLOCKERS", any(blockers_, [](ivec2 range) { return range.y > 0; })},
                         {"AIR", any(air_, [](int texel) { return texel > 0; })},
                         {"MANY_LIGHTS", count > MAX_LIGHTS}});
  return out;
}

Result<void> LightSet::bind(const shadow::ShadowStore& store, residency::SceneTable& table,
                            const dvec3& origin) {
  std::vector<gpu::LightRecord>& records = made_;
  records.clear();
  const auto [first, count] = selected_;
  for (std::size_t i = first; i < first + count; ++i) {
    const shadow::ShadowMap* shadow = lights_[i].shadow.get();
    gpu::LightRecord& r = records.emplace_back(shadow::makeRecord(lights_[i].light, shadow, origin));
    if (shadow && shadow->kind == shadow::ShadowMap::Kind::RayMarch)
      r.items.y = marched_[i].x, r.items.z = marched_[i].y;
    r.solids.x = blockers_[i].x, r.solids.y = blockers_[i].y, r.solids.w = air_[i];
    r.solids.z |= flags_[i];
    if (air_[i] > 0) r.position.y = float(lights_[i].light.air->altitude + origin.y);
  }
  if (records.empty()) records.push_back(shadow::makeRecord(kNoLight, nullptr));
  PILEUS_CHECK(records_.reserve(MAX_LIGHTS * sizeof(gpu::LightRecord)));
  PILEUS_CHECK(records_.assign(std::span<const gpu::LightRecord>(records)));
  if (madeFor_ != origin) {
    madeSolids_.clear();
    for (const scene::Solid& s : solids_) madeSolids_.push_back(makeRecord(s, origin));
    madeFor_ = origin;
  }
  table.set(residency::SceneTable::Section::ShadowItems, std::span<const int>(marchItems_));
  table.set(residency::SceneTable::Section::Solids, std::span<const gpu::SolidRecord>(madeSolids_));
  table.set(residency::SceneTable::Section::Air, std::span<const vec4>(airTexels_));
  store.bind();
  if (count > MAX_LIGHTS)
    records_.bindStorage(BIND_LIGHTS);
  else
    records_.bindUniform(BIND_LIGHTS);
  return {};
}

}  // namespace pileus::view
