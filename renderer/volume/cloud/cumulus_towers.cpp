#include "renderer/volume/cloud/cumulus_towers.h"

#include <algorithm>
#include <cmath>

#include "renderer/volume/cloud/bubbles.h"
#include "renderer/volume/cloud/noise.h"

namespace pileus::volume {
namespace {

constexpr int kMostClouds = 12000;
constexpr int kTowers = 18;  ///< of the largest cloud

struct Place {
  vec2 position;  ///< x, z
  float radius;
  std::uint32_t seed;
};

/// The ground as a raster of cells that are under cloud, or that none fits over.
class Ground {
 public:
  explicit Ground(vec2 size) : size_(size) {
    const float cell = std::max(size.x, size.y) / 256.0f;
    n_ = glm::max(ivec2(size / cell + 0.5f), ivec2(1));
    covered_.assign(static_cast<std::size_t>(n_.x * n_.y), 0);
  }
  double fraction() const { return double(count_) / double(covered_.size()); }
  bool coveredAt(vec2 p) const { return covered_[index(cellOf(p))] != 0; }
  void cover(vec2 center, float radius) {
    const vec2 cell = size_ / vec2(n_);
    const ivec2 lo = glm::max(ivec2(glm::floor((center - radius) / cell)), ivec2(0));
    const ivec2 hi = glm::min(ivec2(glm::floor((center + radius) / cell)), n_ - 1);
    for (int y = lo.y; y <= hi.y; ++y)
      for (int x = lo.x; x <= hi.x; ++x) {
        const vec2 d = (vec2(ivec2(x, y)) + 0.5f) * cell - center;
        if (glm::dot(d, d) <= radius * radius) mark({x, y});
      }
  }
  void coverCell(vec2 p) { mark(cellOf(p)); }
  /// Middle of an uncovered cell, chosen by u in [0, 1).
  vec2 freePlace(float u) const {
    auto skip = static_cast<std::size_t>(static_cast<double>(u) * double(covered_.size() - count_));
    for (std::size_t i = 0; i < covered_.size(); ++i)
      if (!covered_[i] && skip-- == 0)
        return (vec2(ivec2(static_cast<int>(i) % n_.x, static_cast<int>(i) / n_.x)) + 0.5f) * size_ /
               vec2(n_);
    return size_ * 0.5f;
  }

 private:
  ivec2 cellOf(vec2 p) const { return glm::clamp(ivec2(p / size_ * vec2(n_)), ivec2(0), n_ - 1); }
  std::size_t index(ivec2 c) const { return static_cast<std::size_t>(c.y * n_.x + c.x); }
  void mark(ivec2 c) {
    auto& one = covered_[index(c)];
    count_ += one == 0;
    one = 1;
  }

  vec2 size_;
  ivec2 n_;
  std::vector<unsigned char> covered_;
  std::size_t count_ = 0;
};

/// How much of a disc is covered already, from nine points.
float covered(const Ground& ground, vec2 center, float radius) {
  int n = ground.coveredAt(center);
  for (const vec2 d : {vec2(1, 0), vec2(0, 1), vec2(-1, 0), vec2(0, -1)}) {
    n += ground.coveredAt(center + 0.9f * radius * d);
    n += ground.coveredAt(center + 0.6f * radius * vec2(d.x - d.y, d.x + d.y));
  }
  return static_cast<float>(n) / 9.0f;
}

std::vector<Place> places(const CloudParams& params, float largest, JobControl& control) {
  const vec2 size(static_cast<float>(params.size.x), static_cast<float>(params.size.z));
  const float reach = heapReach(params);
  Ground ground(size);
  Random random(static_cast<std::uint32_t>(params.seed) * 2654435761u + 1u);
  std::vector<Place> out;
  for (int k = 0; k < kMostClouds && ground.fraction() < params.coverage && !control.cancelled(); ++k) {
    const float u = k == 0 ? 1.0f : random.next();
    Place place{{}, largest * (0.3f + 0.7f * u * u), hash3(k, 3, 7, static_cast<std::uint32_t>(params.seed))};
    place.radius = std::min(place.radius, 0.5f * std::min(size.x, size.y) / reach);
    const vec2 inset = glm::min(vec2(reach * place.radius), 0.5f * size);
    float least = 2;
    for (int i = 0; i < 16 && least > 0; ++i) {
      const vec2 p(random.between(inset.x, size.x - inset.x), random.between(inset.y, size.y - inset.y));
      if (const float c = covered(ground, p, place.radius); c < least) {
        least = c;
        place.position = p;
      }
    }
    const float free = random.next();
    if (least > 0.34f) {  // nearly full: what fits where there is room, at last up to the walls of the box
      place.position = ground.freePlace(free);
      const vec2 wall = glm::min(place.position, size - place.position);
      place.radius = std::min(0.75f * place.radius, std::min(wall.x, wall.y) / reach);
      if (place.radius < 0.08f * largest) {
        ground.coverCell(place.position);
        continue;
      }
    }
    ground.cover(place.position, 0.86f * place.radius);
    out.push_back(place);
  }
  return out;
}

/// Carried by the wind, and smaller near a wall.
Place carriedBy(Place place, const CloudParams& params) {
  const double width = params.size.x, way = params.wind * params.time;
  if (way == 0) return place;
  const double x = double(place.position.x) + way;
  place.position.x = static_cast<float>(x - width * std::floor(x / width));
  const float wall = std::min(place.position.x, static_cast<float>(width) - place.position.x);
  place.radius *= std::clamp(wall / (heapReach(params) * place.radius), 0.0f, 1.0f);
  return place;
}

/// Size of a tower in its life, 0 .. 1: it grows, stands and dissolves.
float lived(float phase) {
  return 0.25f + 0.75f * rise(0.0f, 0.35f, phase) * (1.0f - rise(0.8f, 1.0f, phase));
}

void buildHeap(const Place& place, const CloudParams& params, CumulusTowers& out) {
  const CumulusScale& scale = out.scale;
  Random random(place.seed);
  const float r = place.radius, part = r / scale.radius;
  const float height = scale.height * part * std::sqrt(std::sqrt(std::sqrt(part)));
  const float age = static_cast<float>(params.age), lean = std::clamp(float(params.shear), -2.0f, 2.0f);
  const double life = 4.0 * double(scale.bubble / bubbleSpeed(scale.bubble));  // ten to twenty minutes
  const int n = std::max(3, static_cast<int>(kTowers * (0.45f + 0.55f * part)));
  vec2 around(1, 0);
  const std::size_t begin = out.towers.size();
  for (int i = 0; i < n; ++i) {
    const float jitter = random.between(-0.5f, 0.5f);
    const vec2 along = glm::normalize(vec2(around.x - jitter * around.y, around.y + jitter * around.x));
    around = {-0.7373688f * around.x - 0.6754903f * around.y, 0.6754903f * around.x - 0.7373688f * around.y};
    const float rho =
        i == 0 ? 0.15f : 0.95f * std::sqrt((static_cast<float>(i) - 0.3f) / static_cast<float>(n));
    const double lasts = life * double(random.between(0.7f, 1.3f));
    const float spread = random.between(-0.25f, 0.25f);
    double phase = std::clamp(0.05 + 0.85 * double(age) + (i == 0 ? 0.0 : double(spread)), 0.0, 0.999);
    if (i > 0) phase += params.time / lasts;
    const float ph = static_cast<float>(phase - std::floor(phase)), s = lived(ph);
    // The middle one reaches through the anvil.
    const float tall = i == 0 ? (params.anvil > 0 ? 1.14f : 1.0f) : random.between(0.4f, 1.0f);
    const float top = height * (1.0f - 0.8f * rho * rho) * tall * s;
    const float foot = r * (0.42f - 0.2f * rho) * random.between(0.85f, 1.15f) * (0.5f + 0.5f * s);
    Tower t{};
    t.foot = foot;
    t.head = foot * random.between(0.75f, 1.0f);
    const float sway = random.between(-0.15f, 0.15f) * std::min(top, 2.0f * r);
    const vec2 a = place.position + 0.8f * r * rho * along;
    const vec2 b = a + (0.12f * r * rho + sway) * along + vec2(lean * std::min(top, 3.0f * r), 0.0f);
    t.from = {a.x, scale.base - 0.2f * foot, a.y};
    t.to = {b.x, scale.base + std::max(0.3f * foot, top - t.head), b.y};
    t.age = rise(0.55f, 1.0f, ph);
    t.cloud = r;
    out.towers.push_back(t);
  }
  Heap heap{place.position, 0, begin, out.towers.size()};
  for (std::size_t i = begin; i < heap.end; ++i) {
    const Tower& t = out.towers[i];
    for (const vec3 p : {t.from, t.to})
      heap.bound = std::max(heap.bound, glm::length(vec2(p.x, p.z) - heap.center) + t.foot);
  }
  out.heaps.push_back(heap);
  if (params.anvil > 0 && part > 0.55f) {
    const float grown = lived(0.05f + 0.85f * age) * static_cast<float>(params.anvil);
    const Tower& middle = out.towers[begin];
    out.anvils.push_back({{middle.to.x, scale.base + 0.95f * height, middle.to.z},
                          1.15f * grown * r + 0.5f * r,
                          0.10f * height,
                          middle.foot});
  }
}

}  // namespace

float heapReach(const CloudParams& params) {
  const float anvil = static_cast<float>(params.anvil);
  const float lean = 0.4f * std::min(2.0f, std::abs(static_cast<float>(params.shear)));
  return std::max(1.2f + lean, anvil > 0 ? 1.5f * (1.15f * anvil + 0.5f) : 0.0f);
}

CumulusScale cumulusScale(const CloudParams& params) {
  const vec3 size(params.size);
  const float across = std::max(size.x, size.z), room = static_cast<float>(params.top - params.base) * size.y;
  CumulusScale s{};
  s.base = static_cast<float>(params.base) * size.y;
  s.radius = std::min(0.5f * static_cast<float>(params.breadth) * room,
                      0.5f * std::min(size.x, size.z) / heapReach(params));
  // Not below a part of the box, so that the number of clouds stays bounded in a very wide one.
  s.radius = std::max(s.radius, across / 120.0f);
  s.bubble = std::max(std::min(0.63f * s.radius, 0.46f * room), across / 2000.0f);
  s.height = std::max((room - 0.2f * s.bubble) / (params.anvil > 0 ? 1.15f : 1.0f), 0.1f * room);
  return s;
}

CumulusTowers cumulusTowers(const CloudParams& params, JobControl& control) {
  CumulusTowers out;
  out.scale = cumulusScale(params);
  for (const Place& place : places(params, out.scale.radius, control)) {
    const Place now = carriedBy(place, params);
    if (now.radius > 0.02f * out.scale.radius) buildHeap(now, params, out);
  }
  return out;
}

}  // namespace pileus::volume
