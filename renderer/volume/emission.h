#pragma once
// What a volume emits for each of its densities, which are then a temperature or how much burns: a black
// body's light in a table of the same kind as remapped densities.
#include <functional>

#include "renderer/volume/remap.h"

namespace pileus::volume {

struct BlackBody {
  double coolest = 1000, hottest = 2200;  ///< K, where the curve is 0 and 1
  double strength = 1;                    ///< luminance gained per metre at the hottest [W/(m^3 sr)]
};

/// Entries: rgb radiance gained per metre, a its largest channel. `curve` makes 0 .. 1 of the part of the way
/// from lowest to highest; nothing is emitted where it is 0. lowest < highest.
RemapPtr makeEmission(double lowest, double highest, const std::function<double(double)>& curve,
                      const BlackBody& body);
/// Emission of densities that are remapped first; `remap` may be null.
RemapPtr emissionBehind(const RemapPtr& remap, const RemapPtr& emission);

}  // namespace pileus::volume
