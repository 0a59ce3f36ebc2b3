#include "renderer/scene/environment_suns.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pileus::scene {
namespace {

constexpr double kBlur = 0.25, kReach = 5;        // degrees
constexpr double kEdge = 1.0 / 16, kShare = 0.2;  // of the peak; of the rest's flux
constexpr double kTaken = 1.5, kRing = 3;         // of a disc's radius
constexpr int kTries = 8;                         // spots that are looked at

dvec3 middle(ivec2 size, ivec2 t) {
  return environmentDirection({(t.x + 0.5) / size.x, (t.y + 0.5) / size.y});
}

double degreesBetween(const dvec3& a, const dvec3& b) {
  return glm::degrees(2 * std::asin(std::min(glm::length(a - b) / 2, 1.0)));
}

double texelDegrees(ivec2 size) { return std::max(180.0 / size.y, 360.0 / size.x); }

/// Calls f(texel, direction, degrees) for those whose middle is at most `reach` degrees away.
template <class F>
void forEachWithin(ivec2 size, const dvec3& center, double reach, F&& f) {
  const dvec2 at = environmentUv(center) * dvec2(size);
  const double rows = reach / 180 * size.y + 1;
  for (int y = std::max(int(at.y - rows), 0); y < std::min(int(at.y + rows) + 1, size.y); ++y) {
    // How far a circle around the centre reaches to the sides: all around where it holds a pole.
    const double sine = std::sin(glm::radians(reach)) / std::max(std::hypot(center.x, center.z), 1e-9);
    const bool pole = glm::degrees(std::asin(std::abs(center.y))) + reach >= 90;
    const int half = pole ? size.x : int(std::asin(std::min(sine, 1.0)) / (2 * kPi) * size.x) + 2;
    const int first = int(at.x) - half, count = std::min(2 * half + 1, size.x);
    for (int i = 0; i < count; ++i) {
      const ivec2 t(((first + i) % size.x + size.x) % size.x, y);
      const dvec3 d = middle(size, t);
      if (const double away = degreesBetween(d, center); away <= reach) f(t, d, away);
    }
  }
}

struct Spot {
  ivec2 texel{0};
  double peak = 0;
};

/// The brightest texel of a blurred map, where `barred` is not set.
Spot brightest(const EnvironmentMap& map, const std::vector<char>& barred) {
  const int h = map.size.y, w = map.size.x, half = int(kBlur / 2 / 180 * h + 0.5);
  std::vector<Spot> rows(std::size_t(h), Spot{});
  tbb::parallel_for(0, h, [&](int y) {
    const double across = kBlur / 2 / 360 * w / std::max(std::sin(kPi * (y + 0.5) / h), 1e-3);
    const int wide = std::min(int(across + 0.5), w / 2);
    Spot& best = rows[std::size_t(y)];
    std::vector<double> column(std::size_t(w), 0);  // the sums over the rows of the blur
    double weight = 0;
    for (int j = std::max(y - half, 0); j <= std::min(y + half, h - 1); ++j) {
      weight += 1;
      for (int x = 0; x < w; ++x) column[std::size_t(x)] += environmentImportance(map.at(x, j));
    }
    double sum = 0;
    for (int i = -wide; i <= wide; ++i) sum += column[std::size_t((i + w) % w)];
    for (int x = 0; x < w; ++x) {
      const double value = sum / (weight * (2 * wide + 1));
      if (value > best.peak && !barred[std::size_t(y) * std::size_t(w) + std::size_t(x)])
        best = {{x, y}, value};
      sum += column[std::size_t((x + wide + 1) % w)] - column[std::size_t((x - wide + w) % w)];
    }
  });
  Spot out;
  for (const Spot& s : rows)
    if (s.peak > out.peak) out = s;
  return out;
}

/// Degrees from the spot to the farthest texel that belongs to it.
double grow(const EnvironmentMap& map, const Spot& spot) {
  const ivec2 size = map.size;
  const dvec3 center = middle(size, spot.texel);
  std::vector<char> seen(map.radiance.size(), 0);
  std::vector<ivec2> open{spot.texel};
  double radius = 0;
  while (!open.empty()) {
    const ivec2 t = open.back();
    open.pop_back();
    const auto visit = [&](int x, int y) {
      if (y < 0 || y >= size.y) {  // across a pole
        x += size.x / 2;
        y = std::clamp(y, 0, size.y - 1);
      }
      x = (x % size.x + size.x) % size.x;
      char& mark = seen[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
      if (std::exchange(mark, 1)) return;
      const double away = degreesBetween(middle(size, {x, y}), center);
      if (away > kReach || environmentImportance(map.at(x, y)) < kEdge * spot.peak) return;
      radius = std::max(radius, away);
      open.emplace_back(x, y);
    };
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) visit(t.x + i, t.y + j);
  }
  return radius;
}

/// Median of each channel between two circles.
vec3 ringMedian(const EnvironmentMap& map, const dvec3& center, double from, double to) {
  std::array<std::vector<float>, 3> values;
  forEachWithin(map.size, center, to, [&](ivec2 t, const dvec3&, double away) {
    if (away > from)
      for (int c = 0; c < 3; ++c) values[std::size_t(c)].push_back(map.at(t.x, t.y)[c]);
  });
  vec3 out(0);
  for (int c = 0; c < 3; ++c)
    if (auto& v = values[std::size_t(c)]; !v.empty()) {
      const auto mid = v.begin() + std::ptrdiff_t(v.size() / 2);
      std::nth_element(v.begin(), mid, v.end());
      out[c] = *mid;
    }
  return out;
}

/// The light above `background` within `radius` as a sun.
Light sunWithin(const EnvironmentMap& map, const dvec3& center, double radius, const vec3& background) {
  dvec3 irradiance(0), toward(0);
  double weight = 0;
  const auto excess = [&](ivec2 t) { return glm::max(map.at(t.x, t.y) - background, vec3(0)); };
  forEachWithin(map.size, center, radius, [&](ivec2 t, const dvec3& d, double) {
    const double w = texelSolidAngle(map.size, t.y);
    irradiance += w * dvec3(excess(t));
    const double share = w * environmentImportance(excess(t));
    weight += share;
    toward += share * d;
  });
  Light sun;
  sun.emitted = vec3(irradiance);
  sun.towards = weight > 0 ? glm::normalize(toward) : center;
  double second = 0;
  forEachWithin(map.size, center, radius, [&](ivec2 t, const dvec3& d, double away) {
    (void)away;
    const double a = degreesBetween(d, sun.towards), across = 360.0 / map.size.x * std::hypot(d.x, d.z),
                 up = 180.0 / map.size.y;
    second += texelSolidAngle(map.size, t.y) * environmentImportance(excess(t)) *
              (a * a + (across * across + up * up) / 12);  // texels are not points
  });
  // The mean square of the distance from the middle of an even disc is half its radius squared.
  sun.angle = weight > 0 ? 2 * std::sqrt(2 * second / weight) : 0;
  return sun;
}

}  // namespace

std::vector<Light> extractSuns(EnvironmentMap& map, int most) {
  std::vector<Light> suns;
  if (map.radiance.empty()) return suns;
  std::vector<char> barred(map.radiance.size(), 0);
  double rest = environmentImportance(vec3(environmentFlux(map)));
  for (int tries = 0; tries < kTries && int(suns.size()) < most; ++tries) {
    const Spot spot = brightest(map, barred);
    if (spot.peak <= 0) break;
    const dvec3 center = middle(map.size, spot.texel);
    const double texel = texelDegrees(map.size), radius = std::max(grow(map, spot) + texel / 2, texel);
    const vec3 background = ringMedian(map, center, kTaken * radius, kRing * radius);
    const Light sun = sunWithin(map, center, kTaken * radius, background);
    const double taken = environmentImportance(sun.emitted);
    if (!(taken > kShare * (rest - taken)) || sun.angle > 2 * kReach) {
      forEachWithin(map.size, center, kTaken * radius, [&](ivec2 t, const dvec3&, double) {
        barred[std::size_t(t.y) * std::size_t(map.size.x) + std::size_t(t.x)] = 1;
      });
      continue;
    }
    forEachWithin(map.size, center, kTaken * radius, [&](ivec2 t, const dvec3&, double) {
      map.at(t.x, t.y) = glm::min(map.at(t.x, t.y), background);
    });
    rest -= taken;
    suns.push_back(sun);
  }
  return suns;
}

}  // namespace pileus::scene
