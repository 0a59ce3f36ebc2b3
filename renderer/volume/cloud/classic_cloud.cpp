#include "renderer/volume/cloud/classic_cloud.h"

#include <algorithm>
#include <cmath>

#include "renderer/volume/cloud/classic_shape.h"
#include "renderer/volume/cloud/noise.h"

namespace pileus::volume {
namespace {

constexpr int kCell = 4;  ///< voxels along an edge of the blocks that share one list of balls

/// The density field as a function of position; everything that does not depend on the voxel.
class Field {
 public:
  Field(const CloudParams& params, const CloudShape& shape, float voxel)
      : shape_(shape),
        size_(params.size),
        seed_(static_cast<std::uint32_t>(params.seed)),
        density_(static_cast<float>(params.density)),
        shear_(static_cast<float>(params.shear)),
        middle_(0.5f * size_.y) {
    const float s = shape.scale;
    const auto octave = [&](float wavelength, float amplitude) {
      // Bands that the voxels cannot carry fade to their mean, so that a coarse bake is a low-pass of a fine
      // one.
      const float keep = smoothstep01((wavelength / voxel - 1.5f) / 2.0f);
      octaves_.push_back({1.0f / wavelength, amplitude * keep, amplitude * (1 - keep) * (kMean - kLift),
                          amplitude * (1 - kLift)});
      reach_ += amplitude * (1 - kLift);
    };
    const float b = static_cast<float>(params.billow), d = static_cast<float>(params.detail);
    octave(0.15f * s, 0.055f * s * b);
    octave(0.075f * s, 0.032f * s * b);
    octave(0.036f * s, 0.016f * s * (0.4f * b + 0.6f * d));
    octave(0.018f * s, 0.010f * s * d);
    warp_ = 0.035f * s;
    warpFrequency_ = 1.0f / (0.2f * s);
    // The fall-off at the surface is centred at one depth, however wide the voxels make it.
    const float sharpest = 0.014f * s;
    edge_ = std::max(sharpest, 1.5f * voxel);
    outside_ = 0.5f * (edge_ - sharpest);
    reach_ += outside_;
  }

  vec3 unsheared(vec3 p) const { return {p.x - shear_ * (p.y - middle_), p.y, p.z}; }

  /// What bends the balls out of round at an unsheared position.
  vec3 warp(vec3 straight) const {
    const vec3 at = straight * warpFrequency_;
    return warp_ * vec3(gradientNoise(at, seed_ ^ 11u), 0.6f * gradientNoise(at, seed_ ^ 12u),
                        gradientNoise(at, seed_ ^ 13u));
  }
  /// Largest change of the warp over a distance, by its steepest slope.
  float warpChange(float distance) const {
    return std::min(2 * warp_, 3.0f * warp_ * warpFrequency_ * distance);
  }
  float reach() const { return reach_; }

  /// Density at p (relative to the box's lowest corner) from the balls in the list, the large ones first.
  float operator()(vec3 p, const std::vector<Ball>& balls) const {
    const float s = shape_.scale;
    const vec3 straight = unsheared(p);
    const vec3 q = straight + warp(straight);
    float d = 1e9f;
    const float deep = -(reach_ + kCoreDepth * s);  // nothing changes further inside
    for (const Ball& b : balls) {
      const vec3 v = q - b.center;
      const float limit = d + b.blend + b.radius;
      const float square = glm::dot(v, v);
      if (limit <= 0 || square >= limit * limit) continue;
      d = smoothMin(d, std::sqrt(square) - b.radius, b.blend);
      if (d < deep) break;
    }
    if (d > reach_) return 0;
    const float above = q.y - shape_.base;
    const float bulge = 0.15f + 0.85f * smoothstep01(above / (0.12f * s));  // bases stay flat
    float left = reach_;  // what the remaining octaves can still change
    for (std::size_t i = 0; i < octaves_.size(); ++i) {
      if (d > left || d < -left - kCoreDepth * s) break;
      const Octave& o = octaves_[i];
      float n = o.constant;
      if (o.amplitude > 0)
        n += o.amplitude *
             (std::min(1.0f, worley(q * o.frequency, seed_ + 101u + static_cast<std::uint32_t>(i))) - kLift);
      d += bulge * n;
      left -= o.largest;
    }
    if (d >= outside_) return 0;
    d = -smoothMin(-d, above + 0.008f * s * gradientNoise(straight * (2.0f * warpFrequency_), seed_ ^ 14u),
                   0.03f * s);  // cut at the condensation level
    d = std::max(d, boxDistance(p));
    if (d >= outside_) return 0;
    const float shell = smoothstep01((outside_ - d) / edge_);
    const float core = 0.6f + 0.4f * smoothstep01(-d / (kCoreDepth * s));
    const float water =
        0.65f + 0.35f * std::min(1.0f, std::max(0.0f, above) / (0.5f * s));  // liquid water grows with height
    return density_ * shell * core * water;
  }

 private:
  static constexpr float kMean = 0.28f;       ///< mean of min(1, worley)
  static constexpr float kLift = 0.30f;       ///< bulges stand out by that much, crevices cut in by the rest
  static constexpr float kCoreDepth = 0.06f;  ///< of the scale: where the density reaches that of the core
  struct Octave {
    float frequency, amplitude, constant;
    float largest;  ///< of the change to the distance
  };
  float boxDistance(vec3 p) const {
    const vec3 d = glm::abs(p - 0.5f * size_) - 0.5f * size_ + 0.01f * shape_.scale;
    return std::max({d.x, d.y, d.z});
  }

  const CloudShape& shape_;
  vec3 size_;
  std::uint32_t seed_;
  float density_, shear_, middle_;
  std::vector<Octave> octaves_;
  float reach_ = 0, warp_ = 0, warpFrequency_ = 1, edge_ = 1, outside_ = 0;
};

}  // namespace

struct ClassicCloud::Parts {
  CloudShape shape;
  float voxel;
  Field field;
  Parts(const CloudParams& params, float edge, JobControl& control)
      : shape(shapeClouds(params, control)), voxel(edge), field(params, shape, edge) {}
};

ClassicCloud::ClassicCloud(const CloudParams& params, float voxel, JobControl& control)
    : parts_(std::make_unique<const Parts>(params, voxel, control)) {}

ClassicCloud::~ClassicCloud() = default;

bool ClassicCloud::brick(ivec3 brick, ivec3 voxels, float* out, JobControl& control) const {
  const auto& [shape, voxel, field] = *parts_;
  const auto position = [&](ivec3 index) { return (vec3(index) + 0.5f) * voxel; };
  vec3
      center;  // of a block of n voxels, unsheared and warped, and how far from there its field can come from
  float radius;
  const auto block = [&](ivec3 lo, int n) {
    const vec3 a = field.unsheared(position(lo)), b = field.unsheared(position(lo + (n - 1)));
    const vec3 c = field.unsheared(position(lo + ivec3(0, n - 1, 0))),
               d = field.unsheared(position(lo + ivec3(n - 1, 0, n - 1)));
    center = 0.5f * (a + b);
    const float half = 0.5f * std::max(glm::length(b - a), glm::length(d - c));
    center += field.warp(center);
    radius = half + field.warpChange(half) + field.reach();
  };
  const auto touches = [&](vec3 c, float r) {
    const vec3 v = c - center;
    const float limit = r + radius;
    return glm::dot(v, v) < limit * limit;
  };
  std::vector<Ball> near, local;
  block(brick * kBrickSize, kBrickSize);
  for (const Clump& clump : shape.clumps) {
    if (!touches(clump.center, clump.bound)) continue;
    for (std::size_t i = clump.begin; i < clump.end; ++i) {
      const Ball& b = shape.balls[i];
      if (b.radius > 0.3f * voxel && touches(b.center, b.radius + b.blend))
        near.push_back(b);  // smaller ones do not show
    }
  }
  if (near.empty()) return false;
  std::stable_sort(near.begin(), near.end(),
                   [](const Ball& a, const Ball& b) { return a.radius > b.radius; });
  bool any = false;
  for (int z = 0; z < kBrickSize; z += kCell)
    for (int y = 0; y < kBrickSize; y += kCell)
      for (int x = 0; x < kBrickSize; x += kCell) {
        if (control.cancelled()) return false;
        const ivec3 lo = brick * kBrickSize + ivec3(x, y, z);
        if (glm::any(glm::greaterThanEqual(lo, voxels))) continue;
        block(lo, kCell);
        local.clear();
        for (const Ball& b : near)
          if (touches(b.center, b.radius + b.blend)) local.push_back(b);
        if (local.empty()) continue;
        for (int k = 0; k < kCell; ++k)
          for (int j = 0; j < kCell; ++j)
            for (int i = 0; i < kCell; ++i) {
              const ivec3 p = lo + ivec3(i, j, k);
              if (glm::any(glm::greaterThanEqual(p, voxels))) continue;
              const float v = field(position(p), local);
              if (v <= 0) continue;
              if (!any) std::fill(out, out + kBrickSize * kBrickSize * kBrickSize, 0.0f);
              any = true;
              out[static_cast<std::size_t>(((z + k) * kBrickSize + y + j) * kBrickSize + x + i)] = v;
            }
      }
  return any;
}

}  // namespace pileus::volume
