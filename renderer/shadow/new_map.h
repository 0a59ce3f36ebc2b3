#pragma once
// What is known of a light's shadow before it is made.
#include <memory>

#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

std::shared_ptr<ShadowMap> newMap(ShadowMap::Kind kind, const ShadowSpec& spec, const scene::Light& light,
                                  const volume::InstanceList& volumes, const scene::SolidList& solids,
                                  const LightFrustum& frustum = {});

}  // namespace pileus::shadow
