#include "renderer/view/path_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/path.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/view/camera_march.h"
#include "renderer/view/picture_start.h"

namespace pileus::view {
namespace {

/// A round gives each pixel of a region so many samples, once there is a first one.
constexpr int kRound = 8;
/// Loop iterations of a pixel in a dispatch: 8 lanes that never wait for the same loop stay below what
/// llvmpipe runs (residency::MarchBudget).
constexpr int kWork = 3500;
constexpr int kHead = 16;  ///< bytes of the counters in front of the states

/// The parts of a soft sun are one again, of which paths choose directions: behind the first one's map, which
/// is next to the middle.
void joinDiscs(std::vector<shadow::ShadowedLight>& lights) {
  std::vector<shadow::ShadowedLight> out;
  for (shadow::ShadowedLight& l : lights) {
    const bool part = l.light.kind == scene::LightKind::Sun && l.light.angle > 0 && l.light.disc != dvec3(0);
    if (part) l.light.towards = l.light.disc;
    const bool more = part && !out.empty() && out.back().light.disc == l.light.disc &&
                      out.back().light.angle == l.light.angle;
    if (more)
      out.back().light.emitted += l.light.emitted;
    else
      out.push_back(std::move(l));
  }
  lights = std::move(out);
}

/// A light without a shadow of its own gets that of what is drawn: light does not go through a cloud because
/// nobody asked for a map. Environments are traced.
std::vector<shadow::ShadowedLight> shadowed(const RenderScene& scene) {
  std::vector<shadow::ShadowedLight> out = layerLights(scene);
  std::erase_if(out,
                [](const shadow::ShadowedLight& l) { return l.light.kind == scene::LightKind::Environment; });
  joinDiscs(out);
  for (shadow::ShadowedLight& l : out)
    if (!l.shadow) l.shadow = shadow::marchedShadow(l.light, scene.volumes, scene.solids);
  return out;
}

/// From sums over the pixels that count: of their means, their squared deviations, and how many they are.
void conclude(const dvec3& sums, PathStatistics& out) {
  if (sums.z == 0) return;
  const double n = out.samples;
  out.mean = sums.x / sums.z;
  out.standardError = n > 1 ? std::sqrt(sums.y / sums.z / (n * (n - 1))) : 0;
}

std::shared_ptr<const RenderScene> traced(RenderScene scene, int bounces) {
  scene.bounces = bounces;
  return std::make_shared<const RenderScene>(std::move(scene));
}

}  // namespace

PathTracePass::PathTracePass(RenderScene scene, const PathOptions& options)
    : scene_(traced(std::move(scene), options.bounces)),
      options_(options),
      lights_(shadowed(*scene_), scene_->volumes, scene_->solids,
              scene_->options.layer.kind != PictureLayer::Kind::Depth, LightSet::Casters::All) {
  using Kind = PictureLayer::Kind;
  const PictureLayer& layer = scene_->options.layer;
  emission_ = (layer.ofAll() || layer.kind == Kind::Emission) && emits(*scene_);
  if (layer.kind == Kind::Single) options_.orders.y = 0;
  if (layer.kind == Kind::Multiple) options_.orders.x = 1;
}

Result<void> PathTracePass::start(const shadow::Gpu& gpu) {
  const RenderOptions& o = scene_->options;
  const auto texture = [&](const char* label) {
    return gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(o.size, 1), label);
  };
  PILEUS_TRY(deviations_, texture("deviations"));
  PILEUS_TRY(odd_, texture("odd samples"));
  deviations_.clear();
  odd_.clear();
  PILEUS_TRY(picture_, startPicture(scene_, seed_.get()));
  seed_.reset();
  // Lists of volumes instead of tiles of the picture: all that are drawn, then what casts each light's
  // shadows.
  std::vector<std::vector<int>> lists(1 + lights_.lights().size());
  lists[0].resize(lights_.drawnVolumes());
  std::iota(lists[0].begin(), lists[0].end(), 0);
  for (std::size_t l = 1; l < lists.size(); ++l) {
    const std::span<const int> casters = lights_.castersOf(l - 1);
    lists[l].assign(casters.begin(), casters.end());
  }
  run_.list(lists);
  if (const auto traced = layerEnvironment(*scene_)) PILEUS_CHECK(environment_.make(*traced));
  if (const auto seen = backdropOf(*scene_)) PILEUS_CHECK(backdrop_.make(*seen));
  run_.cursor = startRegions(o, gpu.device);
  const int work = options_.workPerDispatch > 0 ? options_.workPerDispatch : kWork;
  pace_ = {work, work, work};
  if (!gpu.device.software && options_.workPerDispatch <= 0) pace_.least = 256, pace_.most = 1 << 16;
  return {};
}

int PathTracePass::roundEnd() const {
  const int done = picture_->samples, most = scene_->options.samples;
  return std::min(most, done == 0 ? 1 : done < kRound ? 2 * done : done + kRound);
}

Result<bool> PathTracePass::enough(const shadow::Gpu& gpu) {
  if (picture_->samples >= scene_->options.samples) return true;
  if (options_.seconds > 0 && spentMs_ > 1e3 * options_.seconds) return endedByTime_ = true;
  if (options_.noise > 0 && picture_->samples >= 16) {
    PILEUS_TRY(const PathStatistics s, noise(gpu));
    return s.mean > 0 && s.standardError <= options_.noise * s.mean;
  }
  return false;
}

void PathTracePass::finish() {
  done_ = true;
  const PathStatistics s = statistics();
  picture_->metadata["pathTrace:bounces"] = std::to_string(options_.bounces);
  picture_->metadata["pathTrace:samples"] = std::to_string(s.samples);
  picture_->metadata["pathTrace:standardError"] = fmt::format("{:.6g}", s.standardError);
  picture_->metadata["pathTrace:endedBy"] = endedByTime_                          ? "time"
                                            : s.samples < scene_->options.samples ? "noise"
                                                                                  : "samples";
}

Result<double> PathTracePass::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  if (done_) return 1.0;
  PILEUS_TRY(residency_, run_.prepare(gpu.bricks, lights_.volumes(), ms, originOf(scene_->options, lights_)));
  if (residency_.fraction < 1) return 0.1 * residency_.fraction;
  if (!picture_) PILEUS_CHECK(start(gpu));
  if (majorantsFor_ != gpu.bricks.generation()) {
    PILEUS_CHECK(majorants_.make(lights_.volumes(), gpu.bricks, gpu.device, options_.majorantScale));
    majorantsFor_ = gpu.bricks.generation();
  }
  PILEUS_CHECK(lights_.bind(gpu.store, run_.table(), run_.origin()));
  const Stopwatch work;
  do {
    PILEUS_TRY(const bool drawn, dispatch(gpu));
    if (!drawn) continue;
    run_.advance();
    if (!run_.cursor.done()) continue;
    run_.cursor.restart();
    picture_->samples = roundEnd();
    PILEUS_TRY(const bool ends, enough(gpu));
    if (ends) {
      finish();
      break;
    }
  } while (clock.ms() < ms);
  spentMs_ += work.ms();
  const int samples = scene_->options.samples, next = done_ ? picture_->samples : roundEnd();
  picture_->fraction =
      done_ ? 1.0
            : std::min(0.9999, (picture_->samples + run_.cursor.fraction() * (next - picture_->samples)) /
                                   double(samples));
  if (!done_ && options_.seconds > 0)
    picture_->fraction = std::clamp(spentMs_ / (1e3 * options_.seconds), picture_->fraction, 0.9999);
  return done_ ? 1.0 : std::min(0.1 + 0.9 * picture_->fraction, 0.9999);
}

Result<bool> PathTracePass::dispatch(const shadow::Gpu& gpu) {
  const RenderOptions& o = scene_->options;
  gl::Defines defines = lights_.defines();
  const auto add = [&](const gl::Defines& more) { defines.insert(defines.end(), more.begin(), more.end()); };
  const bool environment = !environment_.empty(), along = options_.alongRays && lights_.anyInside();
  add(run_.defines());
  add({{"SOLIDS", lights_.drawnSolids() > 0},
       {"ENVIRONMENT", environment},
       {"BACKDROP", !backdrop_.empty()},
       {"TINTED", tinted(lights_.volumes())},
       {"EMISSION", emission_},
       {"TRANSMITTANCE",
        options_.transmittance == ShadowEstimate::Series ? TRANSMITTANCE_SERIES : TRANSMITTANCE_RATIO},
       {"DISCS", lights_.anyDisc()},
       {"ALONG", along},
       {"ORDER", options_.orders.x > 0 || options_.orders.y < (1 << 30)}});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"view/path_trace.comp.glsl"}, defines));
  PILEUS_CHECK(run_.bind(gpu.bricks, *program));
  setCamera(*program, o, run_.origin());
  majorants_.bind();
  if (environment) environment_.bind(*program);
  if (!backdrop_.empty()) backdrop_.bind(*program);
  if (along) {
    program->set("mediaMin", vec3(lights_.drawnBounds().min - run_.origin()));
    program->set("mediaMax", vec3(lights_.drawnBounds().max - run_.origin()));
  }
  program->set("lightCount", int(lights_.lights().size()));
  program->set("solidCount", int(lights_.drawnSolids()));
  program->set("sampleRange", ivec2(picture_->samples, roundEnd()));
  program->set("mostBounces", options_.bounces);
  program->set("orders", options_.orders);
  program->set("firstPath", options_.firstPath);
  program->set("chances", vec2(float(options_.unshadowedShare), float(options_.mapFactor)));
  const double sky = options_.skyChoice < 0 ? environment_.contrast() : options_.skyChoice;
  program->set("skyFactor", float(sky));
  program->set("pathDispatch", dispatched_++);
  program->set("pathBudget", pace_.now);
  const ivec2 from = run_.cursor.origin(), to = run_.cursor.end(), extent = to - from;
  PILEUS_CHECK(states_.reserve(kHead + std::size_t(extent.x) * std::size_t(extent.y) * PATH_STATE_BYTES));
  const ivec4 none(0);
  glNamedBufferSubData(states_.id(), 0, sizeof none, &none);
  states_.bindStorage(BIND_PATH_STATES);
  glBindImageTexture(IMAGE_MEAN, picture_->color.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  glBindImageTexture(IMAGE_DEVIATIONS, deviations_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  glBindImageTexture(IMAGE_ODD, odd_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  const Stopwatch clock;
  PILEUS_CHECK(run_.dispatch(*program, from, to));
  pace_.took(clock.ms());
  ivec4 counts;
  glGetNamedBufferSubData(states_.id(), 0, sizeof counts, &counts);
  violations_ += counts.y, endless_ += counts.z;
  if (counts.x > 0) return false;
  dispatched_ = 0;
  return true;
}

PathStatistics PathTracePass::statistics() const {
  PathStatistics out{picture_ ? picture_->samples : 0, 0, 0, violations_, endless_};
  if (out.samples == 0) return out;
  const auto pixels = std::size_t(picture_->size.x) * std::size_t(picture_->size.y);
  std::vector<vec4> mean(pixels), deviations(pixels);
  gl::readTexels(picture_->color, GL_RGBA, 4, &mean[0].x);
  gl::readTexels(deviations_, GL_RGBA, 4, &deviations[0].x);
  dvec3 sums(0);
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!(mean[i].a > 0.01f)) continue;
    ++sums.z;
    for (int c = 0; c < 3; ++c) sums.x += double(mean[i][c]) / 3, sums.y += double(deviations[i][c]) / 3;
  }
  conclude(sums, out);
  return out;
}

Result<PathStatistics> PathTracePass::noise(const shadow::Gpu& gpu) {
  PathStatistics out{picture_ ? picture_->samples : 0};
  if (out.samples == 0) return out;
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"view/path_noise.comp.glsl"}));
  const std::size_t pixels = std::size_t(picture_->size.x) * std::size_t(picture_->size.y);
  std::vector<vec4> parts((pixels + PATH_NOISE_PIXELS - 1) / PATH_NOISE_PIXELS);
  PILEUS_CHECK(sums_.reserve(parts.size() * sizeof(vec4)));
  program->use();
  program->set("size", picture_->size);
  sums_.bindStorage(BIND_PATH_STATES);
  glBindImageTexture(IMAGE_MEAN, picture_->color.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindImageTexture(IMAGE_DEVIATIONS, deviations_.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
  glDispatchCompute(GLuint((parts.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(sums_.id(), 0, GLsizeiptr(parts.size() * sizeof(vec4)), parts.data());
  dvec3 sums(0);
  for (const vec4& part : parts) sums += dvec3(part);
  conclude(sums, out);
  return out;
}

Result<std::shared_ptr<const Picture>> PathTracePass::variance() const {
  auto out = std::make_shared<Picture>();
  out->size = picture_->size, out->samples = picture_->samples, out->fraction = picture_->fraction;
  PILEUS_TRY(out->color,
             gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(picture_->size, 1), "variance"));
  const auto pixels = std::size_t(picture_->size.x) * std::size_t(picture_->size.y);
  std::vector<vec4> texels(pixels);
  gl::readTexels(deviations_, GL_RGBA, 4, &texels[0].x);
  const double n = picture_->samples, by = n > 1 ? 1 / (n * (n - 1)) : 0;
  for (vec4& t : texels) t *= float(by);
  glTextureSubImage2D(out->color.id(), 0, 0, 0, out->size.x, out->size.y, GL_RGBA, GL_FLOAT, texels.data());
  return std::shared_ptr<const Picture>(std::move(out));
}

Result<std::array<image::Image, 2>> PathTracePass::halves() const {
  const int samples = picture_ ? picture_->samples : 0;
  if (samples < 2) return fail(Code::Internal, "halves of {} samples", samples);
  PILEUS_TRY(image::Image all, readBack(*picture_));
  image::Image odd = all, even = all;
  odd.layers.resize(1), even.layers.resize(1);
  std::vector<float>& o = odd.layers[0].pixels;
  gl::readTexels(odd_, GL_RGBA, 4, o.data());
  const double inOdd = samples / 2, inEven = samples - samples / 2;
  for (std::size_t i = 0; i < o.size(); ++i)
    even.layers[0].pixels[i] =
        float((double(all.layers[0].pixels[i]) * samples - double(o[i]) * inOdd) / inEven);
  return std::array{std::move(even), std::move(odd)};
}

}  // namespace pileus::view
