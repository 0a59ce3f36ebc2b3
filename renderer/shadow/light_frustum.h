#pragma once
// The volume of light rays a shadow map covers: (u, v) across the light, x in [0,1] along it.
#include "renderer/scene/light.h"
#include "renderer/volume/instance.h"

namespace pileus::shadow {

/// Parallel light: an oriented box.
struct LightFrustum {
  dmat4 worldFromLight{1.0};  ///< (u, v, x) in [0,1]^3 -> world; columns u and v point right and down the map, x away from the light
  double depth() const { return glm::length(dvec3(worldFromLight[2])); }          ///< metres from x = 0 to 1
  double width() const { return glm::length(dvec3(worldFromLight[0])); }          ///< metres along u
  double height() const { return glm::length(dvec3(worldFromLight[1])); }
  double texelSize(int resolution) const { return std::max(width(), height()) / resolution; }  ///< metres
};

/// The smallest frustum of a fixed rotation about the media of a sun, its origin snapped to texels so that a moving volume does not make
/// the map crawl. Empty media: a unit cube about the origin.
LightFrustum fitSun(const scene::Light& sun, const volume::InstanceList& media, int resolution);

}  // namespace pileus::shadow
