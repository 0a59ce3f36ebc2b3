#pragma once
// What a hot body sends out, as the eye weighs it.
#include "renderer/base/math.h"

namespace pileus::scene {

/// CIE 1931 XYZ of a black body's radiance [W/(m^2 sr)]: Planck's law under the multi-lobe fits of Wyman,
/// Sloan and Shirley 2013 (JCGT 2(2)), 360 to 830 nm. Meant for 500 to 40000 K.
dvec3 blackBodyXyz(double kelvin);

/// The same as linear ACEScg with 6500 K as its white, as temperatureColor() has it; its luminance is that of
/// `reference` kelvins 1. Not clamped to 0 .. 1, never negative.
dvec3 blackBodyColor(double kelvin, double reference);

}  // namespace pileus::scene
