#include "renderer/view/sampled_lights.h"

#include <algorithm>

#include "renderer/base/profile.h"
#include "renderer/scene/environment_strata.h"

namespace pileus::view {
namespace {

bool isEnvironment(const shadow::ShadowedLight& l) { return l.light.kind == scene::LightKind::Environment; }

/// The media as they are to a channel.
volume::InstanceList seenBy(int channel, volume::InstanceList volumes) {
  for (volume::Instance& i : volumes) {
    i.medium.extinction *= double(i.medium.extinctionColor[channel]);
    i.medium.extinctionColor = vec3(1);
  }
  return volumes;
}

}  // namespace

SampledLights::SampledLights(const std::vector<shadow::ShadowedLight>& lights, bool byChannel) {
  for (const shadow::ShadowedLight& l : lights) {
    const auto strata = isEnvironment(l) ? scene::strataOf(*l.light.environment) : nullptr;
    const bool apart = byChannel && l.shadow;
    for (int c = 0; c < (apart ? 3 : 1); ++c) {
      Asked one{l, vec3(1), strata && l.shadow};
      if (apart) {
        const shadow::ShadowMap& as = *l.shadow;
        one.mask = vec3(0), one.mask[c] = 1;
        one.made = true;
        one.light.shadow = shadow::describedShadow(as.spec, l.light, seenBy(c, as.volumes), as.solids);
      }
      all_.push_back(std::move(one));
      strata_.push_back(strata);
    }
  }
}

bool SampledLights::vary() const {
  return std::any_of(strata_.begin(), strata_.end(), [](const auto& s) { return s != nullptr; });
}

void SampledLights::plan(std::optional<unsigned> set) {
  pass_.reset();
  lights_.clear();
  planned_.clear();
  set_.emplace(set);
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const auto& [l, mask, made] = all_[i];
    std::vector<scene::Light> lights{l.light};
    if (strata_[i]) lights = scene::standIns(*l.light.environment, *strata_[i], set);
    for (scene::Light& light : lights) {
      light.emitted *= mask;
      planned_.push_back({light, l.shadow, made});
    }
  }
}

KeptSuns SampledLights::kept() const {
  KeptSuns out;
  auto next = lights_.begin();
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const std::size_t count = strata_[i] ? strata_[i]->strata().size() : 1;
    if (strata_[i]) out.of.emplace_back(all_[i].light.light.environment, all_[i].light.shadow);
    for (std::size_t k = 0; k < count && next != lights_.end(); ++k, ++next)
      if (strata_[i]) out.lights.push_back(*next);
  }
  return out;
}

bool SampledLights::takeKept() {
  // Shadows by channel are this one's own.
  for (std::size_t i = 0; i < all_.size(); ++i)
    if (all_[i].made && !strata_[i]) return false;
  if (!kept_ || kept_->of != kept().of) return false;
  auto next = kept_->lights.begin();
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const std::ptrdiff_t count = strata_[i] ? std::ptrdiff_t(strata_[i]->strata().size()) : 0;
    if (!strata_[i]) lights_.push_back(all_[i].light);
    lights_.insert(lights_.end(), next, next + count);
    next += count;
  }
  return true;
}

/// True once one more of the lights is there.
Result<bool> SampledLights::makeNext(const shadow::Gpu& gpu, double ms) {
  const Planned& next = planned_[lights_.size()];
  if (!next.made) {
    lights_.push_back({next.light, next.shadow});
    return true;
  }
  const shadow::ShadowMap& as = *next.shadow;
  if (!pass_) pass_ = std::make_unique<shadow::ShadowPass>(as.spec, next.light, as.volumes, as.solids);
  PILEUS_TRY(part_, pass_->step(gpu, ms));
  gpuMs_ += pass_->takeGpuMs();
  if (part_ < 1) return false;
  lights_.push_back({next.light, pass_->map()});
  pass_.reset();
  part_ = 0;
  return true;
}

Result<double> SampledLights::make(const shadow::Gpu& gpu, std::optional<unsigned> set, double ms) {
  const Stopwatch clock;
  if (!vary()) set.reset();
  if (!set_ || *set_ != set) {
    plan(set);
    if (vary() && !set && takeKept()) return 1.0;
  }
  if (lights_.size() == planned_.size()) return 1.0;
  while (lights_.size() < planned_.size()) {
    PILEUS_TRY(const bool there, makeNext(gpu, std::max(ms - clock.ms(), 0.0)));
    if (!there || clock.ms() >= ms) break;
  }
  ms_ += clock.ms();
  if (lights_.size() < planned_.size())
    return std::min((double(lights_.size()) + part_) / double(planned_.size()), 0.9999);
  if (vary() && !set && kept_) *kept_ = kept();
  return 1.0;
}

std::size_t SampledLights::bytes() const {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < lights_.size(); ++i)
    if (planned_[i].made && lights_[i].shadow) sum += lights_[i].shadow->bytes();
  return sum;
}

}  // namespace pileus::view
