#pragma once
// The volume of light rays a shadow map covers: (u, v) across the light, x in [0,1] along it.
#include <algorithm>
#include <optional>

#include "renderer/scene/light.h"
#include "renderer/volume/instance.h"

namespace pileus::shadow {

/// Sun: an oriented box. Spot: a pyramid about its cone. Point: six pyramids about the axes (cube faces),
/// each a texel wider than 90 degrees. Twins of mapCoordinates and mapRay in lib/light.glsl.
struct LightFrustum {
  scene::LightKind kind = scene::LightKind::Sun;
  /// Sun: (u, v, x) in [0,1]^3 -> world; columns u and v point right and down the map, x away from the light.
  /// Else rigid: light at the origin, z along the axis.
  dmat4 worldFromLight{1.0};
  double nearDistance = 0, farDistance = 1;  ///< Point, Spot: metres from the light at x = 0 and 1
  double tanHalf = 1;                        ///< Point, Spot: of a face's half angle (without the border)

  bool perspective() const { return kind != scene::LightKind::Sun; }
  int faces() const { return kind == scene::LightKind::Point ? 6 : 1; }
  double depth() const {
    return perspective() ? farDistance - nearDistance : glm::length(dvec3(worldFromLight[2]));
  }  ///< metres from x = 0 to 1
  double width() const {
    return perspective() ? 2 * tanHalf * farDistance : glm::length(dvec3(worldFromLight[0]));
  }  ///< metres along u (at the far end)
  double height() const { return perspective() ? width() : glm::length(dvec3(worldFromLight[1])); }
  double texelSize(int resolution) const {
    return std::max(width(), height()) / resolution;
  }  ///< metres (at the far end)
};

/// Where a world point lies: (u, v, x), each in [0,1] inside; and on which face. u = -1 where no face sees
/// it.
struct MapPoint {
  dvec3 at{0};
  int face = 0;
};
MapPoint mapCoordinates(const LightFrustum& frustum, const dvec3& world, int resolution);
/// World positions at x = 0 and x = 1 of the light ray through (u, v) of a face.
struct MapSegment {
  dvec3 from{0}, to{0};
};
MapSegment mapSegment(const LightFrustum& frustum, int face, dvec2 uv, int resolution);

/// Sun: the smallest frustum of a fixed rotation about the media, its origin snapped to texels so that a
/// moving volume does not make the map crawl; empty media: a unit cube about the origin. Point and spot: from
/// the nearest to the farthest point of the media's bounds; a spot's only of what lies in its map's pyramid,
/// the near end being no farther than that.
LightFrustum fitLight(const scene::Light& light, const volume::InstanceList& media, int resolution);

/// A voxel grid that a map's texels are too wide for: one is as wide as `texel`, and the grid no thicker than
/// `thickness` [m] where the light goes through its middle.
struct ThinMedium {
  double thickness = 0, texel = 0;
};
/// The one that suffers most, if any does. Exact shapes never do: a map's ends are straight between texels.
std::optional<ThinMedium> thinnestMedium(const scene::Light& light, const volume::InstanceList& media,
                                         const LightFrustum& frustum, int resolution);

}  // namespace pileus::shadow
