#include "renderer/shadow/shadow_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace pileus::shadow {
namespace {

int metricCode(Metric m) {
  switch (m) {
    case Metric::Interval:
      return METRIC_INTERVAL;
    case Metric::Fourier:
      return METRIC_FOURIER;
    case Metric::Cosine:
      return METRIC_COSINE;
    case Metric::None:
      break;
  }
  return METRIC_NONE;
}

int basisCode(Basis b) {
  switch (b) {
    case Basis::Cosine:
      return BASIS_COSINE;
    case Basis::Fourier:
      return BASIS_FOURIER;
    case Basis::Slab:
      return BASIS_SLAB;
    case Basis::Piecewise:
      break;
  }
  return BASIS_PIECEWISE;
}

int kindCode(ShadowMap::Kind k) {
  switch (k) {
    case ShadowMap::Kind::Extinction:
      return SHADOW_EXTINCTION;
    case ShadowMap::Kind::TransmittanceFunction:
      return SHADOW_TRANSMITTANCE;
    case ShadowMap::Kind::Deep:
      return SHADOW_DEEP;
    case ShadowMap::Kind::RayMarch:
      break;
  }
  return SHADOW_RAY_MARCH;
}

void describeLight(const scene::Light& light, const dvec3& origin, gpu::LightRecord& r) {
  const bool sun = light.kind == scene::LightKind::Sun;
  const double outer = glm::radians(light.cone) / 2;
  r.towards = vec4(vec3(glm::normalize(light.towards)), float(sun ? light.narrow : std::cos(outer)));
  r.emitted = vec4(light.emitted, float(sun ? std::sin(glm::radians(light.angle) / 2) : light.radius));
  r.position = vec4(vec3(light.position - origin), float(std::cos(outer * (1 - light.softness))));
  r.items.w = sun ? LIGHT_SUN : light.kind == scene::LightKind::Point ? LIGHT_POINT : LIGHT_SPOT;
}

}  // namespace

std::size_t ShadowMap::bytes() const {
  return (block ? block->bytes() : 0) + (horizon ? horizon->bytes() : 0) + (metric ? metric->bytes() : 0) +
         (deep ? deep->bytes() : 0);
}

double ShadowMap::bytesPerTexel() const {
  const double edge = resolutionOf(spec);
  return edge > 0 ? double(bytes()) / (edge * edge * frustum.faces()) : 0;
}

gpu::LightRecord makeRecord(const scene::Light& light, const ShadowMap* shadow, const dvec3& origin) {
  gpu::LightRecord r{};
  describeLight(light, origin, r);
  if (!shadow) return r;
  const LightFrustum& f = shadow->frustum;
  r.extent = vec4(float(f.depth()), float(shadow->stepScale), float(f.perspective() ? f.nearDistance : 0),
                  float(f.tanHalf));
  dmat4 worldFromLight = f.worldFromLight;
  worldFromLight[3] -= dvec4(origin, 0);
  r.worldFromLight = mat4(worldFromLight);
  r.lightFromWorld = mat4(glm::inverse(worldFromLight));
  const Metric metric =
      shadow->metric && shadow->metric->block ? shadow->metric->options.metric : Metric::None;
  r.shadow =
      ivec4(kindCode(shadow->kind), basisCode(shadow->basis), shadow->coefficients, metricCode(metric));
  if (metric != Metric::None) {
    const MetricOptions& o = shadow->metric->options;
    r.items.x = metric == Metric::Interval ? o.intervals : o.coefficients;
    r.metric = shadow->metric->block->record();
    if (const auto& weights = shadow->metric->weights)
      r.weights = weights->record().place, r.solids.z |= LIGHT_HAS_WEIGHTS;
    if (metric == Metric::Interval && o.horizon > 0) r.solids.z |= LIGHT_HAS_HORIZON;
  }
  if (shadow->block) r.coefficients = shadow->block->record();
  if (shadow->horizon) r.horizon = shadow->horizon->record().place;
  if (shadow->deep) {
    r.coefficients.place.z = shadow->spec.resolution;
    r.items.y = int(shadow->deep->first());
  }
  return r;
}

gl::Defines lookupDefines(std::span<const ShadowedLight> lights) {
  int metricFloatsNeeded = 4, basis = 1, stores = 0, kinds = 0, weights = 0, horizon = 0, bases = 0;
  std::optional<std::array<int, 7>>
      common;  // kind, metric, its count, basis, coefficients, stores of the mapped lights
  bool uniform = true;
  for (const ShadowedLight& l : lights) {
    kinds |= 1 << (l.shadow ? kindCode(l.shadow->kind) : SHADOW_NONE);
    if (!l.shadow || l.shadow->kind == ShadowMap::Kind::RayMarch) continue;
    const gpu::LightRecord r = makeRecord(l.light, l.shadow.get());
    const std::array<int, 7> choice{r.shadow.x,      r.shadow.w,           r.items.x, r.shadow.y, r.shadow.z,
                                    r.metric.kind.x, r.coefficients.kind.x};
    uniform = uniform && (!common || *common == choice);
    common = choice;
    if (l.shadow->kind == ShadowMap::Kind::Extinction) bases |= 1 << r.shadow.y;
    weights |= (r.solids.z & LIGHT_HAS_WEIGHTS) != 0;
    horizon |= (r.solids.z & LIGHT_HAS_HORIZON) != 0;
    if (l.shadow->kind == ShadowMap::Kind::Deep) continue;
    basis = std::max(basis, l.shadow->coefficients);
    stores |= 1 << r.coefficients.kind.x;
    if (r.shadow.w != METRIC_NONE) {
      metricFloatsNeeded = std::max(metricFloatsNeeded, metricFloats(l.shadow->metric->options));
      stores |= 1 << r.metric.kind.x;
    }
  }
  gl::Defines defines = {{"METRIC_FLOATS", metricFloatsNeeded},
                         {"BASIS_FLOATS", basis},
                         {"STORES", stores},
                         {"LIGHT_KINDS", kinds},
                         {"WEIGHTS", weights},
                         {"HORIZON", horizon},
                         {"LOOKUP_BASES", bases}};
  if (uniform && common) {
    const std::array<int, 7>& c = *common;
    defines.insert(defines.end(), {{"UNIFORM_MAPS", 1},
                                   {"METRIC", c[1]},
                                   {"METRIC_COUNT", c[2]},
                                   {"BASIS", c[3]},
                                   {"COEFFICIENTS", c[4]},
                                   {"METRIC_STORE", c[5]},
                                   {"COEFFICIENT_STORE", c[6]}});
  }
  return defines;
}

}  // namespace pileus::shadow
