#pragma once
// The eye's response to light of one wavelength.
#include "renderer/base/math.h"

namespace pileus::scene {

/// CIE 1931 matching functions by the multi-lobe fits of Wyman, Sloan and Shirley 2013 (JCGT 2(2)); `nm` is
/// the wavelength in nanometres, 360 to 830.
dvec3 colorMatching(double nm);

}  // namespace pileus::scene
