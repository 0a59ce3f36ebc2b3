#pragma once
// What a shadow map errs by where a picture looks, and what it costs. GL thread.
#include "editor/cli/curve/scenes.h"
#include "renderer/image/image.h"
#include "renderer/truth/shadow_samples.h"
#include "renderer/view/render_scene.h"
#include "renderer/view/renderer.h"

namespace pileus::cli {

/// A scene and what its pictures would be without maps.
struct CurveTruth {
  view::RenderScene scene;    ///< its light's shadow is marched, steps of half a voxel
  image::Image picture;       ///< of that
  truth::ShadowSamples seen;  ///< where camera rays scatter, with the exact transmittance there
};
Result<CurveTruth> curveTruth(view::Renderer& renderer, const CurveScene& scene, ivec2 size);

/// Points as camera rays meet them: free flights from pixels at random, so a stretch counts by what it adds
/// to the picture, T_cam sigma_t. Fewer than `count` where hardly a ray meets anything.
truth::ShadowSamples seenSamples(const view::RenderScene& scene, int count, std::uint64_t seed);

struct CurveMeasure {
  double radiance = 0;   ///< sqrt(mean (a - b)^2) / mean b of the picture, where alpha > 0.01
  double scattered = 0;  ///< the same of T^0.28 at what is seen
  double bytesPerTexel = 0;
  std::size_t bytes = 0;
  double mapMs = 0, pictureMs = 0;  ///< processor time on a software device
};
/// With every shader compiled before.
Result<CurveMeasure> measureCurve(view::Renderer& renderer, const CurveTruth& truth,
                                  const shadow::ShadowSpec& spec);

/// Processor time of `pileus render` of this graph, in seconds: the median of three.
Result<double> renderSeconds(const nodes::Graph& graph, ivec2 size);

/// sqrt(mean (a - b)^2) / mean b over RGB of the pixels that b covers; 0 where it covers none.
double relativeRms(const image::Image& a, const image::Image& b);

/// Of the power of transmittance that scattering of high order looks up.
inline constexpr double kScatteredPower = 0.28;

}  // namespace pileus::cli
