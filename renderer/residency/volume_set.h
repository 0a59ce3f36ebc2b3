#pragma once
// The volume records of one pass.
#include "renderer/gl/shader_library.h"
#include "renderer/residency/brick_pool.h"
#include "renderer/residency/scene_table.h"
#include "renderer/volume/instance.h"

namespace pileus::residency {

/// The media among them, sorted by content, so that the order of links never changes a bit of a result;
/// instances that cannot be seen (no voxels, zero extinction or density, no extent) and those that only emit
/// are left out: every map, march and measurement begins with this.
volume::InstanceList canonical(const volume::InstanceList& instances);
/// The same with those that emit: what a camera sees.
volume::InstanceList canonicalWithEmission(const volume::InstanceList& instances);

class VolumeSet {
 public:
  /// Makes the grids resident within `ms`; once fraction is 1 there are records in the order given and bind()
  /// may be called. Shaders count positions from `origin` (world, metres): far from the world's own they have
  /// float precision only next to theirs. `peaks`: with tables of what is scattered within peaks of phase
  /// functions (lib/peak.glsl).
  Result<Residency> prepare(BrickPool& pool, const volume::InstanceList& instances, double ms,
                            const dvec3& origin = dvec3(0), bool peaks = false);
  /// Records into the table (bound by the caller), bricks to their binding points; atlas uniforms into the
  /// program.
  void bind(const BrickPool& pool, SceneTable& table, gl::Program& program) const;
  const volume::InstanceList& instances() const { return instances_; }
  /// Of the last prepare().
  const dvec3& origin() const { return origin_; }
  /// Variant constant SHAPES of lib/volume.glsl.
  int shapes() const { return shapes_; }
  /// Variant constant DENSE of lib/stretch.glsl: has any grid voxels through which next to no light comes?
  bool dense() const { return dense_; }
  /// Variant constant PHASE_LOBES of lib/volume.glsl: does any medium scatter by more than one lobe of Henyey
  /// and Greenstein?
  bool phaseLobes() const { return lobes_; }

 private:
  volume::InstanceList instances_;
  Key content_;
  dvec3 origin_{0};
  int shapes_ = 0;
  bool dense_ = false, lobes_ = false, peaks_ = false;
  std::uint64_t generation_ = ~std::uint64_t(0);
  std::vector<vec4> texels_;  ///< of the table
};

}  // namespace pileus::residency
