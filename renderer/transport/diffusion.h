#pragma once
// Light by diffusion: an elliptic equation, where sweeps take many to carry light from end to end.
#include <memory>
#include <span>

#include "renderer/transport/lattice.h"

namespace pileus::transport {

/// Of one channel, its radiance linear in the direction (P1). Faces of the lattice and of solids let out what
/// reaches them (Marshak); in what is void light diffuses over the length of the lattice.
class Diffusion {
 public:
  Diffusion(const Cells& cells, int channel);
  ~Diffusion();

  /// The moments that sources have, each by cell. Of a source w is all that a volume gives in all directions,
  /// xyz that times the direction it goes in [W/m^3]. By conjugate gradients, preconditioned by a V-cycle
  /// over cells joined by eights, until the rest is `enough` of what it was, or for `most` of them. Moments
  /// may be negative.
  void solve(std::span<const vec4> sources, double enough, int most, std::span<vec4> moments) const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace pileus::transport
