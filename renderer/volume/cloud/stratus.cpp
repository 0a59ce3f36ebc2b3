// Stratus and stratocumulus: a layer between two surfaces that bubbles displace; pads apart from each other,
// or a sheet.
#include <array>
#include <cmath>

#include "renderer/volume/cloud/layers.h"
#include "renderer/volume/cloud/noise.h"

namespace pileus::volume {
namespace {

constexpr int kOctaves = 6;

/// Natural logarithm of x > 0, by a series: equal on every machine.
float logarithm(double x) {
  int power = 0;
  const double m = std::frexp(x, &power);  // 0.5 .. 1
  const double t = (m - 0.75) / (m + 0.75), tt = t * t;
  double sum = 0, term = t;
  for (int k = 1; k < 24; k += 2, term *= tt) sum += term / k;
  return static_cast<float>(2.0 * sum - 0.28768207245178096 + power * 0.69314718055994531);
}

class StratusField final : public CloudField {
 public:
  explicit StratusField(const CloudParams& p)
      : size_(p.size),
        seed_(static_cast<std::uint32_t>(p.seed) * 1259u + 3u),
        density_(static_cast<float>(p.density)),
        cells_(p.genus == Genus::Stratus ? 0.0f : 0.7f),
        billow_(static_cast<float>(p.billow) / 0.6f),
        // Surfaces reach 0.4 below and above a layer of thickness 1.
        height_(static_cast<float>(p.top - p.base) * size_.y / 1.8f),
        low_(static_cast<float>(p.base) * size_.y),
        base_(low_ + 0.4f * height_) {
    const float across = std::max(size_.x, size_.z);
    pad_ = std::max(1.75f * static_cast<float>(p.breadth) * height_, across * 1e-3f);
    const float old = rise(0.45f, 1.0f, static_cast<float>(p.age));
    const float c = std::clamp(static_cast<float>(p.coverage), 0.004f, 0.996f);
    cover_ =
        (p.coverage >= 1 ? 2.0f
                         : 0.28f * logarithm(double(c) / (1.0 - double(c))) - (cells_ > 0 ? 0.22f : 0.1f)) -
        0.5f * old;
    edge_ = height_ * (0.35f + (0.07f - 0.35f) * cells_) * (0.4f + static_cast<float>(p.wisp)) *
            (1.0f + 2.0f * old);
    const float fine = 0.5f + static_cast<float>(p.detail);
    float a = 1, sum = 0;
    for (int k = 0; k < kOctaves; ++k, a *= 0.52f) {
      share_[at(k)] = k < 2 ? a : a * fine;
      sum += a;
      phase_[at(k)] =
          static_cast<float>(0.37 + p.time / (3.5 * double(pad_)) * double(bubbleSpeed(pad_)) * (1 << k));
    }
    for (float& s : share_) s /= sum;
    drift_ = static_cast<float>(p.wind * p.time);
    shear_ = static_cast<float>(p.shear);
  }

  float density(vec3 p, float voxel) const override {
    const float fade = wallFade(p, size_), high = low_ + 1.8f * height_;
    const float room = std::min(p.y - low_, high - p.y);
    if (fade <= 0 || room <= 0) return 0;
    const float y = p.y - base_;
    const vec3 m(p.x - drift_ - shear_ * y, p.y, p.z);
    const vec3 bend = 0.5f * pad_ * vectorNoise(m / (2.2f * pad_), seed_ ^ 11u);
    const vec3 q = m + vec3(bend.x, 0.12f * bend.y, bend.z);
    float n = 0, var = 0, w = pad_;
    vec3 s = q * vec3(1.0f, 1.7f, 1.35f);
    for (int k = 0; k < kOctaves; ++k, w *= 0.5f) {
      const float keep = carried(w, voxel), a = share_[at(k)];
      if (keep > 0)
        n += a * keep *
             (bubbles(s / w, seed_ + 101u + static_cast<std::uint32_t>(k), phase_[at(k)]) - kBubbleMean);
      const float lost = a * kBubbleDeviation * height_ * 1.9f * cells_;
      var += lost * lost * (1.0f - keep * keep);
      s = turned(k == 0 ? q : s);
    }
    n *= billow_;
    const float patch =
        1.6f * n + 0.7f * gradientNoise(vec3(q.x, 0.4f * q.y, q.z) / (4.5f * pad_), seed_ ^ 21u) + cover_;
    const float sheet = 1.0f + 0.25f * n;
    const float thick = height_ * (cells_ > 0 ? sheet + (1.9f * patch - sheet) * cells_
                                              : smoothMin(sheet, 3.0f * patch, 0.8f));
    const float top = 0.38f * height_ + 0.62f * thick,
                foot = 0.38f * height_ - 0.38f * thick * (1.0f - 0.2f * cells_);
    const float d = std::max(y - top, foot - y);
    const float edge = std::sqrt(edge_ * edge_ + 1.67f * voxel * voxel + 20.0f * var);
    const float shell = rise(0.5f * edge, -0.5f * edge, d);
    if (shell <= 0) return 0;
    return density_ * shell * fade * rise(0.0f, 0.15f * height_, room) *
           std::max(0.0f, 0.5f + 0.5f * std::clamp(y / height_, -0.4f, 1.0f)) *
           std::max(0.0f, 1.0f + 0.5f * n);
  }

  bool brick(vec3 first, float voxel, float* out) const override {
    return fillBrick(first, voxel, low_, low_ + 1.8f * height_, out,
                     [&](vec3 p) { return density(p, voxel); });
  }

 private:
  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }

  vec3 size_;
  std::uint32_t seed_;
  float density_;
  float cells_;  ///< 0 a sheet .. 1 pads
  float billow_;
  float height_;  ///< of the layer where it is as thick as usual
  float low_, base_;
  float pad_ = 1, cover_ = 0, edge_ = 1, drift_ = 0, shear_ = 0;
  std::array<float, kOctaves> share_{}, phase_{};
};

}  // namespace

std::unique_ptr<const CloudField> stratusField(const CloudParams& params) {
  return std::make_unique<const StratusField>(params);
}

}  // namespace pileus::volume
