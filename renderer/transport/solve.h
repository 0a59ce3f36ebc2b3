#pragma once
// Light that has been scattered more than once, of given first collisions: discrete ordinates on the cells,
// begun from diffusion, accelerated by it and brought to rest by Anderson's mixing.
#include "renderer/base/jobs.h"
#include "renderer/transport/lattice.h"

namespace pileus::transport {

struct SolveOptions {
  /// Done once a sweep, and diffusion of what it changed, change scattering by no more than that part of it
  /// (sum over the cells, the channel where it is most): about as large as the error is then.
  double residual = 1e-4;
  int mostSweeps = 500;
  bool diffusionStart = true;  ///< else nothing
  bool accelerated = true;     ///< what a sweep changes is carried on by diffusion
  /// What lies around the lattice and sends its light in; null: nothing.
  const struct Solution* around = nullptr;
  /// What to begin with instead, of the same lattice; empty: nothing.
  Moments start;
};

struct Solution {
  Lattice lattice;
  Moments moments;
  vec3 color{0};     ///< of all light that was given, its greatest channel 1; ...
  bool one = false;  ///< ... and all light has it
  int sweeps = 0;
  double residual = 0;
  /// Per channel [W]: what first collisions, emission and solids gave and what came in, what media and solids
  /// kept, what left.
  dvec3 given{0}, kept{0}, left{0};
};

/// Of a channel at a place, between the cells; those of the nearest cells where it is outside.
vec4 momentsAt(const Solution& solution, const dvec3& place, int channel);

/// Error (Input) where the cells hold what is not finite, (Cancelled) where the job is cancelled.
Result<Solution> solve(const Cells& cells, const SolveOptions& options, JobControl& control);

}  // namespace pileus::transport
