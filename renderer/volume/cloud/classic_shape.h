#pragma once
// Where the clouds of a field stand and what they are made of: trees of balls, big ones for the body, smaller
// ones on their surface for the cauliflower. No voxels here.
#include <vector>

#include "renderer/volume/cloud/procedural.h"

namespace pileus::volume {

struct Ball {
  vec3 center;
  float radius;
  float blend;  ///< metres over which it joins its neighbours smoothly
};

/// A ball of the body with everything that grows on it: balls[begin, end), all inside `bound` around
/// `center`.
struct Clump {
  vec3 center;
  float bound;
  std::size_t begin, end;
};

struct CloudShape {
  float scale = 1;  ///< metres: the height of the box, to which all sizes relate
  float base = 0;   ///< height of the common condensation level above the box's bottom
  std::vector<Ball> balls;
  std::vector<Clump> clumps;
};

/// Positions are relative to the box's lowest corner, before shear. Clouds are set one after another, far
/// from those that stand, until the wanted fraction of the ground is covered: raising the coverage adds
/// clouds and moves none. Stops early, with what stands so far, when cancelled.
CloudShape shapeClouds(const CloudParams& params, JobControl& control);

}  // namespace pileus::volume
