#pragma once
// What a picture shows and how it is made. Plain values: whoever holds one can render the same picture again,
// by other means.
#include <algorithm>
#include <array>
#include <optional>

#include "renderer/base/enum_info.h"
#include "renderer/scene/camera.h"
#include "renderer/scene/solid.h"
#include "renderer/shadow/shadowed_light.h"
#include "renderer/view/picture_layer.h"
#include "renderer/volume/instance.h"

namespace pileus::view {

/// What of light that has been scattered more than once is in a picture.
enum class Scattering {
  Single,   ///< nothing
  Octaves,  ///< something like it: sums of single scattering with less and less light, depth and contrast
  Grid,     ///< all of it, solved for on a lattice
};

constexpr auto enumInfo(Scattering*) {
  using E = Scattering;
  return std::array{
      EnumItem<E>{E::Single, "single", "Single", "Light that was scattered once."},
      EnumItem<E>{
          E::Octaves, "octaves", "Octaves (a look)",
          "Sums of single scattering with less and less light, depth and contrast: cheap, and not what "
          "light does."},
      EnumItem<E>{E::Grid, "grid", "Grid", "All of it, solved for on a lattice around the volumes."}};
}

struct ScatterOptions {
  Scattering kind = Scattering::Single;
  int cells = 64;          ///< Grid: at most so many along the longest edge of the media
  double residual = 1e-4;  ///< Grid: transport::SolveOptions
  bool operator==(const ScatterOptions&) const = default;
};

struct RenderOptions {
  ivec2 size{1280, 720};
  int samples = 16;
  double stepScale = 1;  ///< of the finest detail or pixel footprint
  scene::Camera camera;
  PictureLayer layer;
  ScatterOptions scatter;
  PictureRegion region;  ///< texels outside keep what the picture began with
};

struct RenderScene {
  RenderOptions options;
  volume::InstanceList volumes;               ///< drawn; those that cast shadows are each shadow's own
  std::vector<shadow::ShadowedLight> lights;  ///< a light is blocked by the solids of its shadow
  scene::SolidList solids;                    ///< drawn
  /// Of a picture of paths: how often they scatter behind the first time, -1: without limit; null: a march.
  std::optional<int> bounces = {};
};

/// Does any of its volumes emit?
inline bool emits(const RenderScene& scene) {
  return std::any_of(scene.volumes.begin(), scene.volumes.end(),
                     [](const auto& i) { return volume::emits(i); });
}

/// Does extinction of any of them have a colour?
bool tinted(const volume::InstanceList& volumes);
/// Do media that are drawn or cast shadows differ in it? Then each channel needs shadows of its own.
bool tintedApart(const RenderScene& scene);
/// Optical depths of a channel, scaled or not (scene::scaledPhase), are so many times those that lights'
/// shadows know (those of the channel where it has its own). What is scaled differs from medium to medium:
/// the mean over all that is drawn.
vec3 lightDepths(const RenderScene& scene, bool scaled);

/// The lights that its layer is made of.
std::vector<shadow::ShadowedLight> layerLights(const RenderScene& scene);
/// What cameras see in its layer behind all else: those of its environments that are visible. Null: nothing.
std::shared_ptr<const scene::Environment> backdropOf(const RenderScene& scene);
/// The environments that light its layer, as one. Null: none.
std::shared_ptr<const scene::Environment> layerEnvironment(const RenderScene& scene);

}  // namespace pileus::view
