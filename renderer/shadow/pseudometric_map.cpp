#include "renderer/shadow/pseudometric_map.h"

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

int metricFloats(const MetricOptions& o) {
  const int floats = o.metric == Metric::Interval ? 2 * o.intervals : o.metric == Metric::None ? 0 : o.coefficients;
  return (floats + 3) / 4 * 4;
}

std::vector<residency::PixelBounds> mapBounds(const volume::InstanceList& instances, const LightFrustum& frustum, int resolution) {
  const dmat4 lightFromWorld = glm::inverse(frustum.worldFromLight);
  std::vector<residency::PixelBounds> out;
  for (const volume::Instance& i : instances) {
    const Box3 box = transformed(volume::localBounds(i), lightFromWorld * i.worldFromLocal);
    const dvec2 lo = glm::clamp(dvec2(box.min) * double(resolution) - 1.0, -1.0, resolution + 1.0);
    const dvec2 hi = glm::clamp(dvec2(box.max) * double(resolution) + 1.0, -1.0, resolution + 1.0);
    out.push_back({ivec2(glm::floor(lo)), ivec2(glm::ceil(hi))});
  }
  return out;
}

PseudometricPass::PseudometricPass(const MetricOptions& options, const scene::Light& light, const volume::InstanceList& volumes, const LightFrustum& frustum)
    : map_(std::make_shared<PseudometricMap>()) {
  map_->options = options;
  map_->light = light;
  map_->volumes = residency::canonical(volumes);
  map_->frustum = frustum;
}

Result<double> PseudometricPass::step(const Gpu& gpu, double ms) {
  const Stopwatch clock;
  const MetricOptions& o = map_->options;
  if (o.metric == Metric::None) return 1.0;
  PILEUS_TRY(const residency::Residency residency, set_.prepare(gpu.bricks, map_->volumes, ms));
  if (residency.fraction < 1) return 0.3 * residency.fraction;
  if (!ready_) {
    const Texels texels = o.storage == Storage::Float ? Texels::Float : o.metric == Metric::Interval ? Texels::Unorm : Texels::Half;
    PILEUS_TRY(map_->block, gpu.store.allocate(texels, o.resolution, metricFloats(o) / 4));
    tiles_.build(ivec2(o.resolution), mapBounds(set_.instances(), map_->frustum, o.resolution));
    cursor_ = gl::RegionCursor(ivec2(o.resolution), gpu.device, 256);
    ready_ = true;
  }
  ShadowMap asMap;
  asMap.metric = map_;
  asMap.frustum = map_->frustum;
  const gpu::LightRecord record = makeRecord(map_->light, &asMap);
  record_.reserve(MAX_LIGHTS * sizeof record);
  record_.assign(&record, sizeof record);
  record_.bindUniform(BIND_LIGHTS);
  if (o.metric != Metric::Interval) {
    PILEUS_CHECK(drawFaces(gpu));
    return 1.0;
  }
  do {
    PILEUS_CHECK(dispatchIntervals(gpu));
    ++cursor_.next;
  } while (!cursor_.done() && clock.ms() < ms);
  return 0.3 + 0.7 * double(cursor_.next) / cursor_.count();
}

Result<void> PseudometricPass::dispatchIntervals(const Gpu& gpu) {
  const ShadowBlock& block = *map_->block;
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"shadow/interval_map.comp.glsl"}, {{"INTERVALS", map_->options.intervals}, {"STORE", int(block.texels())}, {"SHAPES", set_.shapes()}, {"BRICKS", map_->options.coverage == Coverage::Bricks && (set_.shapes() & 1)}}));
  program->use();
  set_.bind(gpu.bricks, *program);
  tiles_.bind(*program);
  program->set("regionOrigin", cursor_.origin());
  program->set("regionEnd", cursor_.end());
  glBindImageTexture(IMAGE_TARGET, block.texture(), 0, GL_TRUE, 0, GL_WRITE_ONLY, block.format());
  const ivec2 groups = (cursor_.end() - cursor_.origin() + 7) / 8;
  timer_.begin();
  glDispatchCompute(GLuint(groups.x), GLuint(groups.y), 1);
  timer_.end();
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glFinish();
  return {};
}

Result<void> PseudometricPass::drawFaces(const Gpu& gpu) {
  const ShadowBlock& block = *map_->block;
  const gpu::BlockRecord record = block.record();
  const int metric = map_->options.metric == Metric::Cosine ? METRIC_COSINE : METRIC_FOURIER;
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"shadow/metric_faces.vert.glsl", "shadow/metric_faces.frag.glsl"},
                                                       {{"METRIC", metric}, {"TERMS", map_->options.coefficients}}));
  GLuint framebuffer = 0, vertices = 0;
  glCreateFramebuffers(1, &framebuffer);
  glCreateVertexArrays(1, &vertices);
  // Half maps are summed in float and rounded once.
  gl::Texture sum;
  if (block.texels() != Texels::Float) sum = gl::Texture(GL_TEXTURE_2D_ARRAY, GL_RGBA32F, ivec3(ivec2(record.place.z), block.layers()), "metric sum");
  const ivec2 origin = sum ? ivec2(0) : ivec2(record.place);
  GLenum buffers[4];
  for (int layer = 0; layer < block.layers(); ++layer) {
    glNamedFramebufferTextureLayer(framebuffer, GL_COLOR_ATTACHMENT0 + GLenum(layer), sum ? sum.id() : block.texture(), 0, sum ? layer : record.place.w + layer);
    buffers[layer] = GL_COLOR_ATTACHMENT0 + GLenum(layer);
  }
  glNamedFramebufferDrawBuffers(framebuffer, block.layers(), buffers);
  GLint before[4], boundFramebuffer = 0;
  glGetIntegerv(GL_VIEWPORT, before);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &boundFramebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glViewport(origin.x, origin.y, record.place.z, record.place.z);
  glScissor(origin.x, origin.y, record.place.z, record.place.z);
  glEnable(GL_SCISSOR_TEST);
  const vec4 zero(0);
  for (int layer = 0; layer < block.layers(); ++layer) glClearNamedFramebufferfv(framebuffer, GL_COLOR, layer, &zero.x);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_DEPTH_CLAMP);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
  program->use();
  set_.bind(gpu.bricks, *program);
  glBindVertexArray(vertices);
  timer_.begin();
  glDrawArraysInstanced(GL_TRIANGLES, 0, 36, GLsizei(set_.instances().size()));
  timer_.end();
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_CLAMP);
  glDisable(GL_SCISSOR_TEST);
  glBindVertexArray(0);
  if (sum) {
    GLuint target = 0;
    glCreateFramebuffers(1, &target);
    const int edge = record.place.z, x = record.place.x, y = record.place.y;
    for (int layer = 0; layer < block.layers(); ++layer) {
      glNamedFramebufferReadBuffer(framebuffer, GL_COLOR_ATTACHMENT0 + GLenum(layer));
      glNamedFramebufferTextureLayer(target, GL_COLOR_ATTACHMENT0, block.texture(), 0, record.place.w + layer);
      glBlitNamedFramebuffer(framebuffer, target, 0, 0, edge, edge, x, y, x + edge, y + edge, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    glDeleteFramebuffers(1, &target);
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(boundFramebuffer));
  glViewport(before[0], before[1], before[2], before[3]);
  glDeleteFramebuffers(1, &framebuffer);
  glDeleteVertexArrays(1, &vertices);
  glFinish();
  cursor_.next = cursor_.count();
  return {};
}

}  // namespace pileus::shadow
