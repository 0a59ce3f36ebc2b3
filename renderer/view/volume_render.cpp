#include "renderer/view/volume_render.h"

#include <algorithm>

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/view/camera_rays.h"

namespace pileus::view {

namespace {

/// Those that the layer is made of.
std::vector<shadow::ShadowedLight> lightsOf(const RenderScene& scene) {
  const PictureLayer& layer = scene.options.layer;
  if (layer.kind == PictureLayer::Kind::Beauty) return scene.lights;
  const auto i = std::size_t(layer.light);
  if (layer.kind == PictureLayer::Kind::Light && i < scene.lights.size()) return {scene.lights[i]};
  return {};
}

}  // namespace

VolumeRenderPass::VolumeRenderPass(RenderScene scene)
    : scene_(std::make_shared<const RenderScene>(std::move(scene))),
      // A light's layer leaves the emission out, but steps as the beauty does, so that the layers add up to
      // it.
      lights_(lightsOf(*scene_), scene_->volumes, scene_->solids,
              scene_->options.layer.kind != PictureLayer::Kind::Depth) {
  const PictureLayer::Kind kind = scene_->options.layer.kind;
  emission_ = (kind == PictureLayer::Kind::Beauty || kind == PictureLayer::Kind::Emission) && emits(*scene_);
}

void VolumeRenderPass::start(const shadow::Gpu& gpu) {
  const RenderOptions& o = scene_->options;
  picture_ = std::make_shared<Picture>();
  picture_->size = o.size;
  picture_->scene = scene_;
  picture_->color = gl::Texture(GL_TEXTURE_2D, GL_RGBA32F, ivec3(o.size, 1), "picture");
  picture_->layer = o.layer;
  if (seed_ && seed_->layer == o.layer)
    stretch(*seed_, *picture_);
  else
    picture_->color.clear();
  seed_.reset();
  const auto drawn = std::span(lights_.volumes()).first(lights_.drawnVolumes());
  const std::vector<residency::PixelBounds> bounds = pixelBounds(drawn, o);
  tiles_.build(o.size, bounds);
  budget_.plan(marchCost(o, drawn, bounds, tiles_.longest(), lights_), gpu.device, pauseAfter_);
  const ivec2 lo = glm::clamp(ivec2(glm::floor(o.region.min * dvec2(o.size))), ivec2(0), o.size - 1);
  const ivec2 hi = glm::clamp(ivec2(glm::ceil(o.region.max * dvec2(o.size))), lo + 1, o.size);
  cursor_ = gl::RegionCursor(hi - lo, gpu.device);
  cursor_.at = lo;
}

Result<double> VolumeRenderPass::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  const int samples = scene_->options.samples;
  if (picture_ && picture_->samples >= samples) return 1.0;  // asked again while layers beside it are made
  PILEUS_CHECK(lights_.check());
  PILEUS_TRY(residency_, set_.prepare(gpu.bricks, lights_.volumes(), ms));
  if (residency_.fraction < 1) return 0.1 * residency_.fraction;
  if (!picture_) start(gpu);
  lights_.bind(gpu.store);
  do {
    PILEUS_TRY(const bool drawn, dispatch(gpu));
    if (drawn && (++cursor_.next, cursor_.done())) {
      cursor_.next = 0;
      ++picture_->samples;
    }
  } while (picture_->samples < samples && clock.ms() < ms);
  picture_->fraction = (picture_->samples + double(cursor_.next) / cursor_.count()) / samples;
  return picture_->samples >= samples ? 1.0 : std::min(0.1 + 0.9 * picture_->fraction, 0.9999);
}

Result<bool> VolumeRenderPass::dispatch(const shadow::Gpu& gpu) {
  constexpr int kInRegisters = 4;
  constexpr std::size_t kUnrolledLights = 3;
  const RenderOptions& o = scene_->options;
  const int lights = int(lights_.lights().size()),
            unrolled = lights_.lights().size() <= kUnrolledLights ? std::max(lights, 1) : 0;
  gl::Defines defines = lights_.defines();
  defines.insert(defines.end(), {{"SHAPES", set_.shapes()},
                                 {"ACTIVE", std::clamp(tiles_.longest(), 1, kInRegisters)},
                                 {"OVERFLOW", tiles_.longest() > kInRegisters},
                                 {"LIGHTS", unrolled},
                                 {"SOLIDS", lights_.drawnSolids() > 0},
                                 {"DEPTH", o.layer.kind == PictureLayer::Kind::Depth},
                                 {"EMISSION", emission_},
                                 {"RESUME", budget_.resumes()}});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"view/volume_render.comp.glsl"}, defines));
  program->use();
  set_.bind(gpu.bricks, *program);
  tiles_.bind(*program);
  setCameraRays(*program, o);
  program->set("lightCount", std::max(lights, 1));
  program->set("solidCount", int(lights_.drawnSolids()));
  program->set("sampleIndex", picture_->samples);
  program->set("samples", o.samples);
  program->set("regionOrigin", cursor_.origin());
  program->set("regionEnd", cursor_.end());
  glBindImageTexture(IMAGE_TARGET, picture_->color.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  const ivec2 region = cursor_.end() - cursor_.origin(), groups = (region + 7) / 8;
  if (budget_.resumes()) budget_.bind(*program, region.x * region.y);
  timer_.begin();
  glDispatchCompute(GLuint(groups.x), GLuint(groups.y), 1);
  timer_.end();
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                  GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  glFinish();
  ++dispatches_;
  return !budget_.resumes() || budget_.unfinished() == 0;
}

}  // namespace pileus::view
