#pragma once
// What a volume's density means optically. sigma_t = density * extinction [1/m]; a transform never changes
// it.
#include "renderer/scene/phase.h"

namespace pileus::scene {

struct Medium {
  double extinction = 1;  ///< 1/m per unit of density
  vec3 albedo{1.0f};      ///< sigma_s / sigma_t, linear in the working space
  Phase phase;            ///< even, if nothing else is said

  bool operator==(const Medium&) const = default;
};

}  // namespace pileus::scene
