#pragma once
// What a volume's density means optically. sigma_t = density * extinction [1/m]; a transform never changes
// it.
#include "renderer/scene/phase.h"

namespace pileus::scene {

struct Medium {
  double extinction = 1;  ///< 1/m per unit of density
  vec3 albedo{1.0f};      ///< sigma_s / sigma_t, linear in the working space
  Phase phase;            ///< even, if nothing else is said
  /// Tint of sigma_t, channel by channel; not negative. What knows no colours of extinction takes their mean.
  vec3 extinctionColor{1.0f};

  /// extinctionColor with the mean 1.
  vec3 tint() const {
    const double mean = meanExtinction();
    return mean > 0 ? extinctionColor * float(extinction / mean) : vec3(1);
  }
  /// Mean of the channels [1/m per unit of density].
  double meanExtinction() const {
    return extinction * double(extinctionColor.x + extinctionColor.y + extinctionColor.z) / 3;
  }
  /// Of the channel that has most.
  double largestExtinction() const {
    return extinction * double(glm::max(extinctionColor.x, glm::max(extinctionColor.y, extinctionColor.z)));
  }
  bool operator==(const Medium&) const = default;
};

}  // namespace pileus::scene
