#pragma once
// The lights of one pass and all that lib/light_transmittance.glsl reads for them: their records, the volumes
// their shadows march through and the solids that block them. GL thread.
#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "renderer/gl/buffer.h"
#include "renderer/gl/shader_library.h"
#include "renderer/residency/volume_set.h"
#include "renderer/scene/solid.h"
#include "renderer/shaders/shared/records.h"
#include "renderer/shadow/shadow_map.h"

namespace pileus::view {

class LightSet {
 public:
  /// Whose volumes the set holds, besides those of the pass.
  enum class Casters {
    Marched,  ///< of shadows that are marched
    All       ///< of all shadows, whatever map they have
  };
  /// `volumes` and `solids` are what the pass itself looks at; `emission`: also at what only emits.
  LightSet(std::vector<shadow::ShadowedLight> lights, const volume::InstanceList& volumes,
           const scene::SolidList& solids, bool emission = false, Casters casters = Casters::Marched);

  const std::vector<shadow::ShadowedLight>& lights() const { return lights_; }
  /// What a residency::VolumeSet has to hold: the pass's own volumes in canonical order, then those only
  /// shadows march through.
  const volume::InstanceList& volumes() const { return volumes_; }
  std::size_t drawnVolumes() const { return drawnVolumes_; }
  /// Indices in volumes() of those that cast shadows of a light, as far as the set holds them.
  std::span<const int> castersOf(std::size_t light) const {
    return std::span(marchItems_).subspan(std::size_t(marched_[light].x), std::size_t(marched_[light].y));
  }
  /// World box around those of the pass.
  const Box3& drawnBounds() const { return drawnBounds_; }
  /// Is there a point or spot in it?
  bool anyInside() const { return anyOf(LIGHT_INSIDE); }
  /// Is there a sun with a disc?
  bool anyDisc() const;
  /// The pass's own solids are the first of the solid records.
  std::size_t drawnSolids() const { return drawnSolids_; }
  /// Those that defines() and bind() are about, for who takes them in parts: all of them at first. A pass
  /// that keeps something of each in registers takes MAX_LIGHTS at most.
  void select(std::size_t first, std::size_t count) { selected_ = {first, count}; }
  std::span<const shadow::ShadowedLight> selected() const {
    return std::span(lights_).subspan(selected_.first, selected_.second);
  }
  /// Variant constants of lib/light_transmittance.glsl, those of the map lookup included.
  gl::Defines defines() const;
  /// Records (made anew: maps may have moved) and the maps themselves to their binding points, lists into the
  /// table, which is the caller's to bind. At least one light is bound, a black one if need be. Places are
  /// relative to `origin`, as the volumes'.
  Result<void> bind(const shadow::ShadowStore& store, residency::SceneTable& table,
                    const dvec3& origin = dvec3(0));

 private:
  bool anyOf(int flag) const {
    return std::any_of(flags_.begin(), flags_.end(), [&](int f) { return (f & flag) != 0; });
  }
  std::vector<shadow::ShadowedLight> lights_;
  volume::InstanceList volumes_;
  std::size_t drawnVolumes_, drawnSolids_;
  std::vector<int> marchItems_;
  scene::SolidList solids_;
  std::vector<ivec2> marched_, blockers_;  ///< per light: first and count in marchItems_ and in solids_
  std::vector<int> air_;                   ///< per light: 1 + its first texel in airTexels_, or 0
  std::vector<vec4> airTexels_;
  std::pair<std::size_t, std::size_t> selected_;
  std::vector<int> flags_;  ///< per light: LIGHT_INSIDE, LIGHT_BEHIND_ALL
  Box3 drawnBounds_;
  std::vector<gpu::LightRecord> made_;  ///< by the last bind(); kept for its storage
  std::vector<gpu::SolidRecord> madeSolids_;
  std::optional<dvec3> madeFor_;  ///< the origin of those
  gl::Buffer records_{"light records"};
};

}  // namespace pileus::view
