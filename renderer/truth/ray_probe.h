#pragma once
// One light ray under the glass: the exact transmittance along it beside what the light's map makes of it,
// and what the map holds there. Plain values once made; GL thread to make.
#include <string>
#include <vector>

#include "renderer/shadow/gpu.h"
#include "renderer/shadow/map_taps.h"

namespace pileus::truth {

/// A part of the ray inside a volume; x as everywhere.
struct RayPart {
  double from = 0, to = 0;
  int volume = 0;    ///< index in the shadow's volumes
  std::string name;  ///< "Box 1", or a grid's name
};

struct RayProbe {
  std::shared_ptr<const shadow::ShadowMap> map;
  dvec3 point{0};
  dvec3 from{0}, to{0};     ///< world, at x = 0 and 1; x runs from the light's side to the far end of its map
  double nearDistance = 0;  ///< metres from a point or spot light to x = 0; 0 for a sun
  double length = 0;        ///< metres from x = 0 to 1
  double pointX = 0;        ///< x of the point
  bool blocked = false;     ///< a solid stands between the point and the light

  std::vector<double> x;       ///< rising from 0 to 1: evenly, and as many again where the media are
  std::vector<double> exact;   ///< transmittance by regular tracking
  std::vector<double> mapped;  ///< transmittance by the map, on the GPU; empty for RayMarch
  std::vector<double> u;       ///< the metric in front of x, by the heaviest tap; x where there is none
  std::vector<RayPart> parts;  ///< by volume, in the order of the shadow's volumes
  std::vector<dvec2> covered;  ///< disjoint x ranges that the volumes (of grids: their occupied bricks) cover
  shadow::MapTaps taps;

  double metres(double at) const { return nearDistance + at * length; }
  // Of dT = mapped - exact along the ray's length in media; 0 without a map.
  double meanError = 0, maxError = 0, maxErrorX = 0;
};

/// The ray through a world point, at 2 `count` positions; of an environment's main sun, whose map is made if
/// it is not `made`, the one of an earlier probe of this light. Error (Input): the light has no shadow, or
/// its map does not see the point.
Result<RayProbe> probeRay(const shadow::Gpu& gpu, const shadow::ShadowedLight& light, const dvec3& point,
                          int count = 256, std::shared_ptr<const shadow::ShadowMap> made = {});

/// T at every position of the probe with some coefficients muted (shadow::tapsTransmittance).
std::vector<double> mutedTransmittance(const RayProbe& probe, std::span<const char> muted);

/// Extinction as a function of u, relative to u: d tau / d u, at `count` positions of u in (0, 1).
struct ExtinctionOverU {
  std::vector<double> u, exact, mapped;  ///< mapped: of the series with muted coefficients; empty without one
};
ExtinctionOverU extinctionOverU(const RayProbe& probe, std::span<const char> muted = {}, int count = 256);

/// What is wrong with this ray, in words, worst first. "" never.
struct RayFlag {
  enum class Weight { Note, Warning } weight = Weight::Note;
  std::string text;
};
std::vector<RayFlag> rayFlags(const RayProbe& probe);

}  // namespace pileus::truth
