#include "renderer/view/volume_render.h"

#include <algorithm>
#include <bit>

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/view/picture_start.h"

namespace pileus::view {

namespace {

constexpr int kUnrolledLights = 3;
constexpr int kOctaves = 8;

}  // namespace

VolumeRenderPass::VolumeRenderPass(RenderScene scene)
    : scene_(std::make_shared<const RenderScene>(std::move(scene))),
      // A light's layer leaves the emission out, but steps as the beauty does, so that the layers add up to
      // it.
      lights_(layerLights(*scene_), scene_->volumes, scene_->solids,
              scene_->options.layer.kind != PictureLayer::Kind::Depth) {
  const PictureLayer::Kind kind = scene_->options.layer.kind;
  emission_ = (kind == PictureLayer::Kind::Beauty || kind == PictureLayer::Kind::Emission) && emits(*scene_);
}

Result<void> VolumeRenderPass::start(const shadow::Gpu& gpu) {
  const RenderOptions& o = scene_->options;
  march_.list(o, lights_);
  if (const auto seen = backdropOf(*scene_)) PILEUS_CHECK(backdrop_.make(*seen));
  PILEUS_TRY(picture_, startPicture(scene_, seed_.get()));
  seed_.reset();
  // Few lights in registers; of many the room for them is cut into few sizes, as each is a variant.
  const int lights = std::max(int(lights_.lights().size()), 1);
  march_.plan(budget_, o, lights_, gpu.device, pauseAfter_,
              lights <= kUnrolledLights ? lights : int(std::bit_ceil(unsigned(lights))));
  march_.run.cursor = startRegions(o, gpu.device);
  return {};
}

Result<double> VolumeRenderPass::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  const int samples = scene_->options.samples;
  if (picture_ && picture_->samples >= samples) return 1.0;  // asked again while layers beside it are made
  PILEUS_CHECK(lights_.check());
  PILEUS_TRY(residency_, march_.prepare(gpu, scene_->options, lights_, ms));
  if (residency_.fraction < 1) return 0.1 * residency_.fraction;
  const bool grid = scene_->options.scatter.kind == Scattering::Grid &&
                    scene_->options.layer.kind != PictureLayer::Kind::Depth;
  if (grid) {
    if (!scatter_) scatter_ = std::make_unique<ScatterSolve>(scene_, scatterCache_);
    PILEUS_TRY(const double solved, scatter_->step(gpu, ms));
    if (solved < 1) return 0.1 + 0.1 * solved;
    // Its pass has had the bricks made resident for itself.
    PILEUS_TRY(residency_, march_.prepare(gpu, scene_->options, lights_, ms));
    if (residency_.fraction < 1) return 0.1 * residency_.fraction;
  }
  if (!picture_) PILEUS_CHECK(start(gpu));
  PILEUS_CHECK(lights_.bind(gpu.store, march_.run.table(), march_.run.origin()));
  gl::RegionCursor& cursor = march_.run.cursor;
  do {
    PILEUS_TRY(const bool drawn, dispatch(gpu));
    if (!drawn) continue;
    march_.run.advance();
    if (cursor.done()) {
      cursor.restart();
      ++picture_->samples;
    }
  } while (picture_->samples < samples && clock.ms() < ms);
  picture_->fraction = (picture_->samples + cursor.fraction()) / samples;
  return picture_->samples >= samples ? 1.0 : std::min(0.1 + 0.9 * picture_->fraction, 0.9999);
}

Result<bool> VolumeRenderPass::dispatch(const shadow::Gpu& gpu) {
  const RenderOptions& o = scene_->options;
  const int lights = std::max(int(lights_.lights().size()), 1);
  const bool depth = o.layer.kind == PictureLayer::Kind::Depth;
  const int octaves = o.scatter.kind == Scattering::Octaves && !depth ? kOctaves : 1;
  PILEUS_TRY(gl::Program * program, march_.bind(gpu, "view/volume_render.comp.glsl", o, lights_, budget_,
                                                {{"LIGHTS", lights <= kUnrolledLights ? lights : 0},
                                                 {"DEPTH", depth},
                                                 {"BACKDROP", !backdrop_.empty()},
                                                 {"SCATTER_GRID", scatter_ != nullptr},
                                                 {"OCTAVES", octaves},
                                                 {"EMISSION", emission_}}));
  if (scatter_) scatter_->field()->bind(*program, march_.run.origin());
  if (!backdrop_.empty()) backdrop_.bind(*program);
  program->set("lightCount", lights);
  program->set("sampleIndex", picture_->samples);
  program->set("samples", o.samples);
  glBindImageTexture(IMAGE_TARGET, picture_->color.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  return march_.run.dispatch(*program, &budget_);
}

}  // namespace pileus::view
