#include "renderer/shadow/reference.h"

#include <algorithm>
#include <cmath>

namespace pileus::shadow {
namespace {

using volume::Brick;
using volume::kBrickSize;
using volume::kStoredSize;

constexpr int kRemapParts = 16;  // of a cell's stretch where densities are remapped

/// Adds up depth along the segment and notes it at the wanted parameters.
class Sum {
 public:
  Sum(std::span<const double> at, std::span<double> out) : at_(at), out_(out) {}

  /// On to t1 through what starts at t0 >= the last t1; `depth(a, b)` is the optical depth of a part.
  template <class Depth>
  void add(double t0, double t1, const Depth& depth) {
    while (next_ < at_.size() && at_[next_] < t1) {
      if (at_[next_] > t0) {
        total_ += depth(t0, at_[next_]);
        t0 = at_[next_];
      }
      out_[next_++] += total_;
    }
    total_ += depth(t0, t1);
  }
  /// Nothing follows. The depth of the whole segment.
  double finish() {
    while (next_ < at_.size()) out_[next_++] += total_;
    return total_;
  }

 private:
  std::span<const double> at_;
  std::span<double> out_;
  std::size_t next_ = 0;
  double total_ = 0;
};

/// Visits the cubes of edge `edge` that o + t d crosses between t0 and t1, in order, among lo .. lo + count -
/// 1: visit(cube, begin, end). Crossings are computed from the cube's number, so that no error adds up
/// (Amanatides & Woo 1987, but for that).
template <class Visit>
void walk(const dvec3& o, const dvec3& d, double t0, double t1, double edge, ivec3 lo, ivec3 count,
          const Visit& visit) {
  ivec3 cube, step;
  dvec3 cross, perUnit;
  for (int a = 0; a < 3; ++a) {
    cube[a] =
        std::clamp(static_cast<int>(std::floor((o[a] + d[a] * t0) / edge)), lo[a], lo[a] + count[a] - 1);
    step[a] = d[a] > 0 ? 1 : -1;
    perUnit[a] = 1.0 / d[a];
    cross[a] = d[a] == 0 ? std::numeric_limits<double>::infinity()
                         : ((cube[a] + (d[a] > 0)) * edge - o[a]) * perUnit[a];
  }
  for (double t = t0; t < t1;) {
    const int axis = cross.x < cross.y ? (cross.x < cross.z ? 0 : 2) : (cross.y < cross.z ? 1 : 2);
    const double end = std::min(cross[axis], t1);
    if (end > t) {
      visit(cube, t, end);
      t = end;
    }
    cube[axis] += step[axis];
    if (cube[axis] < lo[axis] || cube[axis] >= lo[axis] + count[axis]) return;
    cross[axis] = ((cube[axis] + (step[axis] > 0)) * edge - o[axis]) * perUnit[axis];
  }
}

double mix(double a, double b, double t) { return a + t * (b - a); }

/// The eight bytes around a cell of a brick, as the coefficients of a trilinear function.
struct Cell {
  double v[8];

  explicit Cell(const std::byte* first) {
    constexpr std::size_t y = kStoredSize, z = std::size_t(kStoredSize) * kStoredSize;
    const std::size_t at[8] = {0, 1, y, y + 1, z, z + 1, z + y, z + y + 1};
    for (int i = 0; i < 8; ++i) v[i] = static_cast<double>(std::to_integer<int>(first[at[i]]));
  }
  double operator()(const dvec3& f) const {
    return mix(mix(mix(v[0], v[1], f.x), mix(v[2], v[3], f.x), f.y),
               mix(mix(v[4], v[5], f.x), mix(v[6], v[7], f.x), f.y), f.z);
  }
};

/// o + t d in lattice positions of level 0; `scale` takes density per unit of t to optical depth.
void addGrid(const volume::BrickGrid& grid, const volume::DensityRemap* remap, const dvec3& o, const dvec3& d,
             dvec2 range, double scale, Sum& sum) {
  const auto sigma = [&](double density) {
    return std::max(0.0, scale * (remap ? remap->density(density) : density));
  };
  const volume::Level& level = grid.levels.front();
  walk(o, d, range.x, range.y, kBrickSize, ivec3(0), level.bricks, [&](ivec3 at, double b0, double b1) {
    const Brick& brick = level.at(at);
    const double offset = static_cast<double>(brick.offset);
    if (brick.payload == volume::kConstantBrick) {
      const double base = sigma(offset);
      if (base > 0) sum.add(b0, b1, [&](double t0, double t1) { return base * (t1 - t0); });
      return;
    }
    const std::byte* payload = grid.bytes(brick).data();
    const double gain = static_cast<double>(brick.scale) / 255.0;
    const dvec3 origin = o - dvec3(at * kBrickSize);
    walk(origin, d, b0, b1, 1.0, ivec3(0), ivec3(kBrickSize), [&](ivec3 local, double c0, double c1) {
      const ivec3 s = local + volume::kApron;
      const Cell cell(payload + (s.z * kStoredSize + s.y) * kStoredSize + s.x);
      const dvec3 inCell = origin - dvec3(local);
      sum.add(c0, c1, [&](double t0, double t1) {
        // A table bends what was a cubic: parts of the cell then.
        const int parts = remap ? kRemapParts : 1;
        const double half = 0.5 * (t1 - t0) / parts, g = half * 0.57735026918962576451;
        double depth = 0;
        for (int part = 0; part < parts; ++part) {
          const double middle = t0 + (2 * part + 1) * half;
          depth += half * (sigma(offset + gain * cell(inCell + d * (middle - g))) +
                           sigma(offset + gain * cell(inCell + d * (middle + g))));
        }
        return depth;
      });
    });
  });
}

/// A segment in an instance's local space, cut to where the instance can be non-zero.
struct LocalSegment {
  dvec3 o{0}, d{0};
  dvec2 range{0};  ///< parameters; empty (x >= y): misses
};

LocalSegment localSegment(const volume::Instance& i, const dvec3& from, const dvec3& to) {
  LocalSegment s;
  const double det = glm::determinant(glm::dmat3(i.worldFromLocal));
  const Box3 bounds = volume::localBounds(i);
  if (!(std::abs(det) > 0) || !std::isfinite(det) || bounds.empty()) return s;  // flat: holds nothing
  const dmat4 localFromWorld = glm::inverse(i.worldFromLocal);
  s.o = dvec3(localFromWorld * dvec4(from, 1.0));
  s.d = dvec3(localFromWorld * dvec4(to - from, 0.0));
  const auto hit = i.shape == volume::Shape::Ball ? intersectBall(s.o, s.d)
                                                  : intersectBox(s.o, s.d, bounds.min, bounds.max);
  if (hit) s.range = dvec2(std::max(hit->x, 0.0), std::min(hit->y, 1.0));
  return s;
}

double addInstance(const volume::Instance& i, const dvec3& from, const dvec3& to, std::span<const double> at,
                   std::span<double> out) {
  const LocalSegment s = localSegment(i, from, to);
  if (i.emission || !(s.range.x < s.range.y)) return 0;
  Sum sum(at, out);
  const double scale = i.medium.meanExtinction() * glm::length(to - from);
  if (i.shape == volume::Shape::Grid) {
    addGrid(*i.grid, i.remap.get(), s.o - dvec3(i.grid->origin), s.d, s.range, scale, sum);
  } else {
    const double depth = std::max(0.0, i.density * scale);
    sum.add(s.range.x, s.range.y, [&](double t0, double t1) { return depth * (t1 - t0); });
  }
  return sum.finish();
}

}  // namespace

double opticalDepth(const volume::InstanceList& instances, const dvec3& from, const dvec3& to) {
  double tau = 0;
  for (const volume::Instance& i : instances) tau += addInstance(i, from, to, {}, {});
  return tau;
}

std::vector<double> cumulativeOpticalDepth(const volume::InstanceList& instances, const dvec3& from,
                                           const dvec3& to, std::span<const double> at) {
  std::vector<double> tau(at.size(), 0.0);
  for (const volume::Instance& i : instances) addInstance(i, from, to, at, tau);
  return tau;
}

double opticalDepthToLight(const volume::InstanceList& instances, const scene::Light& light,
                           const dvec3& point) {
  if (light.kind != scene::LightKind::Sun) return opticalDepth(instances, point, light.position);
  const Box3 media = volume::worldBounds(instances);
  if (media.empty()) return 0;
  const auto hit = intersectBox(point, light.towards, media.min, media.max);
  return hit && hit->y > 0 ? opticalDepth(instances, point, point + light.towards * hit->y) : 0.0;
}

double ratioTracking(const volume::InstanceList& instances, const dvec3& from, const dvec3& to,
                     std::mt19937_64& rng) {
  double transmittance = 1;
  for (const volume::Instance& i : instances) {
    const LocalSegment s = localSegment(i, from, to);
    const double majorant = volume::majorant(i), perUnit = majorant * glm::length(to - from);
    if (!(s.range.x < s.range.y) || !(perUnit > 0)) continue;
    std::exponential_distribution<double> gap(perUnit);
    for (double t = s.range.x + gap(rng); t < s.range.y; t += gap(rng))
      transmittance *= 1.0 - volume::sigmaAt(i, from + (to - from) * t) / majorant;
  }
  return transmittance;
}

}  // namespace pileus::shadow
