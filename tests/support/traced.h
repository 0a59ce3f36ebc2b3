#pragma once
// What the path tracer says of a scene: means with their standard errors, from the variance of samples.
#include <cmath>

#include "renderer/view/path_trace.h"
#include "tests/support/lit.h"

namespace pileus::test {

struct Traced {
  dvec3 mean{0}, error{0};  ///< of all pixels together, and its standard error
  double alpha = 0;
  view::PathStatistics statistics;
  image::Image picture, variance;

  double gray() const { return (mean.x + mean.y + mean.z) / 3; }
  double grayError() const { return error.x; }  ///< channels of a gray scene are one
};

inline Traced traced(const view::RenderScene& scene, const view::PathOptions& options = {}) {
  view::PathTracePass pass(scene, options);
  runToEnd(pass);
  Traced out;
  out.statistics = pass.statistics();
  if (auto r = view::readBack(*pass.picture()); !r) ADD_FAILURE() << r.error().message;
  out.picture = view::readBack(*pass.picture()).value();
  out.variance = view::readBack(**pass.variance()).value();
  const std::vector<float>&p = out.picture.layers[0].pixels, &v = out.variance.layers[0].pixels;
  const double pixels = double(p.size()) / 4;
  dvec3 variance(0);
  for (std::size_t i = 0; i < p.size(); i += 4) {
    for (int c = 0; c < 3; ++c) {
      out.mean[c] += double(p[i + std::size_t(c)]) / pixels;
      variance[c] += double(v[i + std::size_t(c)]) / (pixels * pixels);
    }
    out.alpha += double(p[i + 3]) / pixels;
  }
  out.error = glm::sqrt(variance);
  EXPECT_EQ(out.statistics.violations, 0);
  EXPECT_EQ(out.statistics.endless, 0);
  return out;
}

/// Every pixel all but the same ray, `size` x `size` of them.
inline view::RenderScene rayScene(const dvec3& eye, const dvec3& target, int size, int samples) {
  view::RenderScene scene;
  scene.options.size = ivec2(size);
  scene.options.samples = samples;
  scene.options.camera = {
      eye, target, std::abs(glm::normalize(target - eye).y) > 0.9 ? dvec3(0, 0, 1) : dvec3(0, 1, 0), 1e-3};
  return scene;
}

/// The same radiance from everywhere above the horizon, and from below it, as a light.
inline shadow::ShadowedLight halves(const vec3& above, const vec3& below) {
  scene::EnvironmentMap map{{4, 256}, std::vector<vec3>(4 * 256, below)};
  std::fill_n(map.radiance.begin(), 4 * 128, above);
  return {scene::environmentLight(std::make_shared<scene::Environment>(scene::environmentOf(std::move(map)))),
          nullptr};
}

/// Within 4 standard errors of `right`, which have to be below `precision` of it.
inline void expectMean(const Traced& t, double right, double precision, const std::string& what) {
  std::printf("  %-46s %.5f +- %.5f, right %.5f, %+.2f s.e.\n", what.c_str(), t.gray(), t.grayError(), right,
              (t.gray() - right) / t.grayError());
  EXPECT_LE(t.grayError(), precision) << what;
  EXPECT_NEAR(t.gray(), right, 4 * t.grayError()) << what;
}

}  // namespace pileus::test
