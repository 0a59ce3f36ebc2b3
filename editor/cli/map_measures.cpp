#include "editor/cli/map_measures.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "renderer/shadow/reference.h"
#include "renderer/truth/shadow_probe.h"

namespace pileus::cli {
namespace {

volume::Instance box(const dvec3& center, const dvec3& size, double sigma, const dvec3& rotate) {
  volume::Instance i;
  i.shape = volume::Shape::Box;
  i.worldFromLocal = composeTransform(center, rotate, size);
  i.medium.extinction = sigma;
  return i;
}

}  // namespace

SilhouetteScene silhouetteScene() {
  SilhouetteScene s;
  s.light.towards = dvec3(0, 1, 0);
  s.volumes = {box({-0.45, 1.5, 0.1}, {1, 0.3, 1}, 5, {0, 30, 0}), box({0, 0, 0}, {2, 0.6, 2}, 1, dvec3(0))};
  return s;
}

Result<double> silhouetteError(const shadow::Gpu& gpu, const shadow::ShadowSpec& spec) {
  const SilhouetteScene scene = silhouetteScene();
  PILEUS_TRY(const std::shared_ptr<const shadow::ShadowMap> map,
             shadow::buildShadow(gpu, spec, scene.light, scene.volumes));
  const int n = shadow::resolutionOf(spec);
  std::vector<vec4> at;
  std::vector<double> expected;
  std::mt19937 rng(9);
  std::uniform_real_distribution<double> u(0, 1);
  while (at.size() < 4000) {
    const dvec3 p(2 * u(rng) - 1, 0.6 * u(rng) - 0.3, 2 * u(rng) - 1);
    const dvec3 q = shadow::mapCoordinates(map->frustum, p, n).at;
    const dvec2 f = dvec2(q) * double(n) - 0.5, base = glm::floor(f), w = f - base;
    double blend = 0, weights = 0;
    for (int tap = 0; tap < 4; ++tap) {
      const dvec2 o(tap & 1, tap >> 1);
      const shadow::MapSegment ray = shadow::mapSegment(map->frustum, 0, (base + o + 0.5) / double(n), n);
      const dvec3 end = glm::mix(ray.from, ray.to, q.z);
      if (std::max(std::abs(end.x), std::abs(end.z)) >= 1)
        continue;  // a ray that meets no medium here says nothing
      const double weight = (o.x > 0 ? w.x : 1 - w.x) * (o.y > 0 ? w.y : 1 - w.y);
      blend += weight * std::exp(-shadow::opticalDepth(scene.volumes, ray.from, end));
      weights += weight;
    }
    if (weights < 0.999) continue;
    at.push_back(vec4(vec3(p), 0));
    expected.push_back(blend);
  }
  PILEUS_TRY(const std::vector<float> mapped, truth::lookupTransmittance(gpu, *map, at));
  return truth::shadowError(mapped, expected).maximum;
}

shadow::ShadowSpec intervalSpec(int intervals, int coefficients, int resolution, bool extras,
                                shadow::Storage storage) {
  shadow::ShadowSpec s;
  s.metric = {shadow::Metric::Interval, intervals, 4, resolution, storage};
  if (extras) s.metric.weighting = shadow::Weighting::Root, s.metric.horizon = 5.5;
  s.extinction = {shadow::Basis::Cosine, coefficients, resolution, storage};
  return s;
}

shadow::ShadowSpec deepSpec(double bound, int resolution) {
  shadow::ShadowSpec s;
  s.kind = shadow::ShadowSpec::Kind::Deep;
  s.errorBound = bound;
  s.nodeBudget = 4096;
  s.resolution = resolution;
  return s;
}

Result<DeepMeasure> measureDeep(const shadow::Gpu& gpu, const shadow::ShadowSpec& spec,
                                const shadow::ShadowMap& uncompressed, std::span<const vec4> at) {
  shadow::ShadowPass pass(spec, uncompressed.light, uncompressed.volumes);
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(gpu, 1e12));
  }
  PILEUS_TRY(const std::vector<float> raw, truth::lookupTransmittance(gpu, uncompressed, at));
  PILEUS_TRY(const std::vector<float> mapped, truth::lookupTransmittance(gpu, *pass.map(), at));
  DeepMeasure m;
  m.statistics = *pass.deepStatistics();
  m.largest = truth::shadowError(mapped, std::vector<double>(raw.begin(), raw.end())).maximum;
  return m;
}

}  // namespace pileus::cli
