#pragma once
// What a picture shows and how it is made. Plain values: whoever holds one can render the same picture again,
// by other means.
#include <algorithm>

#include "renderer/scene/camera.h"
#include "renderer/scene/solid.h"
#include "renderer/shadow/shadowed_light.h"
#include "renderer/view/picture_layer.h"
#include "renderer/volume/instance.h"

namespace pileus::view {

struct RenderOptions {
  ivec2 size{1280, 720};
  int samples = 16;
  double stepScale = 1;  ///< of the finest detail or pixel footprint
  scene::Camera camera;
  PictureLayer layer;
  PictureRegion region;  ///< texels outside keep what the picture began with
};

struct RenderScene {
  RenderOptions options;
  volume::InstanceList volumes;               ///< drawn; those that cast shadows are each shadow's own
  std::vector<shadow::ShadowedLight> lights;  ///< a light is blocked by the solids of its shadow
  scene::SolidList solids;                    ///< drawn
};

/// Does any of its volumes emit?
inline bool emits(const RenderScene& scene) {
  return std::any_of(scene.volumes.begin(), scene.volumes.end(),
                     [](const auto& i) { return volume::emits(i); });
}

/// The lights that its layer is made of.
std::vector<shadow::ShadowedLight> layerLights(const RenderScene& scene);
/// What cameras see in its layer behind all else: of the environments that its lights stand for those that
/// are visible. Null: nothing.
std::shared_ptr<const scene::Environment> backdropOf(const RenderScene& scene);
/// Of those environments what lights its layer, for who leaves out the lights that stand for them. In a
/// light's layer it is the whole one where the light is the first that stands for it: so layers add up to the
/// beauty. Null: none.
std::shared_ptr<const scene::Environment> layerEnvironment(const RenderScene& scene);

}  // namespace pileus::view
