#include "renderer/shadow/extinction_map.h"

#include <algorithm>

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/resume.h"
#include "renderer/shadow/additive_target.h"
#include "renderer/shadow/new_map.h"

namespace pileus::shadow {

Result<void> checkOptions(const ExtinctionOptions& options, const MetricOptions& metric) {
  const bool intervals = metric.metric == Metric::Interval;
  if (options.accumulation == Accumulation::Splat && intervals && metric.horizon > 0)
    return fail(Code::Input,
                "accumulation: splatting knows no horizon; gather, or set the metric's horizon to 0");
  if (options.basis == Basis::Piecewise && intervals && options.coefficients < metric.intervals)
    return fail(Code::Input,
                "coefficients: {} are too few for the metric's {} intervals, each of which needs one",
                options.coefficients, metric.intervals);
  return {};
}

ExtinctionPass::ExtinctionPass(const ExtinctionOptions& options, const scene::Light& light,
                               const volume::InstanceList& volumes, const LightFrustum& frustum)
    : options_(options),
      pass_(volumes, frustum, options.resolution),
      map_(newMap(ShadowMap::Kind::Extinction, {}, light, pass_.volumes(), {}, frustum)) {
  map_->basis = options.basis == Basis::Piecewise ? Basis::Cosine : options.basis;  // no intervals
  map_->coefficients = options.coefficients;
  map_->storage = options.storage;
  map_->spec.extinction = options;
  map_->spec.metric.metric = Metric::None;
}

ExtinctionPass::ExtinctionPass(const ExtinctionOptions& options,
                               std::shared_ptr<const PseudometricMap> metric)
    : ExtinctionPass(options, metric->light, metric->volumes, metric->frustum) {
  map_->spec.metric = metric->options;
  if (metric->options.metric == Metric::Interval) map_->basis = options.basis;
  map_->metric = std::move(metric);
}

void ExtinctionPass::remember(const scene::SolidList& solids, const ShadowSpec& spec) {
  map_->solids = solids;
  map_->spec = spec;
}

Result<void> ExtinctionPass::allocate(const Gpu& gpu) {
  const int faces = map_->frustum.faces();
  const bool horizon =
      map_->metric && map_->metric->options.metric == Metric::Interval && map_->metric->options.horizon > 0;
  if (map_->metric) PILEUS_CHECK(checkOptions(options_, map_->metric->options));
  PILEUS_TRY(map_->block,
             gpu.store.allocate(options_.storage == Storage::Float ? Texels::Float : Texels::Half,
                                options_.resolution, (options_.coefficients + 3) / 4, faces));
  if (horizon) {
    PILEUS_TRY(map_->horizon, gpu.store.allocate(Texels::Pair, options_.resolution, 1, faces));
  }
  return {};
}

Result<double> ExtinctionPass::step(const Gpu& gpu, double ms) {
  const Stopwatch clock;
  PILEUS_TRY(const double resident, pass_.prepare(gpu, ms));
  if (resident < 1) return 0.3 * resident;
  if (!map_->block) PILEUS_CHECK(allocate(gpu));
  PILEUS_CHECK(pass_.bindLight(*map_));
  const int volumes = int(pass_.volumes().size());
  while (splats() && splatted_ < std::max(volumes, 1)) {
    PILEUS_CHECK(splat(gpu));
    if (++splatted_ >= volumes || clock.ms() >= ms) break;
  }
  if (splats() && splatted_ < volumes) return 0.3 + 0.6 * splatted_ / volumes;
  const bool marks = map_->metric && map_->metric->options.metric == Metric::Interval;
  do {
    if (!splats())
      PILEUS_CHECK(gather(gpu));
    else if (marks)
      PILEUS_CHECK(mark(gpu));
    pass_.next();
  } while (!pass_.done() && clock.ms() < ms);
  return splats() ? 0.9 + 0.1 * pass_.fraction() : 0.3 + 0.7 * pass_.fraction();
}

gl::Defines ExtinctionPass::defines() const {
  const gpu::LightRecord r = makeRecord(map_->light, map_.get());
  const bool hasMetric = r.shadow.w != METRIC_NONE;
  return {{"METRIC", r.shadow.w},
          {"METRIC_COUNT", r.items.x},
          {"METRIC_FLOATS", hasMetric ? metricFloats(map_->metric->options) : 4},
          {"BASIS", r.shadow.y},
          {"BASIS_FLOATS", options_.coefficients},
          {"COEFFICIENTS", options_.coefficients},
          {"STORES", 1 << (hasMetric ? r.metric.kind.x : STORE_FLOAT)},
          {"STORE", r.coefficients.kind.x},
          {"WEIGHTS", (r.solids.z & LIGHT_HAS_WEIGHTS) != 0},
          {"HORIZON", (r.solids.z & LIGHT_HAS_HORIZON) != 0},
          {"DAMPING", options_.damping},
          {"PERSPECTIVE", map_->frustum.perspective()},
          {"SHAPES", pass_.shapes()}};
}

int ExtinctionPass::batch() const {
  // llvmpipe ends all loops of an invocation once they have run 65535 times in total, and a GPU must not be
  // held for seconds. A volume costs at most two iterations a step; lanes that find their steps at different
  // places wait for each other, which the room left here is for.
  constexpr double kOneDispatch = 20000;
  const int volumes = std::max(1, static_cast<int>(kOneDispatch / (2 * mostSteps(pass_.volumes()))));
  return volumes < pass_.longestList() ? volumes : 0;
}

Result<void> ExtinctionPass::gather(const Gpu& gpu) {
  const int volumes = batch(), batches = volumes > 0 ? (pass_.longestList() + volumes - 1) / volumes : 1;
  gl::Defines variant = defines();
  variant.push_back({"BATCHED", volumes > 0});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"shadow/extinction_map.comp.glsl"}, variant));
  if (volumes > 0) {
    PILEUS_CHECK(
        sums_.reserve(pass_.threads() * static_cast<std::size_t>(options_.coefficients + 2) * sizeof(float)));
    sums_.bindStorage(BIND_MARCH_STATES);
  }
  glBindImageTexture(IMAGE_TARGET, map_->block->texture(), 0, GL_TRUE, 0, GL_WRITE_ONLY,
                     map_->block->format());
  if (map_->horizon)
    glBindImageTexture(IMAGE_TARGET + 1, map_->horizon->texture(), 0, GL_TRUE, 0, GL_WRITE_ONLY,
                       map_->horizon->format());
  for (int i = 0; i < batches; ++i) {
    if (volumes > 0) program->set("batch", ivec2(i, volumes));
    PILEUS_CHECK(pass_.dispatch(gpu, *program));
  }
  return {};
}

Result<void> ExtinctionPass::splat(const Gpu& gpu) {
  const gpu::BlockRecord block = map_->block->record();
  const int edge = block.place.z, layers = block.kind.y;
  PILEUS_TRY(gl::Program * program,
             gpu.shaders.program({"shadow/extinction_splat.vert.glsl", "shadow/extinction_splat.frag.glsl"},
                                 defines()));
  if (splatted_ == 0) bounds_ = mapBounds(pass_.volumes(), map_->frustum, edge, pass_.faceStride());
  if (splatted_ == 0 && !gpu.device.software) rows_ = {gl::RegionCursor::kTile, 1, edge};
  AdditiveTarget target;
  for (int face = 0; face < block.kind.z; ++face) {
    target.attach(map_->block->texture(), block.place.w + face * layers, layers, ivec2(block.place), edge,
                  splatted_ == 0);
    if (pass_.volumes().empty()) continue;
    const residency::PixelBounds& b =
        bounds_[std::size_t(face) * pass_.volumes().size() + std::size_t(splatted_)];
    if (b.min.x >= b.max.x || b.min.y >= b.max.y) continue;
    const ivec2 origin = ivec2(block.place) + b.min - ivec2(0, face * pass_.faceStride());
    PILEUS_CHECK(pass_.bind(gpu, *program));
    program->set("item", splatted_);
    program->set("face", face);
    program->set("blockOrigin", ivec2(block.place));
    const ivec2 size = b.max - b.min;
    for (int y = 0, rows = 0; y < size.y; y += rows) {
      const Stopwatch clock;
      rows = std::min(rows_.now, size.y - y);
      glScissor(origin.x, origin.y + y, size.x, rows);
      pass_.timer().begin();
      glDrawArrays(GL_TRIANGLES, 0, 3);
      pass_.timer().end();
      glFinish();
      rows_.took(clock.ms());
    }
  }
  return {};
}

Result<void> ExtinctionPass::mark(const Gpu& gpu) {
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"shadow/extinction_mark.comp.glsl"}, defines()));
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glBindImageTexture(IMAGE_TARGET, map_->block->texture(), 0, GL_TRUE, 0, GL_READ_WRITE,
                     map_->block->format());
  return pass_.dispatch(gpu, *program);
}

}  // namespace pileus::shadow
