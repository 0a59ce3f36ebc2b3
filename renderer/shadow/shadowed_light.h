#pragma once
// A light with its shadow, as links carry it and passes take it.
#include <memory>

#include "renderer/scene/light.h"

namespace pileus::shadow {

struct ShadowMap;  // shadow_map.h

struct ShadowedLight {
  scene::Light light;
  std::shared_ptr<const ShadowMap> shadow;  ///< null: none
};

}  // namespace pileus::shadow
