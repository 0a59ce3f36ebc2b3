#pragma once
// Light that has been scattered more than once, from a scene to what a picture reads: gathered on the GPU,
// solved for in a job, and kept for as long as what it was made of stays the same. GL thread.
#include <list>
#include <memory>
#include <optional>
#include <utility>

#include "renderer/view/sampled_lights.h"
#include "renderer/view/scatter_field.h"
#include "renderer/view/scatter_gather.h"

namespace pileus::view {

/// The last few solutions of whoever renders one picture after the other: cameras, samples, exposures and the
/// like leave them as they are.
class ScatterCache {
 public:
  std::shared_ptr<const ScatterField> find(const Key& key);
  void keep(const Key& key, std::shared_ptr<const ScatterField> field);
  int solved() const { return solved_; }  ///< how often something was kept

 private:
  static constexpr std::size_t kMostBytes = std::size_t(64) << 20;         ///< beyond that the last one alone
  std::list<std::pair<Key, std::shared_ptr<const ScatterField>>> fields_;  ///< the last one used first
  int solved_ = 0;
};

class ScatterSolve {
 public:
  /// `cache` may be null. `sampled`: the picture's lights, of which it makes the middles; outlives it.
  ScatterSolve(std::shared_ptr<const RenderScene> scene, std::shared_ptr<ScatterCache> cache,
               SampledLights& sampled);
  /// Works for about `ms` milliseconds, or looks whether the job is done (with infinitely many: waits for
  /// it); 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// Once step() said 1.
  const std::shared_ptr<const ScatterField>& field() const { return field_; }
  double takeGpuMs() { return std::exchange(gpuMs_, 0.0); }
  double ms() const { return ms_; }  ///< that step() took, without the lights and the job

 private:
  /// The lights, and the cells of all lattices: the fraction done.
  Result<double> gather(const shadow::Gpu& gpu, double ms);
  Result<void> finish(std::vector<transport::Solution> solutions);
  std::shared_ptr<const RenderScene> scene_;
  std::shared_ptr<ScatterCache> cache_;
  SampledLights& sampled_;
  std::optional<LightSet> lights_;
  Key key_;
  std::vector<transport::Lattice> lattices_;
  std::vector<transport::Cells> cells_;    ///< of those that are gathered
  std::unique_ptr<ScatterGather> gather_;  ///< of the next one
  bool emission_ = false;
  LooseJob<std::vector<transport::Solution>> job_;
  std::shared_ptr<const ScatterField> field_;
  double gpuMs_ = 0, ms_ = 0;
};

}  // namespace pileus::view
