#include "renderer/shadow/shadow_map.h"

#include <algorithm>
#include <optional>

namespace pileus::shadow {
namespace {

int metricCode(Metric m) {
  switch (m) {
    case Metric::Interval: return METRIC_INTERVAL;
    case Metric::Fourier: return METRIC_FOURIER;
    case Metric::Cosine: return METRIC_COSINE;
    case Metric::None: break;
  }
  return METRIC_NONE;
}

int basisCode(Basis b) { return b == Basis::Cosine ? BASIS_COSINE : b == Basis::Fourier ? BASIS_FOURIER : BASIS_SLAB; }

}  // namespace

std::size_t ShadowMap::bytes() const { return (block ? block->bytes() : 0) + (metric && metric->block ? metric->block->bytes() : 0); }

gpu::LightRecord makeRecord(const scene::Light& light, const ShadowMap* shadow) {
  gpu::LightRecord r{};
  r.towards = vec4(vec3(glm::normalize(light.towards)), 0);
  r.emitted = vec4(light.emitted, 0);
  if (!shadow) return r;
  r.extent = vec4(float(shadow->frustum.depth()), float(shadow->stepScale), 0, 0);
  r.worldFromLight = mat4(shadow->frustum.worldFromLight);
  r.lightFromWorld = mat4(glm::inverse(shadow->frustum.worldFromLight));
  const bool map = shadow->kind == ShadowMap::Kind::Extinction;
  const Metric metric = shadow->metric && shadow->metric->block ? shadow->metric->options.metric : Metric::None;
  r.shadow = ivec4(map ? SHADOW_EXTINCTION : SHADOW_RAY_MARCH, basisCode(shadow->basis), shadow->coefficients, metricCode(metric));
  if (metric != Metric::None) {
    const MetricOptions& o = shadow->metric->options;
    r.items.x = metric == Metric::Interval ? o.intervals : o.coefficients;
    r.metric = shadow->metric->block->record();
  }
  if (shadow->block) r.coefficients = shadow->block->record();
  return r;
}

gl::Defines lookupDefines(std::span<const ShadowedLight> lights) {
  int metricFloatsNeeded = 4, basis = 1, stores = 0, kinds = 0;
  std::optional<ivec4> common;  // metric, its count, basis, coefficients of all mapped lights
  bool uniform = true;
  for (const ShadowedLight& l : lights) {
    if (!l.shadow) {
      kinds |= 1;
      continue;
    }
    if (l.shadow->kind == ShadowMap::Kind::RayMarch) {
      kinds |= 4;
      continue;
    }
    kinds |= 2;
    const gpu::LightRecord r = makeRecord(l.light, l.shadow.get());
    const ivec4 choice(r.shadow.w, r.items.x, r.shadow.y, r.shadow.z);
    uniform = uniform && (!common || *common == choice);
    common = choice;
    basis = std::max(basis, l.shadow->coefficients);
    stores |= 1 << r.coefficients.kind.x;
    if (r.shadow.w != METRIC_NONE) {
      metricFloatsNeeded = std::max(metricFloatsNeeded, metricFloats(l.shadow->metric->options));
      stores |= 1 << r.metric.kind.x;
    }
  }
  gl::Defines defines = {{"METRIC_FLOATS", metricFloatsNeeded}, {"BASIS_FLOATS", basis}, {"STORES", stores}, {"LIGHT_KINDS", kinds}};
  if (uniform && common) {
    const ivec4 c = *common;
    defines.insert(defines.end(), {{"UNIFORM_MAPS", 1}, {"METRIC", c.x}, {"METRIC_COUNT", c.y}, {"BASIS", c.z}, {"COEFFICIENTS", c.w}});
  }
  return defines;
}

}  // namespace pileus::shadow
