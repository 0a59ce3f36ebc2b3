#pragma once
// Bright discs of an environment, taken out of its map: a sun of 0.5 degrees that holds half of the light
// wants a map of its own for its shadow, and is found by no coarse sampling.
#include "renderer/scene/environment.h"
#include "renderer/scene/light.h"

namespace pileus::scene {

inline constexpr int kMostSuns = 4;

/// Lights of kind Sun in the frame of the map, brightest disc first: irradiance at normal incidence in the
/// disc's own colour, its middle, its diameter (from the second moment; that of a texel at least). What
/// becomes a sun is taken from the map: the flux of both together stays what it was, channel by channel.
///
/// A disc is what is brighter than 1/16 of the brightest spot, hangs together and lies within 5 degrees of
/// it. The light there above the median of the ring around it becomes a sun where that is more than a fifth
/// of what remains.
std::vector<Light> extractSuns(EnvironmentMap& map, int most = kMostSuns);

}  // namespace pileus::scene
