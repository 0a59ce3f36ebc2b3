#include "renderer/shadow/new_map.h"

#include <atomic>

namespace pileus::shadow {

std::shared_ptr<ShadowMap> newMap(ShadowMap::Kind kind, const ShadowSpec& spec, const scene::Light& light,
                                  const volume::InstanceList& volumes, const scene::SolidList& solids,
                                  const LightFrustum& frustum) {
  static std::atomic<std::uint64_t> made{0};
  auto map = std::make_shared<ShadowMap>();
  map->number = ++made;
  map->kind = kind;
  map->light = light;
  map->volumes = volumes;
  map->solids = solids;
  map->spec = spec;
  map->frustum = frustum;
  return map;
}

}  // namespace pileus::shadow
