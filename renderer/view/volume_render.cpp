#include "renderer/view/volume_render.h"

#include <algorithm>

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"

namespace pileus::view {
namespace {

const scene::Light kNoLight{scene::LightKind::Sun, {0, 1, 0}, vec3(0.0f), 0};

/// Pixels each instance may touch; the whole picture where a corner is beside or behind the eye.
std::vector<residency::PixelBounds> pixelBounds(std::span<const volume::Instance> instances, const RenderOptions& o) {
  const glm::dmat3 axes = scene::basis(o.camera);
  const double th = std::tan(glm::radians(o.camera.fov) / 2), tw = th * o.size.x / o.size.y;
  std::vector<residency::PixelBounds> out;
  for (const volume::Instance& i : instances) {
    const Box3 local = volume::localBounds(i);
    dvec2 lo(1e9), hi(-1e9);
    bool near = false, front = false;
    for (int c = 0; c < 8; ++c) {
      const dvec3 p = glm::transpose(axes) * (dvec3(i.worldFromLocal * dvec4(local.corner(c), 1.0)) - o.camera.eye);
      const double depth = -p.z;
      front |= depth > 0;
      if (depth < 1e-9 * glm::length(p) + 1e-12) {
        near = true;
        continue;
      }
      const dvec2 ndc(p.x / (depth * tw), -p.y / (depth * th));
      lo = glm::min(lo, ndc), hi = glm::max(hi, ndc);
    }
    if (near) out.push_back(front ? residency::PixelBounds{ivec2(0), o.size} : residency::PixelBounds{});
    else {
      const dvec2 size(o.size);
      out.push_back({ivec2(glm::floor(glm::clamp((lo * 0.5 + 0.5) * size - 1.0, dvec2(-1), size + 1.0))),
                     ivec2(glm::ceil(glm::clamp((hi * 0.5 + 0.5) * size + 1.0, dvec2(-1), size + 1.0)))});
    }
  }
  return out;
}

}  // namespace

VolumeRenderPass::VolumeRenderPass(const RenderOptions& options, const volume::InstanceList& volumes, std::vector<shadow::ShadowedLight> lights)
    : options_(options), all_(residency::canonical(volumes)), drawn_(all_.size()), lights_(std::move(lights)) {
  for (const shadow::ShadowedLight& l : lights_) {
    const int first = int(shadowItems_.size());
    if (l.shadow && l.shadow->kind == shadow::ShadowMap::Kind::RayMarch) {
      for (const volume::Instance& i : residency::canonical(l.shadow->volumes)) {
        const Key key = volume::contentKey({i});
        std::size_t at = 0;
        while (at < all_.size() && volume::contentKey({all_[at]}) != key) ++at;
        if (at == all_.size()) all_.push_back(i);
        shadowItems_.push_back(int(at));
      }
    }
    marched_.push_back({first, int(shadowItems_.size()) - first});
  }
}

void VolumeRenderPass::start(const shadow::Gpu& gpu) {
  picture_ = std::make_shared<Picture>();
  picture_->size = options_.size;
  picture_->color = gl::Texture(GL_TEXTURE_2D, GL_RGBA32F, ivec3(options_.size, 1), "picture");
  picture_->color.clear();
  tiles_.build(options_.size, pixelBounds(std::span(all_).first(drawn_), options_));
  items_.assign(std::span<const int>(shadowItems_));
  cursor_ = gl::RegionCursor(options_.size, gpu.device);
}

Result<double> VolumeRenderPass::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  if (lights_.size() > MAX_LIGHTS) return fail(Code::Input, "lights: {} are linked, at most {} can be rendered together", lights_.size(), MAX_LIGHTS);
  PILEUS_TRY(residency_, set_.prepare(gpu.bricks, all_, ms));
  if (residency_.fraction < 1) return 0.1 * residency_.fraction;
  if (!picture_) start(gpu);
  std::vector<gpu::LightRecord> records;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    records.push_back(shadow::makeRecord(lights_[i].light, lights_[i].shadow.get()));
    records.back().items.y = marched_[i].x;
    records.back().items.z = marched_[i].y;
  }
  if (records.empty()) records.push_back(shadow::makeRecord(kNoLight, nullptr));
  records_.reserve(MAX_LIGHTS * sizeof(gpu::LightRecord));
  records_.assign(std::span<const gpu::LightRecord>(records));
  do {
    PILEUS_CHECK(dispatch(gpu));
    if (++cursor_.next; cursor_.done()) {
      cursor_.next = 0;
      ++picture_->samples;
    }
  } while (picture_->samples < options_.samples && clock.ms() < ms);
  picture_->fraction = (picture_->samples + double(cursor_.next) / cursor_.count()) / options_.samples;
  return picture_->samples >= options_.samples ? 1.0 : std::min(0.1 + 0.9 * picture_->fraction, 0.9999);
}

Result<void> VolumeRenderPass::dispatch(const shadow::Gpu& gpu) {
  constexpr int kInRegisters = 4;
  constexpr std::size_t kUnrolledLights = 3;
  gl::Defines defines = shadow::lookupDefines(lights_);
  defines.insert(defines.end(), {{"SHAPES", set_.shapes()}, {"ACTIVE", std::clamp(tiles_.longest(), 1, kInRegisters)}, {"OVERFLOW", tiles_.longest() > kInRegisters}, {"LIGHTS", lights_.size() <= kUnrolledLights ? std::max(int(lights_.size()), 1) : 0}});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"view/volume_render.comp.glsl"}, defines));
  program->use();
  set_.bind(gpu.bricks, *program);
  tiles_.bind(*program);
  gpu.store.bind();
  records_.bindUniform(BIND_LIGHTS);
  items_.bindTexels(UNIT_SHADOW_ITEMS, GL_R32I);
  const scene::Camera& camera = options_.camera;
  const glm::dmat3 axes = scene::basis(camera);
  const double th = std::tan(glm::radians(camera.fov) / 2);
  program->set("eye", vec3(camera.eye));
  program->set("right", vec3(axes[0] * th * (double(options_.size.x) / options_.size.y)));
  program->set("up", vec3(axes[1] * th));
  program->set("back", vec3(axes[2]));
  program->set("pixelAngle", float(2 * th / options_.size.y));
  program->set("stepScale", float(options_.stepScale));
  program->set("lightCount", std::max(int(lights_.size()), 1));
  program->set("sampleIndex", picture_->samples);
  program->set("samples", options_.samples);
  program->set("size", options_.size);
  program->set("regionOrigin", cursor_.origin());
  program->set("regionEnd", cursor_.end());
  glBindImageTexture(IMAGE_TARGET, picture_->color.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  const ivec2 groups = (cursor_.end() - cursor_.origin() + 7) / 8;
  timer_.begin();
  glDispatchCompute(GLuint(groups.x), GLuint(groups.y), 1);
  timer_.end();
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glFinish();
  return {};
}

}  // namespace pileus::view
