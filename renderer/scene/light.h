#pragma once
// Lights. Colours are linear in the working space.
#include <memory>
#include <vector>

#include "renderer/scene/environment.h"
#include "renderer/scene/sun_air.h"

namespace pileus::scene {

enum class LightKind {
  Sun,
  Point,
  Spot,
  Environment  ///< light from everywhere: one light in every list, for passes a few suns (standIns())
};

struct Light {
  LightKind kind = LightKind::Sun;
  dvec3 towards{0, 1, 0};  ///< Sun: unit vector towards the light; Spot: the same seen from the middle of its
                           ///< cone (against its axis)
  vec3 emitted{10.0f};     ///< Sun: irradiance at normal incidence [W/m^2] x colour; Point, Spot: radiant
                           ///< intensity [W/sr] x colour
  double angle = 0;        ///< Sun: diameter of the disc, degrees; what a soft sun was split from
  dvec3 disc{0};           ///< Sun: the middle of that disc, unit vector; 0: it was not split
  dvec3 position{0};       ///< Point, Spot: metres
  double radius = 0;       ///< Point, Spot: metres; within it irradiance stays I / radius^2; 0: a point
  double cone = 60;        ///< Spot: full angle of the cone, degrees, below 180
  double softness = 0.2;   ///< Spot: part of the half angle over which the edge fades, 0..1
  std::shared_ptr<const Environment> environment = {};  ///< Environment: never null; else null
  double narrow = 1;  ///< Sun: mean cosine of the directions it stands for; phase functions are blurred by it
  /// Sun: what comes through the air above each height; null: no air.
  std::shared_ptr<const SunAir> air = {};

  bool operator==(const Light&) const = default;
};

/// What a point receives: E(p) = emitted x air x falloff; falloff is 1 for a sun, else
/// cone(p) / max(r^2, radius^2). Twin of lightAt in lib/light.glsl. Without shadow; not of an environment.
struct Incidence {
  dvec3 towards{0, 1, 0};  ///< unit vector from the point to the light
  double distance = 0;     ///< metres to the light; infinite for a sun
  double falloff = 1;      ///< 1 for a sun, else [1/m^2]
  vec3 air{1.0f};          ///< what a sun's air lets through

  vec3 irradiance(const Light& light) const { return light.emitted * air * float(falloff); }
};
Incidence incidence(const Light& light, const dvec3& point);

/// Light from everywhere as a light.
Light environmentLight(std::shared_ptr<const Environment> environment);
/// Those among the lights, in their order.
std::vector<std::shared_ptr<const Environment>> environmentsOf(const std::vector<Light>& lights);

/// `count` suns of equal share, spread evenly over the disc of a soft one (Vogel spiral); the light itself
/// where it has no extent.
std::vector<Light> splitDisc(const Light& sun, int count);

/// Azimuth from +Z towards +X, elevation above the horizon; degrees. Unit vector towards the sun.
dvec3 sunDirection(double azimuth, double elevation);

/// Linear ACEScg colour of a black body relative to 6500 K (which gives 1 1 1), normalised to luminance 1.
/// Planckian locus by Kim et al. 2002 (US patent 7024034, cubic spline), 1667-25000 K, clamped.
vec3 temperatureColor(double kelvin);

}  // namespace pileus::scene
