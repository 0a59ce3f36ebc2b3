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
      sampled_(layerLights(*scene_), tintedApart(*scene_)) {
  const PictureLayer& layer = scene_->options.layer;
  emission_ = (layer.ofAll() || layer.kind == PictureLayer::Kind::Emission) && emits(*scene_);
}

std::size_t VolumeRenderPass::parts() const {
  return std::max<std::size_t>((lights_->lights().size() + MAX_LIGHTS - 1) / MAX_LIGHTS, 1);
}

void VolumeRenderPass::select(std::size_t part) {
  const std::size_t count = lights_->lights().size(), first = part * count / parts();
  lights_->select(first, (part + 1) * count / parts() - first);
}

Result<double> VolumeRenderPass::light(const shadow::Gpu& gpu, double ms) {
  std::optional<unsigned> set;
  if (scene_->options.samples > 1) set = unsigned(picture_ ? picture_->samples : 0);
  PILEUS_TRY(const double done, sampled_.make(gpu, set, ms));
  if (done < 1) return done;
  // A light's layer leaves the emission out, but steps as the beauty does, so that the layers add up to it.
  lights_.emplace(sampled_.lights(), scene_->volumes, scene_->solids,
                  scene_->options.layer.kind != PictureLayer::Kind::Depth);
  part_ = 0;
  return 1.0;
}

Result<void> VolumeRenderPass::start(const shadow::Gpu& gpu) {
  const RenderOptions& o = scene_->options;
  march_.list(o, *lights_);
  lightTint_ = lightDepths(*scene_, false);
  lightScale_ = lightDepths(*scene_, scatter_ != nullptr);
  if (const auto seen = backdropOf(*scene_)) PILEUS_CHECK(backdrop_.make(*seen));
  PILEUS_TRY(picture_, startPicture(scene_, seed_.get()));
  seed_.reset();
  budgets_.resize(parts());
  for (std::size_t part = 0; part < budgets_.size(); ++part) {
    select(part);
    // Few lights in registers; of many the room for them is cut into few sizes, as each is a variant.
    const int lights = std::max(int(lights_->selected().size()), 1);
    march_.plan(budgets_[part], o, *lights_, gpu.device, pauseAfter_,
                lights <= kUnrolledLights ? lights : int(std::bit_ceil(unsigned(lights))));
  }
  march_.run.cursor = startRegions(o, gpu.device);
  return {};
}

Scattering VolumeRenderPass::scattering() const {
  const PictureLayer::Kind kind = scene_->options.layer.kind;
  const bool once = kind == PictureLayer::Kind::Depth || kind == PictureLayer::Kind::Single;
  return once ? Scattering::Single : scene_->options.scatter.kind;
}

Result<double> VolumeRenderPass::solve(const shadow::Gpu& gpu, double ms) {
  if (scattering() != Scattering::Grid) return 1.0;
  if (!scatter_) scatter_ = std::make_unique<ScatterSolve>(scene_, scatterCache_, sampled_);
  return scatter_->step(gpu, ms);
}

std::string VolumeRenderPass::doing() const {
  return solved_ < 1 ? "Solving for scattered light"
         : !lights_  ? "Making maps of the environment"
                     : "Uploading bricks";
}

double VolumeRenderPass::progress() const {
  if (!picture_) return 0.1 * (0.5 * solved_ + 0.25 * lit_ + (lights_ ? 0.25 * residency_.fraction : 0));
  return std::min(0.1 + 0.9 * picture_->fraction, 0.9999);
}

Result<double> VolumeRenderPass::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  const int samples = scene_->options.samples;
  if (picture_ && picture_->samples >= samples) return 1.0;  // asked again while layers beside it are made
  bool ready = false;
  gl::RegionCursor& cursor = march_.run.cursor;
  do {
    const double left = std::max(ms - clock.ms(), 0.0);
    if (solved_ < 1) {
      PILEUS_TRY(solved_, solve(gpu, left));
      if (solved_ < 1) break;
    }
    if (!lights_) {
      PILEUS_TRY(lit_, light(gpu, left));
      if (lit_ < 1) break;
      ready = false;
    }
    if (!ready) {
      PILEUS_TRY(residency_, march_.prepare(gpu, scene_->options, *lights_, left));
      if (residency_.fraction < 1) break;
      if (!picture_) PILEUS_CHECK(start(gpu));
    }
    // Maps may have moved since, and other lights are taken behind a part.
    if (!ready || parts() > 1) {
      select(part_);
      PILEUS_CHECK(lights_->bind(gpu.store, march_.run.table(), march_.run.origin()));
    }
    ready = true;
    PILEUS_TRY(const bool drawn, dispatch(gpu));
    if (!drawn || ++part_ < parts()) continue;
    part_ = 0;
    march_.run.advance();
    if (cursor.done()) {
      cursor.restart();
      ++picture_->samples;
      if (sampled_.vary() && picture_->samples < samples) lights_.reset(), lit_ = 0;
    }
  } while ((!picture_ || picture_->samples < samples) && clock.ms() < ms);
  if (!picture_) return progress();
  // Of a sample that makes maps they are taken for half.
  const bool done = picture_->samples >= samples;
  const double half = sampled_.vary() ? 0.5 : 0;
  const double within = done ? 0 : half * lit_ + (1 - half) * cursor.fraction();
  picture_->fraction = (picture_->samples + within) / samples;
  picture_->besideMs = sampled_.ms() + (scatter_ ? scatter_->ms() : 0);
  return done ? 1.0 : progress();
}

Result<bool> VolumeRenderPass::dispatch(const shadow::Gpu& gpu) {
  const RenderOptions& o = scene_->options;
  residency::MarchBudget& budget = budgets_[part_];
  const int lights = std::max(int(lights_->selected().size()), 1);
  const bool depth = o.layer.kind == PictureLayer::Kind::Depth, first = part_ == 0;
  const bool colors = !depth && tinted(scene_->volumes);
  const int octaves = scattering() == Scattering::Octaves ? kOctaves : 1;
  PILEUS_TRY(gl::Program * program, march_.bind(gpu, "view/volume_render.comp.glsl", o, *lights_, budget,
                                                {{"LIGHTS", lights <= kUnrolledLights ? lights : 0},
                                                 {"DEPTH", depth},
                                                 {"BACKDROP", first && !backdrop_.empty()},
                                                 {"TINTED", colors},
                                                 {"SCATTER_GRID", scatter_ != nullptr},
                                                 {"OCTAVES", octaves},
                                                 {"MULTIPLE", o.layer.kind == PictureLayer::Kind::Multiple},
                                                 {"EMISSION", first && emission_}}));
  program->set("lightTint", lightTint_);
  program->set("lightScale", lightScale_);
  if (scatter_) scatter_->field()->bind(*program, march_.run.origin());
  if (first && !backdrop_.empty()) backdrop_.bind(*program);
  program->set("lightCount", lights);
  program->set("sampleIndex", picture_->samples);
  program->set("samples", o.samples);
  program->set("morePart", int(!first));
  glBindImageTexture(IMAGE_TARGET, picture_->color.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  return march_.run.dispatch(*program, &budget);
}

}  // namespace pileus::view
