#pragma once
// Light from everywhere: a map of radiance over all directions, latitude by longitude. Plain values; any
// thread.
//
// Column u and row v, measured at pixel edges, 0 .. 1 from the left and from the top, show
//   azimuth = (0.5 - u) 360 deg + rotation, from +Z towards +X as for suns;  elevation = 90 - 180 v deg.
// Radiance is constant within a texel: that is the function that is integrated, sampled and cut, exactly.
#include <memory>
#include <vector>

#include "renderer/base/math.h"

namespace pileus::scene {

struct EnvironmentMap {
  ivec2 size{0};
  std::vector<vec3> radiance;  ///< [W/(m^2 sr)], linear ACEScg, top row first; finite, none below 0

  const vec3& at(int x, int y) const {
    return radiance[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
  }
  vec3& at(int x, int y) { return radiance[std::size_t(y) * std::size_t(size.x) + std::size_t(x)]; }
  bool operator==(const EnvironmentMap&) const = default;
};

class EnvironmentStrata;  // environment_strata.h

/// A map as it lights and is seen. Maps are shared: turned or brighter it is the same ones.
struct Environment {
  std::shared_ptr<const EnvironmentMap> map;   ///< that lights: kLightMap at most
  std::shared_ptr<const EnvironmentMap> seen;  ///< kSeenMap at most
  /// Of the map that lights, for who takes a few suns for it; null: strataOf() makes them.
  std::shared_ptr<const EnvironmentStrata> strata = {};
  double rotation = 0;  ///< degrees
  vec3 scale{1.0f};     ///< of its radiance: exposure and tint
  bool visible = true;  ///< behind the media

  bool operator==(const Environment&) const = default;
};

inline constexpr ivec2 kLightMap{512, 256}, kSeenMap{2048, 1024};
/// Both maps of it, without strata.
Environment environmentOf(EnvironmentMap map);

/// Several as one: their sum as a map of no rotation; one alone is itself. Null for none.
std::shared_ptr<const Environment> joined(const std::vector<std::shared_ptr<const Environment>>& some);

/// Unit vector towards what (u, v) shows; `rotation` in degrees.
dvec3 environmentDirection(const dvec2& uv, double rotation = 0);
/// The inverse: u in [0, 1), v in [0, 1].
dvec2 environmentUv(const dvec3& direction, double rotation = 0);
/// From the frame of a map (rotation 0) to the world.
dvec3 turned(const dvec3& direction, double rotation);

/// Of every texel of a row [sr].
double texelSolidAngle(ivec2 size, int row);
/// Sine of the elevation of a row's upper edge; that of its lower one is the next row's.
double rowSine(int height, int row);

/// Of the texel in that direction.
vec3 environmentRadiance(const EnvironmentMap& map, const dvec3& direction, double rotation = 0);
/// Bilinear between the texels' middles: for looking at, not for integrals.
vec3 smoothRadiance(const EnvironmentMap& map, const dvec3& direction, double rotation = 0);

/// Integral of radiance over all directions [W/m^2].
dvec3 environmentFlux(const EnvironmentMap& map);
/// Irradiance of a surface with that normal, nothing between [W/m^2]. By texel: exact to the square of their
/// size.
dvec3 environmentIrradiance(const EnvironmentMap& map, const dvec3& normal);

/// What is sampled in proportion to: the mean of the channels, so that no saturated colour has a large
/// weight.
inline double environmentImportance(const vec3& radiance) {
  return (double(radiance.x) + double(radiance.y) + double(radiance.z)) / 3;
}

/// Means over the solid angle of larger or smaller texels; the flux of every channel stays. The map itself
/// where no side is longer than `largest`.
EnvironmentMap reduced(const EnvironmentMap& map, ivec2 largest);
/// Each texel cut into equal ones, where a side is shorter than `smallest`: the same function of direction.
EnvironmentMap refined(const EnvironmentMap& map, ivec2 smallest);

/// What a map held that is no radiance, in texels.
struct EnvironmentFaults {
  std::size_t notNumbers = 0, negative = 0, tooBright = 0;
  bool any() const { return notNumbers + negative + tooBright > 0; }
};
inline constexpr float kInfiniteRadiance = 65504;  ///< what infinities become: the largest half
inline constexpr float kLargestRadiance = 1e12f;   ///< finite values are cut here
enum class Negative { Cut, Keep };
/// NaNs and negative values become 0, infinities kInfiniteRadiance, channel by channel. Negative values are
/// kept where they may yet become a colour by a change of primaries.
EnvironmentFaults repair(EnvironmentMap& map, Negative negative = Negative::Cut);

}  // namespace pileus::scene
