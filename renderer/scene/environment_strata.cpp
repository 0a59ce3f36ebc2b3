#include "renderer/scene/environment_strata.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pileus::scene {
namespace {

constexpr ivec2 kSmallest{128, 64};  // below, a texel is no direction
constexpr int kMostStrata = 4096;

/// A number in [0, 1) that looks random (the finaliser of SplitMix64, Steele, Lea and Flood 2014).
double scattered(std::uint64_t n) {
  n += 0x9e3779b97f4a7c15u;
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9u;
  n = (n ^ (n >> 27)) * 0x94d049bb133111ebu;
  return double((n ^ (n >> 31)) >> 11) * 0x1p-53;
}

/// Its four binary digits in the other order.
unsigned reversed(unsigned n) {
  static_assert(kStratumParts == 16);
  return (n & 1) << 3 | (n & 2) << 1 | (n & 4) >> 1 | (n & 8) >> 3;
}

double fraction(double x) { return x - std::floor(x); }

}  // namespace

EnvironmentStrata::EnvironmentStrata(const EnvironmentMap& map, int count)
    : map_(refined(reduced(map, kSize), kSmallest)) {
  const int w = map_.size.x, h = map_.size.y;
  const std::size_t stride = std::size_t(w) + 1;
  const std::array<Sums*, 7> all{&energy_,    &flux_[0],   &flux_[1],  &flux_[2],
                                 &toward_[0], &toward_[1], &toward_[2]};
  for (Sums* s : all) s->assign(stride * (std::size_t(h) + 1), 0);
  for (int y = 0; y < h; ++y) {
    std::array<double, 7> row{};
    const double solid = texelSolidAngle(map_.size, y);
    for (int x = 0; x < w; ++x) {
      const vec3& radiance = map_.at(x, y);
      const dvec3 d = environmentDirection({(x + 0.5) / w, (y + 0.5) / h});
      const double e = solid * environmentImportance(radiance);
      const std::array<double, 7> here{e,
                                       solid * double(radiance.x),
                                       solid * double(radiance.y),
                                       solid * double(radiance.z),
                                       e * d.x,
                                       e * d.y,
                                       e * d.z};
      const std::size_t at = std::size_t(y) * stride + std::size_t(x) + 1;
      for (std::size_t i = 0; i < all.size(); ++i) {
        row[i] += here[i];
        (*all[i])[at + stride] = (*all[i])[at] + row[i];
      }
    }
  }
  if (energy_.empty() || !(energy_.back() > 0)) return;
  divide({0, 0}, dvec2(map_.size), std::clamp(count, 1, kMostStrata));
}

double EnvironmentStrata::within(const Sums& sums, const dvec2& low, const dvec2& high) const {
  const std::size_t stride = std::size_t(map_.size.x) + 1;
  const auto upTo = [&](double x, double y) {
    const int i = std::clamp(int(x), 0, map_.size.x - 1), j = std::clamp(int(y), 0, map_.size.y - 1);
    const double* s = sums.data() + std::size_t(j) * stride + std::size_t(i);
    const double fx = x - i, fy = y - j;
    return (1 - fy) * ((1 - fx) * s[0] + fx * s[1]) + fy * ((1 - fx) * s[stride] + fx * s[stride + 1]);
  };
  return upTo(high.x, high.y) - upTo(low.x, high.y) - upTo(high.x, low.y) + upTo(low.x, low.y);
}

/// Energy times what its directions lack to be one: what a cut should make small.
double EnvironmentStrata::spread(const dvec2& low, const dvec2& high) const {
  const dvec3 toward(within(toward_[0], low, high), within(toward_[1], low, high),
                     within(toward_[2], low, high));
  return within(energy_, low, high) - glm::length(toward);
}

/// Where a line across `axis` has that share of the energy below it: a point on it.
dvec2 EnvironmentStrata::cut(const dvec2& low, const dvec2& high, int axis, double share) const {
  const double wanted = share * within(energy_, low, high);
  double lo = low[axis], hi = high[axis];
  for (int i = 0; i < 60 && hi - lo > 1e-12 * hi; ++i) {
    const double mid = (lo + hi) / 2;
    dvec2 end = high;
    end[axis] = mid;
    (within(energy_, low, end) < wanted ? lo : hi) = mid;
  }
  dvec2 out = low;
  out[axis] = (lo + hi) / 2;
  return out;
}

/// The first has that share of the energy; of the two ways to cut, the one that leaves the narrower halves.
std::array<Stratum, 2> EnvironmentStrata::halves(const dvec2& low, const dvec2& high, double share) const {
  std::array<Stratum, 2> out;
  double best = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    const dvec2 begin = cut(low, high, axis, share);
    dvec2 end = high;
    end[axis] = begin[axis];
    const double s = spread(low, end) + spread(begin, high);
    if (s >= best) continue;
    best = s;
    out[0].low = low;
    out[0].high = end;
    out[1].low = begin;
    out[1].high = high;
  }
  return out;
}

void EnvironmentStrata::divide(const dvec2& low, const dvec2& high, int count) {
  if (count == 1) {
    strata_.push_back(measured(low, high));
    return;
  }
  const int first = count / 2;
  const auto both = halves(low, high, double(first) / count);
  divide(both[0].low, both[0].high, first);
  divide(both[1].low, both[1].high, count - first);
}

Stratum EnvironmentStrata::part(const Stratum& whole, unsigned number) const {
  dvec2 low = whole.low, high = whole.high;
  for (unsigned bit = kStratumParts / 2; bit > 0; bit /= 2) {
    const Stratum half = halves(low, high, 0.5)[number & bit ? 1 : 0];
    low = half.low;
    high = half.high;
  }
  return measured(low, high);
}

Stratum EnvironmentStrata::measured(const dvec2& low, const dvec2& high) const {
  Stratum out{low, high, dvec3(0), within(energy_, low, high), dvec3(0, 1, 0), 0};
  dvec3 toward(0);
  for (int c = 0; c < 3; ++c) {
    out.flux[c] = std::max(within(flux_[c], low, high), 0.0);
    toward[c] = within(toward_[c], low, high);
  }
  if (const double length = glm::length(toward); length > 1e-9 * out.energy) {
    out.mean = toward / length;
    out.narrow = std::min(length / out.energy, 1.0);
  }
  return out;
}

StratumSample EnvironmentStrata::sample(const Stratum& s, double a, double b) const {
  const double y = std::clamp(cut(s.low, s.high, 1, a).y, s.low.y, s.high.y);
  // Within that row, a sliver of it: energy is even down the row, so the sliver's cuts are the row's.
  const int row = std::min(int(y), map_.size.y - 1);
  const double x = std::clamp(cut({s.low.x, row}, {s.high.x, row + 1.0}, 0, b).x, s.low.x, s.high.x);
  const int column = std::min(int(x), map_.size.x - 1);
  StratumSample out;
  const double sine = glm::mix(rowSine(map_.size.y, row), rowSine(map_.size.y, row + 1), y - row);
  const double azimuth = (0.5 - x / map_.size.x) * 2 * kPi,
               across = std::sqrt(std::max(1 - sine * sine, 0.0));
  out.direction = {across * std::sin(azimuth), sine, across * std::cos(azimuth)};
  out.radiance = map_.at(column, row);
  out.pdf = environmentImportance(out.radiance) / s.energy;
  return out;
}

std::vector<EnvironmentLight> draftLights(const EnvironmentStrata& strata) {
  std::vector<EnvironmentLight> out;
  for (const Stratum& s : strata.strata()) out.push_back({s.mean, vec3(s.flux), s.narrow});
  return out;
}

std::vector<EnvironmentLight> environmentLights(const EnvironmentStrata& strata, unsigned set) {
  std::vector<EnvironmentLight> out;
  const unsigned round = set / kStratumParts, turn = set % kStratumParts;
  for (std::size_t i = 0; i < strata.strata().size(); ++i) {
    // Parts lie as halves of halves: with the digits of their number turned over, two that follow each other
    // are far apart.
    const unsigned part = reversed(turn) ^ unsigned(scattered(i) * kStratumParts);
    const std::uint64_t seed = 3 * (std::uint64_t(i) * kStratumParts + part) + (std::uint64_t(1) << 40);
    Stratum place = strata.part(strata.strata()[i], part);
    double share = kStratumParts;
    if (round > 0) {
      place = strata.part(place,
                          reversed((round - 1) % kStratumParts) ^ unsigned(scattered(seed) * kStratumParts));
      share *= kStratumParts;
    }
    EnvironmentLight light{place.mean, vec3(place.flux * share), place.narrow};
    if (round > kStratumParts) {
      // Points of the plane that any number of first ones covers evenly (the sequence R2, Roberts 2018),
      // shifted for each part.
      constexpr double kPlastic = 1.32471795724474602596;
      const StratumSample one = strata.sample(place, fraction(scattered(seed + 1) + round / kPlastic),
                                              fraction(scattered(seed + 2) + round / (kPlastic * kPlastic)));
      if (one.pdf > 0)  // it is 0 on an edge between texels, by rounding
        light = {one.direction, one.radiance * float(share / one.pdf),
                 std::pow(place.narrow, double(kStratumParts) / round)};
    }
    out.push_back(light);
  }
  return out;
}

std::shared_ptr<const EnvironmentStrata> strataOf(const Environment& environment) {
  return environment.strata ? environment.strata
                            : std::make_shared<const EnvironmentStrata>(*environment.map);
}

std::vector<Light> standIns(const Environment& environment, const EnvironmentStrata& strata,
                            std::optional<unsigned> set) {
  std::vector<Light> out;
  for (const EnvironmentLight& part : set ? environmentLights(strata, *set) : draftLights(strata)) {
    Light sun;
    sun.towards = turned(part.towards, environment.rotation);
    sun.emitted = part.irradiance * environment.scale;
    sun.narrow = part.narrow;
    out.push_back(sun);
  }
  return out;
}

Light mainSun(const Environment& environment) {
  const std::vector<Light> suns = standIns(environment, *strataOf(environment), std::nullopt);
  if (suns.empty()) return {.emitted = vec3(0.0f)};
  dvec3 towards(0);
  for (const Light& sun : suns) towards += environmentImportance(sun.emitted) * sun.towards;
  return *std::max_element(suns.begin(), suns.end(), [&](const Light& a, const Light& b) {
    return glm::dot(a.towards, towards) < glm::dot(b.towards, towards);
  });
}

}  // namespace pileus::scene
