#include "renderer/volume/cloud/classic_shape.h"

#include <algorithm>

#include "renderer/volume/cloud/noise.h"

namespace pileus::volume {
namespace {

struct Cloud {
  vec2 position;  ///< x, z
  float radius, height;
  std::uint32_t seed;
};

/// A direction on the sphere that does not point steeply downwards (rejection; no trigonometry).
vec3 upwardDirection(Random& random) {
  for (int i = 0; i < 64; ++i) {
    const vec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    const float l = glm::length(v);
    if (l < 1.0f && l > 0.1f && v.y > -0.35f * l) return v / l;
  }
  return {0, 1, 0};
}

void growOn(std::vector<Ball>& balls, const Ball& parent, int generations, float billow, Random& random) {
  const int children = 5 + static_cast<int>(random.next() * 3.0f);
  for (int i = 0; i < children; ++i) {
    const vec3 direction = upwardDirection(random);
    const float r = parent.radius * random.between(0.38f, 0.62f);
    const float out = parent.radius - r * (0.6f - 0.6f * billow);  // how far the bulge stands out
    const Ball child{parent.center + direction * out, r, r * 0.15f};
    balls.push_back(child);
    if (generations > 1) growOn(balls, child, generations - 1, billow, random);
  }
}

/// Columns of balls under a dome: high in the middle, low at the rim.
void buildCloud(const Cloud& cloud, float base, float billow, CloudShape& out) {
  Random random(cloud.seed);
  const float R = cloud.radius;
  const int columns = 6 + static_cast<int>(random.next() * 5.0f);
  const vec2 lean(random.between(-0.25f, 0.25f),
                  random.between(-0.25f, 0.25f));  // off-centre towers look alive
  for (int i = 0; i < columns; ++i) {
    vec2 d;
    do d = {random.between(-1, 1), random.between(-1, 1)};
    while (glm::dot(d, d) > 1.0f);
    if (i == 0) d = lean;
    const float rho = glm::length(d - lean * 0.5f);
    const float dome = std::max(0.0f, 1.0f - rho * rho * 0.85f);
    const float top = cloud.height * dome * (i == 0 ? 1.0f : random.between(0.45f, 1.0f));
    const float foot = R * (0.35f - 0.15f * std::min(rho, 1.0f)) * random.between(0.85f, 1.1f);
    const vec2 place = cloud.position + d * (0.72f * R - foot);
    vec2 drift(0.0f);
    float r = foot;
    for (float y = 0.3f * foot;; y += r * random.between(0.6f, 0.85f)) {
      r = foot * (1.0f - 0.42f * std::min(1.0f, y / (top + foot)));  // towers narrow, but end round
      const Ball body{{place.x + drift.x, base + y, place.y + drift.y}, r, r * 0.25f};
      const std::size_t begin = out.balls.size();
      out.balls.push_back(body);
      growOn(out.balls, body, 2, billow, random);
      out.clumps.push_back({body.center, 0.0f, begin, out.balls.size()});
      if (y + 1.4f * r >= top) break;
      drift += vec2(random.between(-0.35f, 0.35f), random.between(-0.35f, 0.35f)) * r;
    }
  }
  for (Clump& c : out.clumps) {
    if (c.bound > 0) continue;
    for (std::size_t b = c.begin; b < c.end; ++b)
      c.bound = std::max(c.bound, glm::length(out.balls[b].center - c.center) + out.balls[b].radius);
  }
}

/// The ground as a raster of covered cells.
class Ground {
 public:
  Ground(vec2 size, float base, float shear, float middle)
      : size_(size), base_(base), shear_(shear), middle_(middle) {
    const float cell = std::max(size.x, size.y) / 128.0f;
    n_ = glm::max(ivec2(size / cell + 0.5f), ivec2(1));
    covered_.assign(static_cast<std::size_t>(n_.x * n_.y), 0);
  }
  double fraction() const { return double(count_) / double(covered_.size()); }
  void add(const CloudShape& shape, std::size_t firstBall) {
    const vec2 cell = size_ / vec2(n_);
    for (std::size_t i = firstBall; i < shape.balls.size(); ++i) {
      const Ball& b = shape.balls[i];
      if (b.center.y + b.radius < base_) continue;
      const vec2 c(b.center.x + shear_ * (b.center.y - middle_), b.center.z);
      const ivec2 lo = glm::max(ivec2(glm::floor((c - b.radius) / cell)), ivec2(0));
      const ivec2 hi = glm::min(ivec2(glm::floor((c + b.radius) / cell)), n_ - 1);
      for (int y = lo.y; y <= hi.y; ++y)
        for (int x = lo.x; x <= hi.x; ++x) {
          const vec2 d = (vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) * cell - c;
          auto& mark = covered_[static_cast<std::size_t>(y * n_.x + x)];
          if (mark || glm::dot(d, d) > b.radius * b.radius) continue;
          mark = 1;
          ++count_;
        }
    }
  }
  /// Centre of an uncovered cell, chosen by u in [0, 1).
  vec2 freePlace(float u) const {
    auto skip = static_cast<std::size_t>(static_cast<double>(u) * double(covered_.size() - count_));
    for (std::size_t i = 0; i < covered_.size(); ++i) {
      if (covered_[i] || skip-- > 0) continue;
      return (vec2(static_cast<float>(static_cast<int>(i) % n_.x),
                   static_cast<float>(static_cast<int>(i) / n_.x)) +
              0.5f) *
             size_ / vec2(n_);
    }
    return size_ * 0.5f;
  }

 private:
  vec2 size_;
  float base_, shear_, middle_;
  ivec2 n_;
  std::vector<unsigned char> covered_;
  std::size_t count_ = 0;
};

/// A place as far as possible from the clouds that stand; nothing if every try overlaps one deeply.
std::optional<vec2> openPlace(const std::vector<Cloud>& clouds, float radius, vec2 inset, vec2 size,
                              Random& random) {
  std::optional<vec2> best;
  float bestGap = -0.3f * radius;
  for (int i = 0; i < 24; ++i) {
    const vec2 p(random.between(inset.x, size.x - inset.x), random.between(inset.y, size.y - inset.y));
    float gap = 1e9f;
    for (const Cloud& c : clouds) gap = std::min(gap, glm::length(p - c.position) - c.radius - radius);
    if (gap <= bestGap) continue;
    bestGap = gap;
    best = p;
  }
  return best;
}

}  // namespace

CloudShape shapeClouds(const CloudParams& params, JobControl& control) {
  const vec3 size(params.size);
  CloudShape shape;
  shape.scale = std::min(size.y, 0.75f * std::max(size.x, size.z));
  shape.base = 0.1f * shape.scale;
  const float shear = static_cast<float>(params.shear), billow = static_cast<float>(params.billow);
  const vec2 ground(size.x, size.z);
  // Not below 1/30 of the box, so that the number of clouds stays bounded in a very wide one.
  const float largest = std::max(std::min(0.62f * shape.scale, 0.45f * std::min(ground.x, ground.y)),
                                 std::max(ground.x, ground.y) / 30.0f);
  Ground covered(ground, shape.base, shear, 0.5f * size.y);
  Random random(static_cast<std::uint32_t>(params.seed) * 2654435761u + 1u);
  std::vector<Cloud> clouds;
  for (int k = 0; k < 3000 && covered.fraction() < params.coverage && !control.cancelled(); ++k) {
    const float u = k == 0 ? 0.95f : random.next();
    const std::uint32_t seed = hash3(k, 1, 2, static_cast<std::uint32_t>(params.seed));
    const float aspect = random.between(0.7f, 1.2f), free = random.next();
    Cloud cloud{{}, largest * (0.24f + 0.76f * u * u), 0, seed};
    std::optional<vec2> place;
    vec2 inset(0.0f);
    for (int attempt = 0; attempt < 4 && !place;
         ++attempt) {  // a smaller cloud rather than one that overlaps
      if (attempt > 0) cloud.radius *= 0.65f;
      cloud.height = std::min(cloud.radius * aspect, 0.72f * shape.scale);
      const float lean = std::abs(shear) * 0.5f * size.y;
      inset = glm::min(vec2(cloud.radius * 1.08f + lean, cloud.radius * 1.08f), ground * 0.5f);
      place = openPlace(clouds, cloud.radius, inset, ground, random);
    }
    cloud.position = place ? *place : covered.freePlace(free);
    if (!place) {  // nearly overcast: fill what is left, at last up to the walls of the box
      cloud.radius = largest * (0.3f + 0.3f * u);
      cloud.height = std::min(cloud.radius * aspect, 0.72f * shape.scale);
      if (covered.fraction() < 0.8) cloud.position = glm::clamp(cloud.position, inset, ground - inset);
    }
    // The last cloud is grown only as far as the coverage asks.
    float low = 0, high = 1, factor = 1;
    for (int step = 0; step < 7; ++step) {
      CloudShape trial;
      Cloud c = cloud;
      c.radius *= factor;
      c.height *= factor;
      buildCloud(c, shape.base, billow, trial);
      Ground after = covered;
      after.add(trial, 0);
      const bool over = after.fraction() > params.coverage + 0.002;
      if (step == 0 && !over) break;
      (over ? high : low) = factor;
      factor = 0.5f * (low + high);
    }
    cloud.radius *= factor;
    cloud.height *= factor;
    if (cloud.radius < 0.02f * largest) break;
    const std::size_t first = shape.balls.size();
    buildCloud(cloud, shape.base, billow, shape);
    covered.add(shape, first);
    clouds.push_back(cloud);
  }
  return shape;
}

}  // namespace pileus::volume
