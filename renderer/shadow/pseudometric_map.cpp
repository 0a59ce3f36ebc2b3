#include "renderer/shadow/pseudometric_map.h"

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/metric_faces.h"
#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

int metricFloats(const MetricOptions& o) {
  const int floats = o.metric == Metric::Interval ? 2 * o.intervals
                     : o.metric == Metric::None   ? 0
                                                  : o.coefficients;
  return (floats + 3) / 4 * 4;
}

PseudometricPass::PseudometricPass(const MetricOptions& options, const scene::Light& light,
                                   const volume::InstanceList& volumes, const LightFrustum& frustum)
    : map_(std::make_shared<PseudometricMap>()), pass_(volumes, frustum, options.resolution, 16) {
  map_->options = options;
  map_->light = light;
  map_->volumes = pass_.volumes();
  map_->frustum = frustum;
}

Result<void> PseudometricPass::allocate(const Gpu& gpu) {
  const MetricOptions& o = map_->options;
  const bool intervals = o.metric == Metric::Interval;
  const Texels texels = intervals && o.compact        ? Texels::Byte
                        : o.storage == Storage::Float ? Texels::Float
                        : intervals                   ? Texels::Unorm
                                                      : Texels::Half;
  const int faces = map_->frustum.faces();
  PILEUS_TRY(map_->block, gpu.store.allocate(texels, o.resolution, metricFloats(o) / 4, faces));
  if (o.metric == Metric::Interval && o.weighting != Weighting::None) {
    PILEUS_TRY(map_->weights, gpu.store.allocate(Texels::Byte, o.resolution, (o.intervals + 3) / 4, faces));
  }
  return {};
}

Result<double> PseudometricPass::step(const Gpu& gpu, double ms) {
  const Stopwatch clock;
  if (map_->options.metric == Metric::None) return 1.0;
  PILEUS_TRY(const double resident, pass_.prepare(gpu, ms));
  if (resident < 1) return 0.3 * resident;
  if (!map_->block) PILEUS_CHECK(allocate(gpu));
  ShadowMap asMap;
  asMap.light = map_->light;
  asMap.metric = map_;
  asMap.frustum = map_->frustum;
  PILEUS_CHECK(pass_.bindLight(asMap));
  if (map_->options.metric != Metric::Interval) {
    PILEUS_CHECK(drawMetricFaces(gpu, map_->options, pass_, *map_->block));
    pass_.finish();
    return 1.0;
  }
  do {
    PILEUS_CHECK(dispatchIntervals(gpu));
    pass_.next();
  } while (!pass_.done() && clock.ms() < ms);
  return 0.3 + 0.7 * pass_.fraction();
}

Result<void> PseudometricPass::dispatchIntervals(const Gpu& gpu) {
  constexpr int kProbes = 64;
  const ShadowBlock& block = *map_->block;
  const MetricOptions& o = map_->options;
  const bool probes = map_->weights || o.horizon > 0;
  PILEUS_TRY(
      gl::Program * program,
      gpu.shaders.program({"shadow/interval_map.comp.glsl"},
                          {{"INTERVALS", o.intervals},
                           {"STORE", int(block.texels())},
                           {"SHAPES", pass_.shapes()},
                           {"BRICKS", o.coverage == Coverage::Bricks && (pass_.shapes() & SHAPES_GRID)},
                           {"PROBES", probes ? kProbes : 0},
                           {"WEIGHTS", map_->weights != nullptr}}));
  glBindImageTexture(IMAGE_TARGET, block.texture(), 0, GL_TRUE, 0, GL_WRITE_ONLY, block.format());
  if (map_->weights)
    glBindImageTexture(IMAGE_TARGET + 1, map_->weights->texture(), 0, GL_TRUE, 0, GL_WRITE_ONLY,
                       map_->weights->format());
  program->use();
  program->set("horizon", float(o.horizon));
  return pass_.dispatch(gpu, *program);
}

}  // namespace pileus::shadow
