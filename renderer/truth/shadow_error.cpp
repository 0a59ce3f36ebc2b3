#include "renderer/truth/shadow_error.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shaders/shared/compare.h"

namespace pileus::truth {
namespace {

constexpr int kRows = 16;         // of a region
constexpr double kRegionMs = 12;  // wanted: a dispatch cannot be interrupted

}  // namespace

ShadowErrorPass::ShadowErrorPass(const view::RenderScene& scene, const view::RenderScene& truth,
                                 int pairsAtOnce)
    : options_(scene.options),
      volumes_(scene.volumes),
      solids_(scene.solids),
      mapped_(scene.lights),
      truth_(truth.lights),
      pairsAtOnce_(pairsAtOnce) {
  if (std::none_of(scene.lights.begin(), scene.lights.end(), [](const auto& l) { return l.shadow; }))
    fraction_ = 1;
}

Result<bool> ShadowErrorPass::pairUp(const shadow::Gpu& gpu, double ms) {
  if (!groups_.empty()) return true;
  PILEUS_TRY(const double mapped, mapped_.make(gpu, std::nullopt, ms));
  PILEUS_TRY(const double truth, truth_.make(gpu, std::nullopt, ms));
  if (mapped < 1 || truth < 1) return false;
  std::vector<shadow::ShadowedLight> pairs;
  const auto close = [&] {
    if (!pairs.empty()) groups_.emplace_back(std::exchange(pairs, {}), volumes_, solids_);
  };
  for (std::size_t i = 0; i < mapped_.lights().size(); ++i) {
    if (!mapped_.lights()[i].shadow) continue;
    pairs.push_back(mapped_.lights()[i]);
    pairs.push_back(truth_.lights()[i]);
    if (pairs.size() == 2 * std::size_t(pairsAtOnce_)) close();
  }
  close();
  if (groups_.empty()) fraction_ = 1;  // black environments
  return true;
}

Result<void> ShadowErrorPass::start(const gl::DeviceInfo& device) {
  march_.list(options_, groups_.front());
  PILEUS_CHECK(clearBins());
  const auto made = [&] {
    return gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(options_.size, 1), "shadow error");
  };
  PILEUS_TRY(gl::Texture transmittances, made());
  PILEUS_TRY(gl::Texture errors, made());
  for (gl::Texture* t : {&errors, &transmittances}) {
    t->clear();
    t->filter(GL_NEAREST);
  }
  budgets_.resize(groups_.size());
  for (std::size_t i = 0; i < groups_.size(); ++i)
    march_.plan(budgets_[i], options_, groups_[i], device, pauseAfter_);
  errors_ = std::move(errors), transmittances_ = std::move(transmittances);
  return {};
}

Result<void> ShadowErrorPass::clearBins() {
  const std::vector<unsigned> zero(ERROR_BINS, 0u);
  return bins_.assign(std::span<const unsigned>(zero));
}

Result<double> ShadowErrorPass::step(const shadow::Gpu& gpu, double ms) {
  if (fraction_ >= 1) return 1.0;
  const Stopwatch clock;
  PILEUS_TRY(const bool paired, pairUp(gpu, ms));
  if (!paired) return fraction_;
  while (fraction_ < 1) {
    const ivec2 from = next_, to = glm::min(from + ivec2(width_, kRows), options_.size);
    const Stopwatch region;
    for (; group_ < groups_.size(); ++group_) {
      view::LightSet& group = groups_[group_];
      PILEUS_TRY(const residency::Residency residency, march_.prepare(gpu, options_, group, ms));
      if (residency.fraction < 1) return fraction_;  // the groups before it have added their part
      if (!errors_) PILEUS_CHECK(start(gpu.device));
      PILEUS_CHECK(draw(gpu, group, budgets_[group_], from, to));
    }
    group_ = 0;
    PILEUS_CHECK(collect(from, to));
    const double took = region.ms();
    if (took < 0.5 * kRegionMs) width_ = std::min(2 * width_, 4096);
    if (took > 2 * kRegionMs) width_ = std::max(width_ / 2, 8);
    next_ = to.x < options_.size.x ? ivec2(to.x, from.y) : ivec2(0, to.y);
    const int rows = std::min(kRows, options_.size.y - next_.y);  // the last strip may be lower
    fraction_ =
        rows <= 0 ? 1.0 : (next_.y + static_cast<double>(rows * next_.x) / options_.size.x) / options_.size.y;
    if (clock.ms() >= ms) break;
  }
  return fraction_;
}

Result<void> ShadowErrorPass::draw(const shadow::Gpu& gpu, view::LightSet& lights,
                                   residency::MarchBudget& budget, ivec2 from, ivec2 to) {
  PILEUS_CHECK(lights.bind(gpu.store, march_.run.table(), march_.run.origin()));
  PILEUS_TRY(gl::Program * program,
             march_.bind(gpu, "truth/shadow_error.comp.glsl", options_, lights, budget));
  program->set("pairCount", static_cast<int>(lights.lights().size() / 2));
  bins_.bindStorage(BIND_ERROR_BINS);
  glBindImageTexture(IMAGE_ERROR, errors_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  glBindImageTexture(IMAGE_TRANSMITTANCE, transmittances_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  for (bool drawn = false; !drawn;) {
    PILEUS_TRY(drawn, march_.run.dispatch(*program, from, to, &budget));
  }
  return {};
}

Result<void> ShadowErrorPass::collect(ivec2 from, ivec2 to) {
  const ivec2 size = to - from;
  std::vector<vec4> error(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)),
      seen(error.size());
  const auto read = [&](const gl::Texture& texture, std::vector<vec4>& into) {
    glGetTextureSubImage(texture.id(), 0, from.x, from.y, 0, size.x, size.y, 1, GL_RGBA, GL_FLOAT,
                         static_cast<GLsizei>(into.size() * sizeof(vec4)), into.data());
  };
  read(errors_, error);
  read(transmittances_, seen);
  for (std::size_t i = 0; i < error.size(); ++i) {
    const vec4 e = error[i];
    sum_ += static_cast<double>(e.y);
    samples_ += static_cast<double>(e.w);
    maximum_ = std::max(maximum_, static_cast<double>(std::abs(e.z)));
    (e.x > 0 ? leak_ : dark_) += static_cast<double>(std::abs(e.x));
    seen_ += static_cast<double>(seen[i].z);
  }
  std::vector<unsigned> bins(ERROR_BINS);
  glGetNamedBufferSubData(bins_.id(), 0, static_cast<GLsizeiptr>(bins.size() * sizeof(unsigned)),
                          bins.data());
  histogram_.add(bins);
  return clearBins();
}

void ErrorHistogram::add(std::span<const unsigned> bins) {
  bins_.resize(std::max(bins_.size(), bins.size()), 0);
  for (std::size_t i = 0; i < bins.size(); ++i) bins_[i] += bins[i];
}

double ErrorHistogram::quantile(double q, double maximum) const {
  double all = 0, below = 0;
  for (const std::uint64_t n : bins_) all += static_cast<double>(n);
  if (all == 0) return 0;
  const double wanted = q * all;
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    const auto n = static_cast<double>(bins_[i]);
    if (n == 0 || below + n < wanted) {
      below += n;
      continue;
    }
    if (i == 0) return 0;
    const double within = (wanted - below) / n;
    const double decades = (static_cast<double>(i - 1) + within) * ERROR_DECADES / (ERROR_BINS - 1);
    return std::min(ERROR_LEAST * std::pow(10.0, decades), maximum);
  }
  return maximum;
}

}  // namespace pileus::truth
