#include "tests/support/gpu.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "renderer/truth/shadow_probe.h"

namespace pileus::test {
namespace {

template <class T>
T must(Result<T> r) {
  if (!r) {
    std::fprintf(stderr, "%s\n", r.error().message.c_str());
    ADD_FAILURE() << r.error().message;
    std::abort();
  }
  return std::move(r).value();
}

template <class Pass>
void finish(Pass& pass) {
  while (must(pass.step(renderer().gpu(), 1e12)) < 1) {
  }
}

}  // namespace

view::Renderer& renderer() {
  static const std::unique_ptr<gl::HeadlessContext> context = must(gl::HeadlessContext::create());
  static const std::unique_ptr<view::Renderer> r = must(view::Renderer::create());
  return *r;
}

volume::Instance box(const dvec3& center, const dvec3& size, double sigma, const dvec3& rotate) {
  volume::Instance i;
  i.shape = volume::Shape::Box;
  i.worldFromLocal = composeTransform(center, rotate, size);
  i.medium.extinction = sigma;
  return i;
}

volume::Instance ball(const dvec3& center, double radius, double sigma) {
  volume::Instance i;
  i.shape = volume::Shape::Ball;
  i.worldFromLocal = composeTransform(center, dvec3(0), dvec3(radius));
  i.medium.extinction = sigma;
  return i;
}

scene::Light sunFrom(const dvec3& towards, float irradiance) {
  scene::Light light;
  light.towards = glm::normalize(towards);
  light.emitted = vec3(irradiance);
  return light;
}

std::shared_ptr<const shadow::ShadowMap> buildMap(const volume::InstanceList& volumes,
                                                  const scene::Light& light,
                                                  const shadow::MetricOptions& metric,
                                                  const shadow::ExtinctionOptions& extinction,
                                                  const shadow::LightFrustum* frustum) {
  renderer();
  shadow::PseudometricPass m(metric, light, volumes,
                             frustum ? *frustum : shadow::fitLight(light, volumes, metric.resolution));
  finish(m);
  shadow::ExtinctionPass e(extinction, m.map());
  finish(e);
  return e.map();
}

std::vector<float> lookupTau(const shadow::ShadowMap& map, const scene::Light& light,
                             const std::vector<vec3>& positions) {
  shadow::ShadowMap lit = map;  // by the light that is asked for
  lit.light = light;
  std::vector<vec4> padded;
  for (const vec3& p : positions) padded.push_back(vec4(p, 0));
  std::vector<float> tau = must(truth::lookupTransmittance(renderer().gpu(), lit, padded));
  for (float& t : tau) t = -std::log(std::max(t, std::numeric_limits<float>::min()));
  return tau;
}

std::vector<float> texel(const shadow::ShadowBlock& block, ivec2 at) {
  const gpu::BlockRecord r = block.record();
  std::vector<float> out(std::size_t(block.layers()) * 4);
  glGetTextureSubImage(block.texture(), 0, r.place.x + at.x, r.place.y + at.y, r.place.w, 1, 1,
                       block.layers(), GL_RGBA, GL_FLOAT, GLsizei(out.size() * sizeof(float)), out.data());
  return out;
}

image::Image render(const view::RenderOptions& options, const volume::InstanceList& volumes,
                    const std::vector<shadow::ShadowedLight>& lights) {
  renderer();
  view::VolumeRenderPass pass(options, volumes, lights);
  finish(pass);
  return must(view::readBack(*pass.picture()));
}

double largestDifference(const image::Image& a, const image::Image& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.layers[0].pixels.size(); ++i)
    most = std::max(most, std::abs(double(a.layers[0].pixels[i]) - double(b.layers[0].pixels[i])));
  return most;
}

}  // namespace pileus::test
