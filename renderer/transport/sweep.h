#pragma once
// One sweep of discrete ordinates: radiance in all directions by given sources, cell after cell downwind.
#include <array>
#include <cstdint>
#include <memory>

#include "renderer/transport/lattice.h"

namespace pileus::transport {

/// Finite volumes: what flows into a cell, is emitted and scattered in it is what flows out and is taken away
/// there, for each direction, to rounding. Between diamond and upwind differences, by each cell's optical
/// depth. Linear in the sources; a cell may get a little less than nothing next to what is much brighter.
class Sweep {
 public:
  /// Of the first `channels` ones.
  Sweep(const Cells& cells, int channels);
  ~Sweep();

  /// Source of a channel's scattered light in a cell: w over all directions is the same, xyz d in direction d
  /// comes on top [W/(m^3 sr)]. As many as there are moments, in the same order.
  std::vector<vec4>& sources() { return sources_; }
  /// Radiance that faces of solid cells send into every direction [W/(m^2 sr)]; of slot(cell) + face.
  std::vector<vec3>& sent() { return sent_; }
  std::size_t slot(std::size_t cell) const { return slots_[cell]; }

  /// Radiance that comes in through a face of the lattice, linear in its direction, by moments as sources
  /// have them: of channel c in [c * cells of the face + cell]. Faces -x +x -y +y -z +z; their cells x before
  /// y before z. Empty: nothing.
  std::vector<vec4>& incoming(int face) { return incoming_[std::size_t(face)]; }

  /// What the sources send through the lattice.
  void run(Moments& moments);
  /// Of the last run: what left the lattice, per channel [W].
  dvec3 leaked() const { return leaked_; }
  /// What came in [W].
  dvec3 entered() const { return entered_; }
  /// Irradiance of those faces [W/m^2]; of others 0.
  const std::vector<vec3>& received() const { return received_; }
  /// By how much sweeps spread light more than they should in cells of that optical depth: a coefficient of
  /// diffusion, in cells. Between upwind and downwind ends linear radiance is off by (1 - b)/(2 (1 + b)) of
  /// its slope.
  static double spread(double depth);
  /// Of a uniform radiance 1 leaving a face into its half space, by these directions; about pi.
  static double halfFlux();

 private:
  struct Work;
  const Cells& cells_;
  int channels_;
  std::vector<float> parts_;  ///< of cells, as pass() has them
  std::vector<vec4> sources_;
  std::vector<std::uint32_t> slots_;
  std::vector<vec3> sent_, received_;
  std::vector<std::unique_ptr<Work>> work_;  ///< one per group of octants that is swept beside the others
  dvec3 leaked_{0}, entered_{0};
  std::array<std::vector<vec4>, 6> incoming_;
};

}  // namespace pileus::transport
