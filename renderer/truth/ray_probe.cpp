#include "renderer/truth/ray_probe.h"

#include <algorithm>
#include <cmath>

#include "renderer/scene/environment_strata.h"
#include "renderer/shadow/light_frustum.h"
#include "renderer/shadow/reference.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/shadow_probe.h"

namespace pileus::truth {
namespace {

using shadow::ShadowMap;

constexpr int kCoverageSteps = 4096;  // of a grid's bricks along a ray

std::string nameOf(const volume::Instance& i, int& boxes, int& balls) {
  if (i.shape == volume::Shape::Box) return fmt::format("Box {}", ++boxes);
  if (i.shape == volume::Shape::Ball) return fmt::format("Sphere {}", ++balls);
  return i.grid && !i.grid->name.empty() ? i.grid->name : "Grid";
}

/// A ray in an instance's local space and the x range in which it is inside.
struct Crossing {
  dvec3 o{0}, d{0};
  dvec2 range{0};
};

std::optional<Crossing> crossing(const volume::Instance& i, const dvec3& from, const dvec3& to) {
  const Box3 bounds = volume::localBounds(i);
  if (bounds.empty() || !(volume::majorant(i) > 0)) return std::nullopt;
  const dmat4 local = glm::inverse(i.worldFromLocal);
  Crossing c{dvec3(local * dvec4(from, 1)), dvec3(local * dvec4(to - from, 0)), {}};
  const auto hit = i.shape == volume::Shape::Ball ? intersectBall(c.o, c.d)
                                                  : intersectBox(c.o, c.d, bounds.min, bounds.max);
  if (!hit) return std::nullopt;
  c.range = glm::clamp(*hit, 0.0, 1.0);
  return c.range.x < c.range.y ? std::optional(c) : std::nullopt;
}

/// Runs of occupied bricks; the whole crossing for a shape.
void addCoverage(const volume::Instance& i, const Crossing& c, std::vector<dvec2>& out) {
  if (i.shape != volume::Shape::Grid) return out.push_back(c.range);
  const volume::Level& level = i.grid->levels.front();
  double start = -1;
  for (int k = 0; k <= kCoverageSteps; ++k) {
    const double x = glm::mix(c.range.x, c.range.y, (k + 0.5) / kCoverageSteps);
    const ivec3 b = ivec3(glm::floor((c.o + x * c.d - dvec3(i.grid->origin)) / double(volume::kBrickSize)));
    const bool inside = k < kCoverageSteps && glm::all(glm::greaterThanEqual(b, ivec3(0))) &&
                        glm::all(glm::lessThan(b, level.bricks)) && volume::occupied(i, level.at(b));
    const double edge = glm::mix(c.range.x, c.range.y, double(k) / kCoverageSteps);
    if (inside && start < 0) start = edge;
    if (!inside && start >= 0) {
      out.push_back({start, edge});
      start = -1;
    }
  }
}

std::vector<dvec2> united(std::vector<dvec2> parts) {
  std::sort(parts.begin(), parts.end(), [](dvec2 a, dvec2 b) { return a.x < b.x; });
  std::vector<dvec2> out;
  for (const dvec2 p : parts) {
    if (!out.empty() && p.x <= out.back().y + 1e-9)
      out.back().y = std::max(out.back().y, p.y);
    else
      out.push_back(p);
  }
  return out;
}

void measure(RayProbe& probe) {
  double sum = 0, length = 0;
  const std::size_t n = probe.mapped.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool inMedium = std::any_of(probe.covered.begin(), probe.covered.end(),
                                      [&](dvec2 c) { return probe.x[i] >= c.x && probe.x[i] <= c.y; });
    if (!inMedium) continue;
    const double e = std::abs(probe.mapped[i] - probe.exact[i]),
                 step = 0.5 * (probe.x[std::min(i + 1, n - 1)] - probe.x[i > 0 ? i - 1 : 0]);
    sum += step * e;
    length += step;
    if (e > probe.maxError) probe.maxError = e, probe.maxErrorX = probe.x[i];
  }
  probe.meanError = length > 0 ? sum / length : 0;
}

/// Evenly over the ray, and evenly over what lies from the first to the last medium.
std::vector<double> positionsOf(const std::vector<dvec2>& covered, int count) {
  std::vector<double> x;
  for (int i = 0; i < count; ++i) x.push_back(double(i) / (count - 1));
  if (!covered.empty()) {
    const double room = 0.02 * (covered.back().y - covered.front().x),
                 lo = std::max(covered.front().x - room, 0.0), hi = std::min(covered.back().y + room, 1.0);
    for (int i = 0; i < count; ++i) x.push_back(glm::mix(lo, hi, (i + 0.5) / count));
  }
  std::sort(x.begin(), x.end());
  return x;
}

}  // namespace

Result<RayProbe> probeRay(const shadow::Gpu& gpu, const shadow::ShadowedLight& light, const dvec3& point,
                          int count, std::shared_ptr<const shadow::ShadowMap> made) {
  if (!light.shadow) return fail(Code::Input, "this light has no shadow");
  if (light.light.kind == scene::LightKind::Environment) {
    const scene::Light sun = scene::mainSun(*light.light.environment);
    const ShadowMap& as = *light.shadow;
    if (!made) {
      PILEUS_TRY(made, shadow::buildShadow(gpu, as.spec, sun, as.volumes, as.solids));
    }
    return probeRay(gpu, {sun, made}, point, count);
  }
  RayProbe probe;
  probe.map = light.shadow;
  probe.point = point;
  const ShadowMap& map = *light.shadow;
  const bool marched = map.kind == ShadowMap::Kind::RayMarch;
  const int resolution = map.block ? map.block->resolution() : marched ? 1024 : map.spec.resolution;
  const shadow::LightFrustum frustum =
      marched ? shadow::fitLight(light.light, map.volumes, resolution) : map.frustum;
  const shadow::MapPoint at = shadow::mapCoordinates(frustum, point, resolution);
  const dvec2 uv(at.at);
  if (!marched && (glm::any(glm::lessThan(uv, dvec2(0))) || glm::any(glm::greaterThan(uv, dvec2(1)))))
    return fail(Code::Input, "the light's map does not see this point: its media cast no shadow here");
  const shadow::MapSegment segment = shadow::mapSegment(frustum, at.face, uv, resolution);
  probe.from = segment.from, probe.to = segment.to;
  probe.length = glm::length(segment.to - segment.from);
  probe.nearDistance = frustum.perspective() ? frustum.nearDistance : 0;
  probe.pointX = std::clamp(at.at.z, 0.0, 1.0);
  const scene::Incidence incidence = scene::incidence(light.light, point);
  const dvec3 lit =
      light.light.kind == scene::LightKind::Sun ? point + incidence.towards * 1e9 : light.light.position;
  probe.blocked = scene::blocked(map.solids, point, lit);

  std::vector<dvec2> covered;
  int boxes = 0, balls = 0;
  for (std::size_t i = 0; i < map.volumes.size(); ++i) {
    std::string name = nameOf(map.volumes[i], boxes, balls);
    const auto c = crossing(map.volumes[i], segment.from, segment.to);
    if (!c) continue;
    probe.parts.push_back({c->range.x, c->range.y, int(i), std::move(name)});
    addCoverage(map.volumes[i], *c, covered);
  }
  probe.covered = united(std::move(covered));
  probe.x = positionsOf(probe.covered, count);
  for (const double tau : shadow::cumulativeOpticalDepth(map.volumes, segment.from, segment.to, probe.x))
    probe.exact.push_back(std::exp(-tau));
  if (!marched) {
    std::vector<vec4> positions;
    // Relative to where the ray begins: far from the world's origin floats are coarse.
    const dvec3 along = segment.to - segment.from;
    for (const double x : probe.x) positions.push_back(vec4(vec3(along * x), 0));
    PILEUS_TRY(const std::vector<float> mapped, lookupTransmittance(gpu, map, positions, segment.from));
    probe.mapped.assign(mapped.begin(), mapped.end());
    probe.taps = shadow::readTaps(map, at.face, uv);
    measure(probe);
  }
  for (const double x : probe.x)
    probe.u.push_back(probe.taps.taps.empty() ? x : shadow::tapU(map, probe.taps.taps.front(), x));
  return probe;
}

std::vector<double> mutedTransmittance(const RayProbe& probe, std::span<const char> muted) {
  std::vector<double> out;
  for (const double x : probe.x) out.push_back(shadow::tapsTransmittance(*probe.map, probe.taps, x, muted));
  return out;
}

ExtinctionOverU extinctionOverU(const RayProbe& probe, std::span<const char> muted, int count) {
  ExtinctionOverU out;
  // Exact: optical depth binned over u.
  std::vector<double> bins(std::size_t(count), 0.0);
  for (std::size_t i = 0; i + 1 < probe.x.size(); ++i) {
    const double tau = std::log(std::max(probe.exact[i], 1e-300) / std::max(probe.exact[i + 1], 1e-300));
    const double u0 = probe.u[i] * count, u1 = probe.u[i + 1] * count;
    // What lies behind a horizon is no part of g.
    if (!(tau > 0) || (probe.map->horizon && probe.u[i] >= 1 - 1e-9)) continue;
    // A step with mass where the metric stands still: all of it falls into one bin.
    const int first = std::clamp(int(std::floor(std::min(u0, u1))), 0, count - 1),
              last = std::clamp(int(std::ceil(std::max(u0, u1))) - 1, first, count - 1);
    for (int b = first; b <= last; ++b) {
      const double part =
          first == last
              ? 1
              : std::max(std::min(std::max(u0, u1), b + 1.0) - std::max(std::min(u0, u1), double(b)), 0.0) /
                    std::abs(u1 - u0);
      bins[std::size_t(b)] += tau * part;
    }
  }
  for (int b = 0; b < count; ++b) {
    out.u.push_back((b + 0.5) / count);
    out.exact.push_back(bins[std::size_t(b)] * count);
  }
  const ShadowMap& map = *probe.map;
  if (map.kind != ShadowMap::Kind::Extinction || probe.taps.taps.empty()) return out;
  for (const double u : out.u)
    out.mapped.push_back(shadow::tapExtinction(map, probe.taps.taps.front(), u, muted));
  return out;
}

}  // namespace pileus::truth
