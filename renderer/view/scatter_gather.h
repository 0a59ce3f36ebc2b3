#pragma once
// What the cells of a lattice hold of the media, and what of the lights is scattered in them for the first
// time, each light through its own shadow. GL thread.
#include <vector>

#include "renderer/residency/region_run.h"
#include "renderer/shadow/gpu.h"
#include "renderer/transport/lattice.h"
#include "renderer/view/light_set.h"
#include "renderer/view/render_scene.h"

namespace pileus::view {

/// The lattices for what is drawn: cells over which light hardly turns, (1 - g) sigma_t h <= 1/8, as far as
/// `scatter.cells` allow. The first one lies around all media, and solids as far away as these are large;
/// where that is too coarse finer ones lie within it, around what is dense and much smaller, apart from each
/// other. None where nothing scatters.
std::vector<transport::Lattice> scatterLattices(const volume::InstanceList& volumes,
                                                const scene::SolidList& solids,
                                                const ScatterOptions& scatter);

class ScatterGather {
 public:
  /// `lights` outlive it and hold the scene's volumes, with `emission` also those that emit, which count
  /// then.
  ScatterGather(const transport::Lattice& lattice, const RenderScene& scene, LightSet& lights, bool emission);
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// Once step() said 1.
  transport::Cells cells() const;
  double takeGpuMs() { return run_.takeGpuMs(); }

 private:
  Result<void> start(const shadow::Gpu& gpu);
  Result<bool> dispatch(const shadow::Gpu& gpu);
  transport::Lattice lattice_;
  LightSet& lights_;
  scene::SolidList solids_;
  bool emission_;
  vec3 lightScale_;
  residency::RegionRun run_;
  residency::MarchBudget budget_;
  gl::Buffer cells_{"cells of scattered light"};
  int sample_ = -1;  ///< -1: not begun
};

}  // namespace pileus::view
