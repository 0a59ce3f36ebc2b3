#pragma once
// Scattering, single or of all orders, and emission by any number of overlapping volumes, and opaque solids,
// under any number of shadowed lights, environments among them; progressive over regions and samples.
#include <optional>
#include <vector>

#include "renderer/view/camera_march.h"
#include "renderer/view/environment_table.h"
#include "renderer/view/picture.h"
#include "renderer/view/render_scene.h"
#include "renderer/view/sampled_lights.h"
#include "renderer/view/scatter_solve.h"

namespace pileus::view {

class VolumeRenderPass {
 public:
  explicit VolumeRenderPass(RenderScene scene);
  VolumeRenderPass(const VolumeRenderPass&) = delete;
  VolumeRenderPass& operator=(const VolumeRenderPass&) = delete;
  VolumeRenderPass(const RenderOptions& options, const volume::InstanceList& volumes,
                   std::vector<shadow::ShadowedLight> lights)
      : VolumeRenderPass(RenderScene{options, volumes, std::move(lights), {}}) {}
  /// Cuts every march into dispatches of so many loop iterations a pixel, needed or not (or
  /// residency::MarchBudget::kNever); before the first step.
  void pauseAfter(int iterations) { pauseAfter_ = iterations; }
  int dispatches() const { return march_.run.dispatches(); }
  /// Where solutions of scattered light are kept beyond the pass; before the first step.
  void keepScatterIn(std::shared_ptr<ScatterCache> cache) { scatterCache_ = std::move(cache); }
  /// Of the picture; null: there is none, or not yet.
  std::shared_ptr<const ScatterField> scatterField() const { return scatter_ ? scatter_->field() : nullptr; }
  /// What the texels of regions still to come hold, stretched to the picture; before the first step.
  void beginWith(std::shared_ptr<const Picture> seed) { seed_ = std::move(seed); }
  /// The suns of pictures of one sample, where there are environments; before the first step.
  void keepSuns(std::shared_ptr<KeptSuns> kept) { sampled_.keep(std::move(kept)); }
  /// Works for about `ms` milliseconds (at least one region, or one dispatch of it where it takes several, or
  /// one of a shadow map); the fraction done, 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  /// Null until the first region is drawn; the same object from then on, its texels improving until step()
  /// said 1.
  std::shared_ptr<const Picture> picture() const { return picture_; }
  /// To the finished picture.
  void addLayer(Picture::Named layer) { picture_->layers.push_back(std::move(layer)); }
  /// What the brick pool could hold, as of the last step.
  const residency::Residency& residency() const { return residency_; }
  double takeGpuMs() {
    return march_.run.takeGpuMs() + sampled_.takeGpuMs() + (scatter_ ? scatter_->takeGpuMs() : 0);
  }
  /// Of the shadow maps of this sample's suns, and of scattered light.
  std::size_t bytesBeside() const {
    return sampled_.bytes() + (scatter_ && scatter_->field() ? scatter_->field()->bytes() : 0);
  }
  /// What it is at before there is a picture: "Uploading bricks".
  std::string doing() const;

 private:
  /// The lights of the sample at hand: the fraction done.
  Result<double> light(const shadow::Gpu& gpu, double ms);
  /// Of its layer.
  Scattering scattering() const;
  /// Light that was scattered before, if the picture has it: the fraction of it that is solved.
  Result<double> solve(const shadow::Gpu& gpu, double ms);
  /// The part of the lights that one dispatch takes.
  void select(std::size_t part);
  std::size_t parts() const;
  double progress() const;
  Result<void> start(const shadow::Gpu& gpu);
  /// True when the region is drawn, false where it has to go on.
  Result<bool> dispatch(const shadow::Gpu& gpu);
  std::shared_ptr<const RenderScene> scene_;
  SampledLights sampled_;
  std::optional<LightSet> lights_;  ///< of this sample; none: still to be made
  double lit_ = 0;                  ///< the fraction of that
  std::size_t part_ = 0;            ///< of the lights, in the region at the cursor
  std::shared_ptr<Picture> picture_;
  std::shared_ptr<const Picture> seed_;
  CameraMarch march_;
  std::vector<residency::MarchBudget> budgets_;  ///< of each part of the lights
  residency::Residency residency_;
  int pauseAfter_ = 0;
  bool emission_ = false;              ///< counts, and there is some
  vec3 lightTint_{1}, lightScale_{1};  ///< lightDepths(), as it is and as it counts
  Backdrop backdrop_;
  std::shared_ptr<ScatterCache> scatterCache_;
  std::unique_ptr<ScatterSolve> scatter_;
  double solved_ = 0;
};

}  // namespace pileus::view
