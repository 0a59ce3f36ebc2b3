#pragma once
// Where the heaps of a cumulus field stand at a moment, and the towers and anvils they are made of. No
// voxels.
#include <vector>

#include "renderer/volume/cloud/procedural.h"

namespace pileus::volume {

/// A sphere swept along a line, thicker at its foot. Metres from the box's lowest corner.
struct Tower {
  vec3 from, to;
  float foot, head;  ///< radii at the ends
  float age;         ///< 0 crisp .. 1 dissolving
  float cloud;       ///< radius of the cloud it belongs to
};

/// A disc of ice that spreads from the top of a cloud, drawn out downwind.
struct Anvil {
  vec3 center;
  float radius, thickness;
  float neck;  ///< radius of the column that feeds it
};

/// A cloud: towers[begin, end), all inside `bound` around `center` seen from above.
struct Heap {
  vec2 center;
  float bound;
  std::size_t begin, end;
};

/// What all sizes of a field follow from.
struct CumulusScale {
  float base;    ///< height of the condensation level
  float radius;  ///< of the largest cloud
  float height;  ///< of its towers, above the base
  float bubble;  ///< diameter of the largest cauliflower heads
};

struct CumulusTowers {
  CumulusScale scale{};
  std::vector<Tower> towers;
  std::vector<Heap> heaps;
  std::vector<Anvil> anvils;
};

/// How far a heap and its anvil reach from the middle, in radii of the heap.
float heapReach(const CloudParams& params);

CumulusScale cumulusScale(const CloudParams& params);

/// Clouds are set one after another until the wanted part of the ground is covered: raising the coverage adds
/// clouds and moves none. The wind carries them; near a wall of the box they are smaller, and what leaves by
/// one comes back by the other. Stops early, with what stands so far, when cancelled.
CumulusTowers cumulusTowers(const CloudParams& params, JobControl& control);

}  // namespace pileus::volume
