#pragma once
// What the air of the Earth does to light at each height and wavelength, and the sun above it: numbers of the
// literature (docs/physics.md says which). Plain values; any thread.
#include "renderer/base/math.h"
#include "renderer/scene/phase.h"

namespace pileus::scene {

inline constexpr double kEarthRadius = 6371e3, kAirTop = 100e3;  ///< metres; nothing above
inline constexpr double kSunDiameter = 0.533;                    ///< degrees

/// Amounts, 1 for a clear day in the middle latitudes.
struct Air {
  double air = 1;      ///< molecules
  double aerosol = 1;  ///< dust and droplets; about 1 km deep
  double ozone = 1;    ///< of 300 Dobson units
  double groundAlbedo = 0.3;

  bool operator==(const Air&) const = default;
};

/// How much there is at a height [m above the sea], as shares of the amount at sea level; ozone's of its
/// most.
struct Densities {
  double molecules = 0, aerosol = 0, ozone = 0;
};
Densities densities(double height);
/// Columns of these above the sea [m].
inline constexpr double kMolecularDepth = 8000, kAerosolDepth = 1200, kOzoneDepth = 15000;

/// Coefficients [1/m] where the densities are 1; absorption of aerosols is extinction less scattering.
struct Coefficients {
  double molecules = 0;  ///< scattering; they absorb nothing
  double aerosolScattering = 0, aerosolExtinction = 0;
  double ozone = 0;  ///< absorption
};
Coefficients coefficients(const Air& air, double nm);

Phase molecularPhase();
Phase aerosolPhase();

/// Irradiance of the sun above the air [W/(m^2 nm)], 360 to 830 nm, at the Earth's mean distance.
double solarIrradiance(double nm);

/// Sunlight above the air as linear ACEScg with 6500 K as its white, of luminance 1.
dvec3 sunColor();
/// Spectral values relative to the sun's, as colour: XYZ times this is ACEScg in which sunColor() is that of
/// 1 at every wavelength.
dvec3 colorOfSunlit(const dvec3& xyz);

/// Cosine of the angle from the zenith under which the horizon lies.
double horizonCosine(double height);
/// Part of the sun's disc above the horizon, the middle of it at that cosine from the zenith.
double visibleDisc(double height, double cosine);

}  // namespace pileus::scene
