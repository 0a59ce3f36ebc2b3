#pragma once
// GPU tests: one headless context per process, and maps built through the real passes.
#include <memory>
#include <vector>

#include "renderer/shadow/extinction_map.h"
#include "renderer/view/renderer.h"
#include "renderer/view/volume_render.h"
#include "tests/support/support.h"

namespace pileus::test {

/// The process's renderer; fails the test hard where there is no OpenGL 4.5.
view::Renderer& renderer();

/// Steps a pass until it is finished.
template <class Pass>
void runToEnd(Pass& pass) {
  double done = 0;
  while (done < 1) {
    const auto step = pass.step(renderer().gpu(), 1e12);
    if (!step) {
      ADD_FAILURE() << step.error().message;
      std::abort();
    }
    done = *step;
  }
}

volume::Instance box(const dvec3& center, const dvec3& size, double sigma, const dvec3& rotate = dvec3(0));
volume::Instance ball(const dvec3& center, double radius, double sigma);
scene::Light sunFrom(const dvec3& towards, float irradiance = 1);

/// Metric and extinction map of a sun, run to the end. `frustum` null: fitted.
std::shared_ptr<const shadow::ShadowMap> buildMap(const volume::InstanceList& volumes,
                                                  const scene::Light& light,
                                                  const shadow::MetricOptions& metric,
                                                  const shadow::ExtinctionOptions& extinction,
                                                  const shadow::LightFrustum* frustum = nullptr);
/// -log of lookupTransmittance on the GPU: at most 87.
std::vector<float> lookupTau(const shadow::ShadowMap& map, const scene::Light& light,
                             const std::vector<vec3>& positions);
/// All floats of a block's texel, layer by layer.
std::vector<float> texel(const shadow::ShadowBlock& block, ivec2 at);
/// A picture, run to the end; RGBA floats.
image::Image render(const view::RenderOptions& options, const volume::InstanceList& volumes,
                    const std::vector<shadow::ShadowedLight>& lights);
/// Of any pixel and channel of the beauties.
double largestDifference(const image::Image& a, const image::Image& b);

}  // namespace pileus::test
