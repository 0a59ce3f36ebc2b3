// Cumulus: towers under round heads of several sizes, each set on the result of the last, cut level at the
// condensation level; shreds beside them and anvils on top.
#include <array>
#include <cmath>
#include <vector>

#include "renderer/volume/cloud/bubbles.h"
#include "renderer/volume/cloud/cloud_field.h"
#include "renderer/volume/cloud/cumulus_towers.h"
#include "renderer/volume/cloud/noise.h"

namespace pileus::volume {
namespace {

constexpr int kOctaves = 7;
/// Depths of the bubbles in their diameters, largest first.
constexpr std::array<float, kOctaves> kDepth = {0.52f, 0.60f, 0.70f, 0.78f, 0.82f, 0.85f, 0.85f};
constexpr float kLift = 0.64f;  ///< heads stand out by 1 - that much, crevices cut in by the rest
constexpr int kCell = 4;        ///< voxels along an edge of the blocks that share one list of towers

/// What the size of the voxels decides.
struct Level {
  float voxel;
  std::array<float, kOctaves> keep;
  float widest;  ///< of the soft edge, where a cloud dissolves
};

/// Distance to the nearest tower, and what the nearest are like, mixed by the same weights.
struct Host {
  float distance = 1e9f;
  float cloud = 1, age = 0, sheet = 0;
  float thinness = 0;  ///< 1 / half the thickness of a disc [1/m]

  /// Blends another one in over `k` metres.
  void join(const Host& other, float k) {
    const float h = std::max(k - std::abs(other.distance - distance), 0.0f) / k;
    if (h <= 0) {
      if (other.distance < distance) *this = other;
      return;
    }
    const float lesser = 0.5f * h * h, w = other.distance < distance ? 1.0f - lesser : lesser;
    distance = std::min(other.distance, distance) - 0.25f * k * h * h;
    cloud += w * (other.cloud - cloud);
    age += w * (other.age - age);
    sheet += w * (other.sheet - sheet);
    thinness += w * (other.thinness - thinness);
  }
};

/// What may touch a block.
struct Near {
  std::vector<Tower> towers;
  std::vector<Anvil> anvils;
  bool empty() const { return towers.empty() && anvils.empty(); }
};

float blendOf(const Tower& t) { return 0.25f * t.foot; }

float axisDistance(const Tower& t, vec3 q, float& along) {
  const vec3 axis = t.to - t.from, v = q - t.from;
  along = std::clamp(glm::dot(v, axis) / glm::dot(axis, axis), 0.0f, 1.0f);
  return glm::length(v - along * axis);
}

class CumulusField final : public CloudField {
 public:
  CumulusField(const CloudParams& p, JobControl& control)
      : made_(cumulusTowers(p, control)),
        size_(p.size),
        seed_(static_cast<std::uint32_t>(p.seed) * 977u + 5u),
        density_(static_cast<float>(p.density)),
        wisp_(static_cast<float>(p.wisp)),
        downwind_(p.shear < 0 ? -1.0f : 1.0f),
        room_(static_cast<float>(p.top - p.base) * size_.y),
        bubble_(made_.scale.bubble),
        base_(made_.scale.base) {
    const float b = static_cast<float>(p.billow), fine = 0.35f + 1.15f * static_cast<float>(p.detail);
    float w = bubble_;
    for (int k = 0; k < kOctaves; ++k, w *= 0.5f) {
      const float speed = bubbleSpeed(w);
      depth_[at(k)] = kDepth[at(k)] * w * b * (2.1f - 0.72f * b) * (k < 2 ? 1.0f : fine);
      phase_[at(k)] = static_cast<float>(0.37 + p.time * double(speed) / (3.5 * double(w)));
      risen_[at(k)] = static_cast<float>(p.time * double(speed));
      reach_ += 0.4f * depth_[at(k)];
    }
    edge_ = 0.018f * bubble_;
    shreds_ = wisp_ > 0 ? 0.2f * bubble_ : 0.0f;
    drift_ = static_cast<float>(0.8 * p.time);
  }

  float density(vec3 p, float voxel) const override {
    return density_ * shape(p, levelOf(voxel), made_.towers, made_.anvils);
  }

  bool brick(vec3 first, float voxel, float* out) const override;

 private:
  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }

  Level levelOf(float voxel) const {
    Level l{};
    l.voxel = voxel;
    float w = bubble_, lost = 0;
    for (int k = 0; k < kOctaves; ++k, w *= 0.5f) {
      l.keep[at(k)] = carried(w, voxel);
      const float a = depth_[at(k)] * kBubbleDeviation;
      lost += a * a * (1 - l.keep[at(k)] * l.keep[at(k)]);
    }
    l.widest = std::sqrt(100 * edge_ * edge_ + 1.67f * voxel * voxel + 20 * lost);
    return l;
  }

  vec3 warped(vec3 p) const { return p + 0.16f * bubble_ * vectorNoise(p / bubble_, seed_ ^ 31u); }
  Host anvilAt(const Anvil& a, vec3 q) const;
  float shape(vec3 p, const Level& level, const std::vector<Tower>& towers,
              const std::vector<Anvil>& anvils) const;
  float shredsAt(vec3 p, float d, float above, float age) const;
  void gather(vec3 center, float half, const Level& level, const Near* from, Near& to) const;

  CumulusTowers made_;
  vec3 size_;
  std::uint32_t seed_;
  float density_, wisp_, downwind_, room_, bubble_, base_;
  float edge_ = 1, shreds_ = 0, drift_ = 0, reach_ = 0;
  std::array<float, kOctaves> depth_{}, phase_{}, risen_{};
};

/// A disc, thick where its tower feeds it, thin and frayed at the rim.
Host CumulusField::anvilAt(const Anvil& a, vec3 q) const {
  vec2 flat(q.x - a.center.x, q.z - a.center.z);
  if (flat.x * downwind_ > 0) flat.x *= 1.0f / 1.7f;
  const float rho = glm::length(flat), unit = a.thickness / 48.0f;
  const vec3 f = q / unit;
  const float fibres = gradientNoise(f / vec3(420, 90, 110), seed_ ^ 41u) +
                       0.7f * gradientNoise(f / vec3(190, 45, 42), seed_ ^ 42u) +
                       0.4f * gradientNoise(f / vec3(90, 30, 17), seed_ ^ 43u);
  const vec2 turn = rho > 0 ? flat / rho : vec2(1, 0);
  const float uneven = gradientNoise({1.7f * turn.x, a.neck / a.radius, 1.7f * turn.y}, seed_ ^ 44u);
  const float rim = a.radius * (1.0f + 0.12f * uneven + 0.12f * fibres);
  const float out = rho / std::max(rim, 1e-6f), neck = rho / (1.2f * a.neck);
  const float feed = 1.0f / ((1.0f + neck * neck) * (1.0f + neck * neck));
  const float y = q.y - a.center.y - 0.04f * rho;
  float half = a.thickness * (1.15f - 0.95f * std::min(out, 1.0f));
  half *= y < 0 ? 1.0f + 3.0f * feed : 1.0f + 0.5f * feed;
  const float dy = std::abs(y) - half, dr = rho - rim;
  const float d = glm::length(vec2(std::max(dy, 0.0f), std::max(dr, 0.0f))) +
                  std::min(std::max(dy, dr), 0.0f) +
                  0.5f * a.thickness * std::max(0.0f, 0.2f - fibres) * rise(0.2f, 1.0f, out);
  const float sheet = rise(0.35f, 0.8f, rho / a.radius);
  return {d, 2.0f * a.neck, 0, sheet, sheet / half};
}

/// Torn, thin cloud just outside, most of it low down and round towers that dissolve.
float CumulusField::shredsAt(vec3 p, float d, float above, float age) const {
  const float unit = bubble_ / 220.0f;
  const float where = rise(-0.1f, 0.45f, gradientNoise(p / (130.0f * unit), seed_ ^ 51u) + 0.5f * age) *
                      (1.0f - 0.7f * std::clamp(above / room_, 0.0f, 1.0f));
  if (where <= 0) return 0;
  const vec3 up = p - vec3(0, drift_, 0);
  vec3 q = up + 0.8f * 46.0f * unit * vectorNoise(up / (60.0f * unit), seed_ ^ 52u);
  q += 0.35f * 46.0f * unit * vectorNoise(q / (23.0f * unit), seed_ ^ 53u);
  q /= 46.0f * unit;
  float n = 0, a = 0.62f;
  for (std::uint32_t k = 0; k < 3; ++k, a *= 0.5f) {
    n += a * (1.0f - 2.2f * std::abs(gradientNoise(q, seed_ + 61u + k)));
    q = 2.0f * turned(q);
  }
  const float f = 1.0f - std::max(0.0f, d) / shreds_;
  return 0.3f * wisp_ * where * rise(0.5f, 0.95f, n * (0.55f + 0.45f * f)) * f *
         rise(-10.0f * unit, 25.0f * unit, above);
}

float CumulusField::shape(vec3 p, const Level& level, const std::vector<Tower>& towers,
                          const std::vector<Anvil>& anvils) const {
  const vec3 outside = glm::abs(p - 0.5f * size_) - 0.5f * size_;
  const float wall = std::max({outside.x, outside.y, outside.z});
  const float above = p.y - base_, reserve = std::max(0.5f * level.widest, shreds_);
  if (wall >= 0 || above < -0.5f * level.widest - 0.1f * bubble_) return 0;
  const vec3 q = warped(p);
  Host host;
  for (const Tower& t : towers) {
    const float k = blendOf(t), limit = host.distance + k + std::max(t.foot, t.head);
    if (limit <= 0) continue;
    float along = 0;
    const float d = axisDistance(t, q, along) - (t.foot + along * (t.head - t.foot));
    if (d < host.distance + k) host.join({d, t.cloud, t.age, 0, 0}, k);
  }
  for (const Anvil& a : anvils) {
    const float k = 1.2f * a.thickness;
    if (const Host disc = anvilAt(a, q); disc.distance < host.distance + k) host.join(disc, k);
  }
  float d = host.distance, left = reach_;
  if (d > left + reserve) return 0;
  const float core = 0.3f * bubble_;
  float crown = 1, var = 0, w = bubble_;
  const float local = (0.45f + 0.55f * rise(0.0f, 0.27f * bubble_, above)) * (1.0f - 0.5f * host.age) *
                      (1.0f - 0.75f * host.sheet);
  vec3 s = q;
  vec3 up(0, 1, 0);
  for (int k = 0; k < kOctaves; ++k, w *= 0.5f) {
    if (d > left + reserve || d < -1.9f * left - core) break;
    left -= 0.4f * depth_[at(k)];
    const float amplitude = depth_[at(k)] * crown * local * std::min(1.0f, 1.2f * host.cloud / w),
                keep = level.keep[at(k)];
    if (amplitude <= 0) break;
    const std::uint32_t salt = seed_ + 101u + static_cast<std::uint32_t>(k);
    const float head =
        keep > 0
            ? kBubbleMean + keep * (bubbles((s - risen_[at(k)] * up) / w, salt, phase_[at(k)]) - kBubbleMean)
            : kBubbleMean;
    const float o = std::max(0.0f, d / amplitude), damp = 1.0f / (1.0f + 1.8f * o * o);
    d -= amplitude * (head - kLift) * damp;
    const float lost = amplitude * kBubbleDeviation * damp;
    var += lost * lost * (1.0f - keep * keep);
    crown += 0.5f * (0.3f + 0.8f * head - crown);
    s = turned(s);
    up = turned(up);
  }
  const float soft = std::max(0.7f * host.age, 0.8f * host.sheet),
              edge0 = edge_ * (1.0f + 9.0f * soft * soft);
  const float edge = std::sqrt(edge0 * edge0 + 1.67f * level.voxel * level.voxel + 20.0f * var);
  d += 0.07f * (edge * edge - edge0 * edge0) /
       (20.0f * 0.15f * host.cloud);  // a soft ball holds more than a sharp one
  const float deep = d;
  const float level0 = -above + 0.027f * bubble_ * gradientNoise(p / (0.55f * bubble_), seed_ ^ 71u);
  d = -smoothMin(-d, -level0, 0.08f * bubble_);
  d = std::max(d, wall + 0.5f * edge);
  float shell = rise(0.5f * edge, -0.5f * edge, d);
  if (host.thinness > 0) shell -= rise(0.5f * edge, -0.5f * edge, d + 2.0f / host.thinness);  // the far face
  if (shreds_ > 0 && deep > -0.5f * edge && deep < shreds_)
    shell = std::max(shell, shredsAt(p, deep, above, host.age) * rise(0.0f, 0.1f * bubble_, -wall));
  if (shell <= 0) return 0;
  return shell * (0.75f + 0.25f * rise(0.0f, 0.27f * bubble_, -deep)) *
         (0.6f + 0.4f * std::clamp(above / (0.83f * room_), 0.0f, 1.0f)) * (1.0f - 0.6f * host.sheet);
}

/// What of `from` (null: of all) can be felt within `half` of a point.
void CumulusField::gather(vec3 center, float half, const Level& level, const Near* from, Near& to) const {
  to.towers.clear();
  to.anvils.clear();
  const vec3 q = warped(center);
  const float far =
      half + std::min(0.56f * bubble_, 0.84f * half) + reach_ + std::max(0.5f * level.widest, shreds_);
  const auto addTower = [&](const Tower& t) {
    float along = 0;
    const float limit = far + std::max(t.foot, t.head) + 2.0f * blendOf(t);
    if (axisDistance(t, q, along) < limit) to.towers.push_back(t);
  };
  if (from)
    for (const Tower& t : from->towers) addTower(t);
  else
    for (const Heap& heap : made_.heaps) {
      const vec2 d = vec2(q.x, q.z) - heap.center;
      const float limit = far + 1.5f * heap.bound;
      if (glm::dot(d, d) < limit * limit)
        for (std::size_t i = heap.begin; i < heap.end; ++i) addTower(made_.towers[i]);
    }
  for (const Anvil& a : from ? from->anvils : made_.anvils) {
    const vec2 d(q.x - a.center.x, q.z - a.center.z);
    const float wide = 1.7f * 1.4f * a.radius + far + 3.0f * a.thickness;
    const float low = 5.0f * a.thickness + far, high = 0.1f * a.radius + 3.0f * a.thickness + far;
    const float y = q.y - a.center.y;
    if (glm::dot(d, d) < wide * wide && y > -low && y < high) to.anvils.push_back(a);
  }
}

bool CumulusField::brick(vec3 first, float voxel, float* out) const {
  const Level level = levelOf(voxel);
  const float last = voxel * static_cast<float>(kBrickSize - 1);
  if (first.y + last < base_ - 0.5f * level.widest - 0.1f * bubble_) return false;
  Near near, local;
  constexpr float kDiagonal = 0.8661f;  // half the diagonal of a cube
  gather(first + 0.5f * last, kDiagonal * last, level, nullptr, near);
  if (near.empty()) return false;
  bool any = false;
  const float block = voxel * static_cast<float>(kCell - 1);
  for (int z = 0; z < kBrickSize; z += kCell)
    for (int y = 0; y < kBrickSize; y += kCell)
      for (int x = 0; x < kBrickSize; x += kCell) {
        const vec3 corner = first + voxel * vec3(ivec3(x, y, z));
        gather(corner + 0.5f * block, kDiagonal * block, level, &near, local);
        if (local.empty()) continue;
        for (int k = 0; k < kCell; ++k)
          for (int j = 0; j < kCell; ++j)
            for (int i = 0; i < kCell; ++i) {
              const float v = density_ * shape(first + voxel * vec3(ivec3(x + i, y + j, z + k)), level,
                                               local.towers, local.anvils);
              if (v <= 0) continue;
              if (!any) std::fill(out, out + kBrickSize * kBrickSize * kBrickSize, 0.0f);
              any = true;
              out[((z + k) * kBrickSize + y + j) * kBrickSize + x + i] = v;
            }
      }
  return any;
}

}  // namespace

std::unique_ptr<const CloudField> cumulusField(const CloudParams& params, JobControl& control) {
  return std::make_unique<const CumulusField>(params, control);
}

}  // namespace pileus::volume
