#pragma once
// What the cells of a lattice hold of the media, and what of the lights is scattered in them for the first
// time, each light through its own shadow. GL thread.
#include <memory>
#include <optional>

#include "renderer/residency/region_run.h"
#include "renderer/shadow/gpu.h"
#include "renderer/transport/lattice.h"
#include "renderer/view/light_set.h"
#include "renderer/view/render_scene.h"
#include "renderer/view/sampled_lights.h"

namespace pileus::view {

/// The lattices for what is drawn: cells over which light hardly turns, (1 - g) sigma_t h <= 1/8, as far as
/// `scatter.cells` allow. The first one lies around all; where that is too coarse finer ones lie within it,
/// around what is dense and much smaller, apart from each other. None where nothing scatters.
std::vector<transport::Lattice> scatterLattices(const volume::InstanceList& volumes,
                                                const ScatterOptions& scatter);

/// Optical depths of light, scaled, are so many times those that shadows know, which do not tell one medium
/// from another: the mean over all that is drawn, exact where phase functions and albedos are the same.
vec3 scaledLight(const volume::InstanceList& volumes);

class ScatterGather {
 public:
  /// Of the layer's lights, of environments the middles; `emission`: what emits counts; `kept` as
  /// SampledLights has it.
  ScatterGather(std::shared_ptr<const RenderScene> scene, const transport::Lattice& lattice, bool emission,
                std::shared_ptr<KeptSuns> kept);
  /// Works for about `ms` milliseconds (at least one region or one step of a shadow map); the fraction done,
  /// 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// Once step() said 1.
  transport::Cells cells() const;
  double takeGpuMs() { return run_.takeGpuMs() + sampled_.takeGpuMs(); }

 private:
  Result<void> start(const shadow::Gpu& gpu);
  Result<bool> dispatch(const shadow::Gpu& gpu);
  std::shared_ptr<const RenderScene> scene_;
  transport::Lattice lattice_;
  bool emission_;
  SampledLights sampled_;
  std::optional<LightSet> lights_;  ///< none: still to be made
  vec3 lightScale_;
  residency::RegionRun run_;
  residency::MarchBudget budget_;
  gl::Buffer cells_{"cells of scattered light"};
  int sample_ = -1;  ///< -1: not begun
};

}  // namespace pileus::view
