// Maps of ray families against their truth.
#include <algorithm>
#include <cmath>

#include "editor/cli/ray_families.h"
#include "renderer/truth/shadow_probe.h"

namespace pileus::cli {
namespace {

template <class Pass>
Result<void> finish(Pass& pass, const shadow::Gpu& gpu) {
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(gpu, 1e12));
  }
  return {};
}

}  // namespace

Result<RayError> measure(const shadow::Gpu& gpu, const RayScene& scene, const scene::Light& light,
                         const std::shared_ptr<const shadow::ShadowMap>& map) {
  shadow::ShadowMap lit = *map;
  lit.light = light;
  PILEUS_TRY(const std::vector<float> mapped, truth::lookupTransmittance(gpu, lit, scene.positions));
  struct Sum {
    double square = 0, worst = 0;
    std::size_t n = 0;
  };
  std::vector<Sum> perRay(std::size_t(scene.rays), Sum{});
  RayError error;
  for (std::size_t i = 0; i < mapped.size(); ++i) {
    const double d = std::abs(double(mapped[i]) - scene.transmittance[i]);
    Sum& s = perRay[std::size_t(scene.positions[i].w)];
    s.square += d * d;
    s.worst = std::max(s.worst, d);
    ++s.n;
    error.mean += d / double(mapped.size());
  }
  std::vector<double> worst;
  for (const Sum& s : perRay) {
    error.rms += std::sqrt(s.square / double(std::max<std::size_t>(s.n, 1))) / scene.rays;
    worst.push_back(s.worst);
  }
  std::sort(worst.begin(), worst.end());
  error.p95Max = worst[std::size_t(0.95 * double(worst.size() - 1))];
  return error;
}

Result<RayError> measure(const shadow::Gpu& gpu, const RayScene& scene,
                         const shadow::MetricOptions& metricOptions,
                         const shadow::ExtinctionOptions& extinctionOptions) {
  shadow::MetricOptions m = metricOptions;
  shadow::ExtinctionOptions e = extinctionOptions;
  m.resolution = e.resolution = scene.resolution;
  shadow::PseudometricPass metric(m, scene.light, scene.volumes, scene.frustum);
  PILEUS_CHECK(finish(metric, gpu));
  shadow::ExtinctionPass extinction(e, metric.map());
  PILEUS_CHECK(finish(extinction, gpu));
  return measure(gpu, scene, scene.light, extinction.map());
}

}  // namespace pileus::cli
