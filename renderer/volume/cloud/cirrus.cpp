// Cirrus: ice that falls from patches high up and is left behind by the wind, in threads.
#include <cmath>

#include "renderer/volume/cloud/layers.h"
#include "renderer/volume/cloud/noise.h"

namespace pileus::volume {
namespace {

constexpr int kOctaves = 6;
constexpr float kMeanRidge = 0.154f;  ///< mean of |gradientNoise|

class CirrusField final : public CloudField {
 public:
  explicit CirrusField(const CloudParams& p)
      : size_(p.size),
        seed_(static_cast<std::uint32_t>(p.seed) * 1657u + 9u),
        density_(static_cast<float>(p.density)),
        coverage_(static_cast<float>(p.coverage)),
        wisp_(static_cast<float>(p.wisp)),
        billow_(static_cast<float>(p.billow) / 0.6f),
        low_(static_cast<float>(p.base) * size_.y),
        height_(static_cast<float>(p.top - p.base) * size_.y) {
    streak_ = std::max(1.2f * static_cast<float>(p.breadth) * height_, std::max(size_.x, size_.z) * 1e-3f);
    drift_ = static_cast<float>(p.wind * p.time);
    hook_ = 1.1f + 2.0f * static_cast<float>(p.shear);
    fine_ = 0.72f + 0.2f * static_cast<float>(p.detail);
    old_ = rise(0.45f, 1.0f, static_cast<float>(p.age));
  }

  float density(vec3 p, float voxel) const override {
    const float fade = wallFade(p, size_), y = (p.y - low_) / height_;
    if (fade <= 0 || y <= 0 || y >= 1) return 0;
    const float S = streak_;
    vec3 q(p.x - drift_ + hook_ * S * (1.0f - y) * (1.0f - y), p.y, p.z);
    const auto bend = [&](float x, float z, float wave, std::uint32_t salt) {
      const vec3 v = vectorNoise(q / vec3(wave * S, height_, 0.6f * wave * S), seed_ ^ salt);
      q += billow_ * S * vec3(x * v.x, 0.0f, z * v.z);
    };
    bend(0.40f, 0.34f, 1.2f, 11u);
    bend(0.10f, 0.06f, 0.45f, 12u);
    const auto noise = [&](float x, float z, std::uint32_t salt) {
      return gradientNoise({q.x / (x * S), q.y / (2.0f * height_), q.z / (z * S)}, seed_ ^ salt);
    };
    const float patch = rise(0.30f - 0.8f * coverage_, 0.95f - 0.8f * coverage_,
                             noise(1.5f, 0.7f, 21u) + 0.45f * noise(0.6f, 0.22f, 22u) - 0.3f * old_);
    if (patch <= 0) return 0;
    float n = 0, var = 0, a = 0.5f, x = 1.6f * S, z = 0.11f * S, h = 0.7f * height_;
    for (std::uint32_t k = 0; k < kOctaves; ++k) {
      const float keep = carried(2.0f * z, voxel);
      float ridge = kMeanRidge;
      if (keep > 0)
        ridge += keep * (std::abs(gradientNoise({q.x / x, q.y / h, q.z / z}, seed_ + 101u + k)) - kMeanRidge);
      n += a * (1.0f - 2.6f * ridge);
      const float lost = 2.6f * 0.118f * a;
      var += lost * lost * (1.0f - keep * keep);
      a *= fine_;
      x *= 0.62f;
      z *= 0.55f;
      h *= 0.75f;
    }
    // What is lost between the voxels widens the ramp of the threads.
    const float soft = std::sqrt(0.64f + 20.0f * var), middle = 1.05f - 0.1f * wisp_;
    const float threads = rise(middle - 0.5f * soft, middle + 0.5f * soft, n + 0.55f * (patch - 0.5f));
    const float veil = 0.12f * patch, f = veil + (threads - veil) * (0.35f + 0.65f * wisp_);
    return density_ * fade * patch * rise(0.0f, 0.35f, y) * rise(1.0f, 0.85f, y) * f * (0.25f + 0.75f * y) *
           (1.0f - 0.5f * old_);
  }

  bool brick(vec3 first, float voxel, float* out) const override {
    return fillBrick(first, voxel, low_, low_ + height_, out, [&](vec3 p) { return density(p, voxel); });
  }

 private:
  vec3 size_;
  std::uint32_t seed_;
  float density_, coverage_, wisp_, billow_;
  float low_, height_;
  float streak_ = 1, drift_ = 0, hook_ = 1, fine_ = 0.8f, old_ = 0;
};

}  // namespace

std::unique_ptr<const CloudField> cirrusField(const CloudParams& params) {
  return std::make_unique<const CirrusField>(params);
}

}  // namespace pileus::volume
