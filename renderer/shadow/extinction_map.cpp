#include "renderer/shadow/extinction_map.h"

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"

namespace pileus::shadow {

ExtinctionPass::ExtinctionPass(const ExtinctionOptions& options, const scene::Light& light, const volume::InstanceList& volumes, const LightFrustum& frustum)
    : options_(options), map_(std::make_shared<ShadowMap>()), light_(light), volumes_(residency::canonical(volumes)) {
  map_->basis = options.basis;
  map_->coefficients = options.coefficients;
  map_->storage = options.storage;
  map_->frustum = frustum;
}

ExtinctionPass::ExtinctionPass(const ExtinctionOptions& options, std::shared_ptr<const PseudometricMap> metric)
    : ExtinctionPass(options, metric->light, metric->volumes, metric->frustum) {
  map_->metric = std::move(metric);
}

Result<double> ExtinctionPass::step(const Gpu& gpu, double ms) {
  const Stopwatch clock;
  PILEUS_TRY(const residency::Residency residency, set_.prepare(gpu.bricks, volumes_, ms));
  if (residency.fraction < 1) return 0.3 * residency.fraction;
  if (!ready_) {
    PILEUS_TRY(map_->block, gpu.store.allocate(options_.storage == Storage::Float ? Texels::Float : Texels::Half, options_.resolution, (options_.coefficients + 3) / 4));
    tiles_.build(ivec2(options_.resolution), mapBounds(set_.instances(), map_->frustum, options_.resolution));
    cursor_ = gl::RegionCursor(ivec2(options_.resolution), gpu.device, 64);
    ready_ = true;
  }
  const gpu::LightRecord record = makeRecord(light_, map_.get());
  record_.reserve(MAX_LIGHTS * sizeof record);
  record_.assign(&record, sizeof record);
  record_.bindUniform(BIND_LIGHTS);
  do {
    PILEUS_CHECK(dispatch(gpu));
    ++cursor_.next;
  } while (!cursor_.done() && clock.ms() < ms);
  return 0.3 + 0.7 * double(cursor_.next) / cursor_.count();
}

Result<void> ExtinctionPass::dispatch(const Gpu& gpu) {
  const gpu::LightRecord r = makeRecord(light_, map_.get());
  const bool hasMetric = r.shadow.w != METRIC_NONE;
  const gl::Defines defines = {{"METRIC", r.shadow.w},
                               {"METRIC_COUNT", r.items.x},
                               {"METRIC_FLOATS", hasMetric ? metricFloats(map_->metric->options) : 4},
                               {"BASIS", r.shadow.y},
                               {"BASIS_FLOATS", options_.coefficients},
                               {"STORES", hasMetric ? 1 << r.metric.kind.x : 1},
                               {"STORE", r.coefficients.kind.x},
                               {"SHAPES", set_.shapes()}};
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"shadow/extinction_map.comp.glsl"}, defines));
  program->use();
  set_.bind(gpu.bricks, *program);
  tiles_.bind(*program);
  gpu.store.bind();
  program->set("regionOrigin", cursor_.origin());
  program->set("regionEnd", cursor_.end());
  program->set("footprint", float(map_->frustum.texelSize(options_.resolution)));
  glBindImageTexture(IMAGE_TARGET, map_->block->texture(), 0, GL_TRUE, 0, GL_WRITE_ONLY, map_->block->format());
  const ivec2 groups = (cursor_.end() - cursor_.origin() + 7) / 8;
  timer_.begin();
  glDispatchCompute(GLuint(groups.x), GLuint(groups.y), 1);
  timer_.end();
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glFinish();
  return {};
}

}  // namespace pileus::shadow
