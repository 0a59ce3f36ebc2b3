#pragma once
// Light in the air of the Earth: how much of the sun arrives, and what all the air sends on after any number
// of scatterings. Tables over height and the sun's cosine, so one serves every time of day and every height;
// made in a few hundredths of a second, on all cores. Immutable; any thread.
#include <array>
#include <vector>

#include "renderer/scene/air.h"

namespace pileus::scene {

/// Radiance and the like at kWaves wavelengths, in units of the sun's irradiance above the air there.
inline constexpr int kWaves = 8;
inline constexpr double kFirstWave = 400, kWaveStep = 40;  ///< nanometres
using Spectrum = std::array<float, kWaves>;

/// ACEScg, with 6500 K as white; 1 at all wavelengths is sunColor().
dvec3 spectrumColor(const Spectrum& s);

/// Where a height lies in the tables.
struct TableHeight {
  double height = 0, radius = 0;  ///< above the sea, from the Earth's middle [m]
  double horizon = 0;             ///< cosine
  double toHorizon = 0;           ///< metres
  double beamRow = 0, scatteredRow = 0;
};

class Atmosphere {
 public:
  explicit Atmosphere(const Air& air);

  const Air& air() const { return air_; }
  /// Of the sun's beam at a height, the cosine of its angle from the zenith given: transmittance times the
  /// part of its disc that the Earth leaves to see.
  Spectrum sunlight(double height, double cosine) const;
  /// A ray from a height [m above the sea] that makes an angle of cosine `view` with the zenith: all that
  /// does not depend on where the sun stands. First: only what is scattered once, and ground that the beam
  /// lights.
  enum class Orders { All, First };
  struct Path;
  Path path(double height, double view, Orders orders = Orders::All) const;
  /// Radiance along it, seen from where it begins. There the sun stands at cosine `sun` from the zenith and
  /// `fromSun` from the ray. Without the sun's own disc; with the ground.
  Spectrum radiance(const Path& path, double sun, double fromSun) const;

 private:
  struct Table {
    ivec2 size{0};
    std::vector<Spectrum> values;
  };
  struct Waves {  // of each wavelength
    Coefficients of[kWaves];
  };
  Table transmittances(bool reduced) const;
  Path path(double height, double view, int steps, Orders orders) const;
  void scatterAll();

  Air air_;
  Waves waves_;
  Phase molecular_, aerosol_;
  double aerosolMean_ = 0;
  Table sun_;        // transmittance from a height to space
  Table straight_;   // the same with what aerosols scatter straight on
  Table scattered_;  // mean radiance over all directions of what was scattered at least once
  Table ground_;     // radiance of the ground, what was scattered before
};

struct Atmosphere::Path {
  struct Step {
    TableHeight at;
    double x;                     ///< metres along the ray, from where it comes next to the Earth's middle
    Spectrum molecules, aerosol;  ///< what of the light that is scattered there arrives at the beginning
  };
  Orders orders = Orders::All;
  double radius = 0, begin = 0, end = 0;  ///< of the beginning; x of both ends
  bool ground = false;                    ///< it ends on it, of whose light `left` arrives
  Spectrum left{};
  std::vector<Step> steps;
};

}  // namespace pileus::scene
