#include "renderer/scene/environment.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "renderer/scene/light.h"

namespace pileus::scene {
namespace {

/// A row of texels that covers parts of others: the first one, and the share of the new one that each has.
struct Cover {
  int first = 0;
  std::vector<double> shares;
};

/// Which of `edges` (rising, n + 1 of them) lie under each of `wanted`.
std::vector<Cover> covers(const std::vector<double>& edges, const std::vector<double>& wanted) {
  std::vector<Cover> out(wanted.size() - 1);
  std::size_t i = 0;
  for (std::size_t k = 0; k + 1 < wanted.size(); ++k) {
    while (i + 2 < edges.size() && edges[i + 1] <= wanted[k]) ++i;
    out[k].first = int(i);
    for (std::size_t j = i; j + 1 < edges.size() && (edges[j] < wanted[k + 1] || j == i); ++j)
      out[k].shares.push_back(
          std::max(std::min(edges[j + 1], wanted[k + 1]) - std::max(edges[j], wanted[k]), 0.0) /
          (wanted[k + 1] - wanted[k]));
  }
  return out;
}

std::vector<double> columnEdges(int width) {
  std::vector<double> out;
  for (int x = 0; x <= width; ++x) out.push_back(double(x) / width);
  return out;
}

/// In 1 - sine of elevation, which rises downward and is even in solid angle.
std::vector<double> rowEdges(int height) {
  std::vector<double> out;
  for (int y = 0; y <= height; ++y) out.push_back(1 - rowSine(height, y));
  return out;
}

}  // namespace

dvec3 environmentDirection(const dvec2& uv, double rotation) {
  return sunDirection((0.5 - uv.x) * 360 + rotation, 90 - 180 * uv.y);
}

dvec2 environmentUv(const dvec3& d, double rotation) {
  const double azimuth = std::atan2(d.x, d.z) - glm::radians(rotation);
  const double u = 0.5 - azimuth / (2 * kPi);
  const double inside = u - std::floor(u);
  return {inside < 1 ? inside : 0.0, 0.5 - std::atan2(d.y, std::hypot(d.x, d.z)) / kPi};
}

dvec3 turned(const dvec3& d, double rotation) {
  const double c = std::cos(glm::radians(rotation)), s = std::sin(glm::radians(rotation));
  return {c * d.x + s * d.z, d.y, c * d.z - s * d.x};
}

double rowSine(int height, int row) { return std::cos(kPi * row / height); }

double texelSolidAngle(ivec2 size, int row) {
  // The difference of the edges' sines as a product: no digits are lost at the poles.
  return 2 * kPi / size.x * 2 * std::sin(kPi * (row + 0.5) / size.y) * std::sin(kPi / 2 / size.y);
}

vec3 environmentRadiance(const EnvironmentMap& map, const dvec3& direction, double rotation) {
  const dvec2 p = environmentUv(direction, rotation) * dvec2(map.size);
  return map.at(std::min(int(p.x), map.size.x - 1), std::min(int(p.y), map.size.y - 1));
}

vec3 smoothRadiance(const EnvironmentMap& map, const dvec3& direction, double rotation) {
  const dvec2 p = environmentUv(direction, rotation) * dvec2(map.size) - 0.5, f = p - glm::floor(p);
  const ivec2 i(glm::floor(p));
  const auto at = [&](int x, int y) {
    const int w = map.size.x;
    return map.at((x + w) % w, std::clamp(y, 0, map.size.y - 1));
  };
  const vec2 t(f);
  return glm::mix(glm::mix(at(i.x, i.y), at(i.x + 1, i.y), t.x),
                  glm::mix(at(i.x, i.y + 1), at(i.x + 1, i.y + 1), t.x), t.y);
}

dvec3 environmentFlux(const EnvironmentMap& map) {
  dvec3 sum(0);
  for (int y = 0; y < map.size.y; ++y) {
    dvec3 row(0);
    for (int x = 0; x < map.size.x; ++x) row += dvec3(map.at(x, y));
    sum += texelSolidAngle(map.size, y) * row;
  }
  return sum;
}

dvec3 environmentIrradiance(const EnvironmentMap& map, const dvec3& normal) {
  dvec3 sum(0);
  for (int y = 0; y < map.size.y; ++y)
    for (int x = 0; x < map.size.x; ++x) {
      const dvec3 d = environmentDirection({(x + 0.5) / map.size.x, (y + 0.5) / map.size.y});
      sum += texelSolidAngle(map.size, y) * std::max(glm::dot(d, normal), 0.0) * dvec3(map.at(x, y));
    }
  return sum;
}

EnvironmentMap reduced(const EnvironmentMap& map, ivec2 largest) {
  const ivec2 size = glm::min(map.size, glm::max(largest, ivec2(1)));
  if (size == map.size || map.radiance.empty()) return map;
  const auto columns = covers(columnEdges(map.size.x), columnEdges(size.x)),
             rows = covers(rowEdges(map.size.y), rowEdges(size.y));
  EnvironmentMap out{size, std::vector<vec3>(std::size_t(size.x) * std::size_t(size.y))};
  tbb::parallel_for(0, size.y, [&](int y) {
    std::vector<dvec3> line(std::size_t(map.size.x), dvec3(0));
    const Cover& r = rows[std::size_t(y)];
    for (std::size_t j = 0; j < r.shares.size(); ++j)
      for (int x = 0; x < map.size.x; ++x)
        line[std::size_t(x)] += r.shares[j] * dvec3(map.at(x, r.first + int(j)));
    for (int x = 0; x < size.x; ++x) {
      const Cover& c = columns[std::size_t(x)];
      dvec3 sum(0);
      for (std::size_t i = 0; i < c.shares.size(); ++i) sum += c.shares[i] * line[std::size_t(c.first) + i];
      out.at(x, y) = vec3(sum);
    }
  });
  return out;
}

EnvironmentMap refined(const EnvironmentMap& map, ivec2 smallest) {
  if (map.radiance.empty()) return map;
  const ivec2 times = glm::max((smallest + map.size - 1) / map.size, ivec2(1));
  if (times == ivec2(1)) return map;
  EnvironmentMap out{map.size * times, {}};
  out.radiance.reserve(std::size_t(out.size.x) * std::size_t(out.size.y));
  for (int y = 0; y < out.size.y; ++y)
    for (int x = 0; x < out.size.x; ++x) out.radiance.push_back(map.at(x / times.x, y / times.y));
  return out;
}

EnvironmentFaults repair(EnvironmentMap& map, Negative keep) {
  EnvironmentFaults out;
  for (vec3& texel : map.radiance) {
    bool nan = false, negative = false, bright = false;
    for (int c = 0; c < 3; ++c) {
      float& v = texel[c];
      if (std::isnan(v)) {
        nan = true;
        v = 0;
      } else if (v < (keep == Negative::Keep ? -kLargestRadiance : 0)) {
        negative = true;
        v = 0;
      } else if (v > kLargestRadiance) {
        bright = true;
        v = std::isinf(v) ? kInfiniteRadiance : kLargestRadiance;
      }
    }
    out.notNumbers += nan;
    out.negative += negative;
    out.tooBright += bright;
  }
  return out;
}

Environment environmentOf(EnvironmentMap map) {
  Environment out;
  out.map = std::make_shared<const EnvironmentMap>(reduced(map, kLightMap));
  out.seen = std::make_shared<const EnvironmentMap>(reduced(map, kSeenMap));
  return out;
}

std::shared_ptr<const Environment> joined(const std::vector<std::shared_ptr<const Environment>>& some) {
  if (some.empty()) return nullptr;
  if (some.size() == 1) return some.front();
  constexpr ivec2 kSize{1024, 512};
  constexpr int kAcross = 2;  // places of a texel, along each axis
  EnvironmentMap sum{kSize, std::vector<vec3>(std::size_t(kSize.x) * std::size_t(kSize.y), vec3(0.0f))};
  for (const auto& each : some)
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x)
        for (int i = 0; i < kAcross * kAcross; ++i) {
          const dvec2 inside = (dvec2(i % kAcross, i / kAcross) + 0.5) / double(kAcross);
          const dvec3 d = environmentDirection((dvec2(x, y) + inside) / dvec2(kSize));
          sum.at(x, y) +=
              each->scale / float(kAcross * kAcross) * environmentRadiance(*each->seen, d, each->rotation);
        }
  return std::make_shared<const Environment>(environmentOf(std::move(sum)));
}

}  // namespace pileus::scene
