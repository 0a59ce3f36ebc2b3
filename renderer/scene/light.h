#pragma once
// Lights. Colours are linear in the working space.
#include "renderer/base/math.h"

namespace pileus::scene {

enum class LightKind { Sun };

struct Light {
  LightKind kind = LightKind::Sun;
  dvec3 towards{0, 1, 0};   ///< Sun: unit vector towards the light
  vec3 emitted{10.0f};      ///< Sun: irradiance at normal incidence [W/m^2] x colour
  double angle = 0;         ///< Sun: diameter of the disc, degrees

  bool operator==(const Light&) const = default;
};

/// Azimuth from +Z towards +X, elevation above the horizon; degrees. Unit vector towards the sun.
dvec3 sunDirection(double azimuth, double elevation);

/// Linear ACEScg colour of a black body relative to 6500 K (which gives 1 1 1), normalised to luminance 1.
/// Planckian locus by Kim et al. 2002 (US patent 7024034, cubic spline), 1667-25000 K, clamped.
vec3 temperatureColor(double kelvin);

}  // namespace pileus::scene
