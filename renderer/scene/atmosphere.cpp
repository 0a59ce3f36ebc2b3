#include "renderer/scene/atmosphere.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "renderer/scene/color_matching.h"

namespace pileus::scene {
namespace {

constexpr ivec2 kBeamSize{128, 64};                                 // cosines, heights
constexpr ivec2 kScatteredSize{40, 20};                             // the same
constexpr int kBeamSteps = 40, kGatherSteps = 10, kViewSteps = 40;  // along each piece of a ray
constexpr int kUp = 8, kDown = 6, kAround = 4;                      // directions that are gathered
constexpr float kEvenly = float(1 / (4 * kPi));                     // [1/sr]
constexpr int kOrders = 4;                                          // that are added one by one

double radiusOf(double height) { return kEarthRadius + height; }

/// A ray from a height, as x: the distance from where it comes next to the Earth's centre.
struct Ray {
  double low = 0;  ///< radius at x = 0
  double begin = 0, end = 0;
  bool ground = false;  ///< it ends there
  Ray(double height, double view) {
    const double r = radiusOf(height);
    low = r * std::sqrt(std::max(1 - view * view, 0.0));
    begin = r * view;
    ground = view < horizonCosine(height);
    end = ground ? -std::sqrt(std::max(kEarthRadius * kEarthRadius - low * low, 0.0))
                 : std::sqrt(std::max(radiusOf(kAirTop) * radiusOf(kAirTop) - low * low, 0.0));
    end = std::max(end, begin);
  }
  double heightAt(double x) const { return std::max(std::hypot(low, x) - kEarthRadius, 0.0); }
};

/// Calls f(x, length) for steps from the beginning to the end, close where the ray is low and air is dense.
template <class F>
void forEachStep(const Ray& ray, int steps, F&& f) {
  const auto piece = [&](double from, double to) {
    if (!(to > from)) return;
    const bool rising = from >= 0;
    const double low = rising ? from : to, high = rising ? to : from;
    for (int i = 0; i < steps; ++i) {
      const int k = rising ? i : steps - 1 - i;
      const auto at = [&](double s) { return low + (high - low) * s * s; };
      f(at((k + 0.5) / steps), std::abs(at(double(k + 1) / steps) - at(double(k) / steps)));
    }
  };
  piece(std::min(ray.begin, 0.0), std::min(ray.end, 0.0));
  piece(std::max(ray.begin, 0.0), std::max(ray.end, 0.0));
}

Spectrum interpolated(const std::vector<Spectrum>& values, ivec2 size, double x, double y) {
  const double cx = std::clamp(x, 0.0, double(size.x - 1)), cy = std::clamp(y, 0.0, double(size.y - 1));
  const int i = std::min(int(cx), std::max(size.x - 2, 0)), j = std::min(int(cy), std::max(size.y - 2, 0));
  const float fx = float(cx - i), fy = float(cy - j);
  const Spectrum* row = values.data() + std::size_t(j) * std::size_t(size.x) + std::size_t(i);
  const Spectrum *a = row, *b = row + (size.x > 1), *c = row + (size.y > 1 ? size.x : 0),
                 *d = c + (size.x > 1);
  Spectrum out;
  for (std::size_t w = 0; w < kWaves; ++w) {
    const float upper = (*a)[w] + fx * ((*b)[w] - (*a)[w]), lower = (*c)[w] + fx * ((*d)[w] - (*c)[w]);
    out[w] = upper + fy * (lower - upper);
  }
  return out;
}

/// Cosines are close at the horizon, heights at the ground.
double scatteredCosine(int i) {
  const double x = 2.0 * i / (kScatteredSize.x - 1) - 1;
  return x * std::abs(x);
}
double scatteredHeight(int j) {
  const double s = double(j) / (kScatteredSize.y - 1);
  return kAirTop * s * s;
}
Spectrum scatteredAt(const std::vector<Spectrum>& values, int rows, double row, double cosine) {
  const double x = std::copysign(std::sqrt(std::abs(cosine)), cosine);
  return interpolated(values, {kScatteredSize.x, rows}, (x + 1) / 2 * (kScatteredSize.x - 1), row);
}

/// To the horizon, from the top of the air; metres.
const double kMostToHorizon = std::sqrt(kAirTop * (2 * kEarthRadius + kAirTop));

TableHeight tableHeight(double height) {
  const double h = std::clamp(height, 0.0, kAirTop), toHorizon = std::sqrt(h * (2 * kEarthRadius + h));
  return {h,
          radiusOf(h),
          horizonCosine(h),
          toHorizon,
          toHorizon / kMostToHorizon * (kBeamSize.y - 1),
          std::sqrt(h / kAirTop) * (kScatteredSize.y - 1)};
}

/// Transmittance of the sun's beam times the visible part of its disc.
Spectrum beam(const std::vector<Spectrum>& table, const TableHeight& at, double cosine) {
  constexpr double kRadius = kSunDiameter / 2 * kPi / 180;
  // Angles differ by no less than their sines.
  if (cosine - at.horizon < -kRadius) return {};
  const double part = cosine - at.horizon > kRadius ? 1.0 : visibleDisc(at.height, cosine);
  double mu = cosine;
  if (part < 1) {  // the middle of what is seen of the disc
    const double lowest = std::clamp((at.horizon - cosine) / kRadius, -1.0, 1.0);
    mu += part > 1e-6 ? kRadius * 2 / 3 * std::pow(1 - lowest * lowest, 1.5) / (kPi * part) : kRadius;
  }
  mu = std::clamp(mu, at.horizon, 1.0);
  const double top = radiusOf(kAirTop), least = kAirTop - at.height;
  const double d =
      std::sqrt(std::max(top * top - at.radius * at.radius * (1 - mu * mu), 0.0)) - at.radius * mu;
  Spectrum out =
      interpolated(table, kBeamSize,
                   (d - least) / (at.toHorizon + kMostToHorizon - least) * (kBeamSize.x - 1), at.beamRow);
  if (part < 1)
    for (float& v : out) v *= float(part);
  return out;
}

}  // namespace

dvec3 spectrumColor(const Spectrum& s) {
  // Cubic between the wavelengths, under the matching functions and the sun's spectrum.
  static const std::array<dvec3, kWaves> weights = [] {
    std::array<dvec3, kWaves> out{};
    for (double nm = 360; nm <= 830; nm += 2) {
      const double t = std::clamp((nm - kFirstWave) / kWaveStep, 0.0, kWaves - 1.0);
      const int i = std::min(int(t), kWaves - 2);
      const double f = t - i;
      // Catmull and Rom's; at both ends straight on.
      double w[4] = {f * (-0.5 + f * (1 - 0.5 * f)), 1 + f * f * (-2.5 + 1.5 * f),
                     f * (0.5 + f * (2 - 1.5 * f)), f * f * (-0.5 + 0.5 * f)};
      if (i == 0) w[1] += 2 * w[0], w[2] -= w[0], w[0] = 0;
      if (i == kWaves - 2) w[2] += 2 * w[3], w[1] -= w[3], w[3] = 0;
      for (int k = 0; k < 4; ++k)
        if (i + k - 1 >= 0 && i + k - 1 < kWaves)
          out[std::size_t(i + k - 1)] += w[k] * 2 * solarIrradiance(nm) * colorMatching(nm);
    }
    dvec3 white(0);
    for (const dvec3& w : out) white += colorOfSunlit(w);
    for (dvec3& w : out) w = colorOfSunlit(w) * sunColor() / white;
    return out;
  }();
  dvec3 out(0);
  for (std::size_t w = 0; w < kWaves; ++w) out += double(s[w]) * weights[w];
  return glm::max(out, dvec3(0));
}

Atmosphere::Atmosphere(const Air& air)
    : air_(air), molecular_(molecularPhase()), aerosol_(aerosolPhase()), aerosolMean_(meanCosine(aerosol_)) {
  for (int w = 0; w < kWaves; ++w) {
    const double nm = kFirstWave + w * kWaveStep;
    waves_.of[w] = coefficients(air, nm);
    // Ozone's bands are narrower than the steps: its mean over them.
    double mean = 0;
    for (int i = -7; i <= 7; ++i)
      mean += (8 - std::abs(i)) / 64.0 * coefficients(air, nm + i * kWaveStep / 8).ozone;
    waves_.of[w].ozone = mean;
  }
  sun_ = transmittances(false);
  straight_ = transmittances(true);
  scatterAll();
}

/// Of rays that go up to space. `reduced`: what aerosols send straight on counts as not scattered.
/// Coordinates are those of Bruneton and Neyret 2008: the distance to the horizon for heights, that to space
/// between its least and its most for cosines.
Atmosphere::Table Atmosphere::transmittances(bool reduced) const {
  Table out{kBeamSize, std::vector<Spectrum>(std::size_t(kBeamSize.x) * std::size_t(kBeamSize.y))};
  tbb::parallel_for(0, kBeamSize.y, [&](int j) {
    const double toHorizon = kMostToHorizon * j / (kBeamSize.y - 1);
    const double r = std::hypot(toHorizon, kEarthRadius), height = r - kEarthRadius;
    const double least = std::max(kAirTop - height, 0.0), longest = toHorizon + kMostToHorizon;
    for (int i = 0; i < kBeamSize.x; ++i) {
      const double d = glm::mix(least, longest, double(i) / (kBeamSize.x - 1)), top = radiusOf(kAirTop);
      const double cosine = d > 0 ? std::clamp((top * top - r * r - d * d) / (2 * r * d), -1.0, 1.0) : 1.0;
      Ray ray(height, std::max(cosine, horizonCosine(height)));
      Densities columns;
      forEachStep(ray, kBeamSteps, [&](double x, double length) {
        const Densities here = densities(ray.heightAt(x));
        columns.molecules += length * here.molecules;
        columns.aerosol += length * here.aerosol;
        columns.ozone += length * here.ozone;
      });
      Spectrum& t = out.values[std::size_t(j) * std::size_t(kBeamSize.x) + std::size_t(i)];
      for (std::size_t w = 0; w < kWaves; ++w) {
        const Coefficients& c = waves_.of[w];
        t[w] = float(std::exp(-c.molecules * columns.molecules - c.ozone * columns.ozone -
                              (c.aerosolExtinction - (reduced ? aerosolMean_ * c.aerosolScattering : 0)) *
                                  columns.aerosol));
      }
    }
  });
  return out;
}

Spectrum Atmosphere::sunlight(double height, double cosine) const {
  return beam(sun_.values, tableHeight(height), cosine);
}

Atmosphere::Path Atmosphere::path(double height, double view, Orders orders) const {
  return path(height, view, kViewSteps, orders);
}

Atmosphere::Path Atmosphere::path(double height, double view, int steps, Orders orders) const {
  const double h = std::clamp(height, 0.0, kAirTop);
  const Ray ray(h, view);
  Path out{orders, radiusOf(h), ray.begin, ray.end, ray.ground, {}, {}};
  Spectrum through;
  through.fill(1);
  forEachStep(ray, steps, [&](double x, double length) {
    Path::Step step{tableHeight(ray.heightAt(x)), x, {}, {}};
    const Densities here = densities(step.at.height);
    for (std::size_t w = 0; w < kWaves; ++w) {
      const Coefficients& c = waves_.of[w];
      const double forward = orders == Orders::All ? aerosolMean_ * c.aerosolScattering : 0;
      const double extinction = c.molecules * here.molecules + c.ozone * here.ozone +
                                (c.aerosolExtinction - forward) * here.aerosol;
      // The integral of the transmittance within the step.
      const double t = extinction * length;
      const double arrives = double(through[w]) * length * (t > 1e-6 ? -std::expm1(-t) / t : 1.0);
      step.molecules[w] = float(arrives * c.molecules * here.molecules);
      step.aerosol[w] = float(arrives * c.aerosolScattering * here.aerosol);
      through[w] *= float(std::exp(-t));
    }
    out.steps.push_back(step);
  });
  if (ray.ground) out.left = through;
  return out;
}

/// All orders above the first, of light that is scattered evenly in all directions: what aerosols send
/// forward, the mean cosine of their phase function, is taken for not scattered. Order after order, and the
/// rest as a geometric series.
void Atmosphere::scatterAll() {
  const Table& reduced = straight_;
  const float dust = float(1 - aerosolMean_);  // of what aerosols scatter
  const std::size_t columns = std::size_t(kScatteredSize.x), rows = std::size_t(kScatteredSize.y);
  using Field = std::vector<Spectrum>;
  /// The rays that are gathered at one height, the same for all places of the sun.
  struct Gathered {
    double view, solid;
    Path path;
  };
  std::vector<std::vector<Gathered>> rays(rows);
  tbb::parallel_for(std::size_t(0), rows, [&](std::size_t j) {
    const double height = scatteredHeight(int(j)), horizon = horizonCosine(height);
    for (int n = 0; n < kUp + kDown; ++n) {
      const bool up = n < kUp;
      const double t = up ? (n + 0.5) / kUp : (n - kUp + 0.5) / kDown,
                   reach = up ? 1 - horizon : -1 - horizon;
      const double view = horizon + reach * t * t;
      const double share = std::abs(reach) * 2 * t / (up ? kUp : kDown);  // of the cosine
      rays[j].push_back({view, 2 * kPi * share / kAround, path(height, view, kGatherSteps, Orders::All)});
    }
  });

  // Order n: `mean` is the mean radiance of light that was scattered n - 1 times (of the beam itself at
  // first), `earth` the radiance of the ground that it lights.
  Field mean(columns * rows), earth(columns);
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      mean[j * columns + i] =
          beam(reduced.values, tableHeight(scatteredHeight(int(j))), scatteredCosine(int(i)));
      for (float& v : mean[j * columns + i]) v *= kEvenly;
    }
  for (std::size_t i = 0; i < columns; ++i) {
    const double cosine = scatteredCosine(int(i));
    const Spectrum sun = beam(reduced.values, tableHeight(0), cosine);
    for (std::size_t w = 0; w < kWaves; ++w)
      earth[i][w] = float(double(sun[w]) * std::max(cosine, 0.0) * air_.groundAlbedo / kPi);
  }
  Field sumMean(mean.size(), Spectrum{}), sumEarth(earth.size(), Spectrum{});
  for (int order = 1; order <= kOrders; ++order) {
    Field nextMean(mean.size(), Spectrum{}), nextEarth(earth.size(), Spectrum{});
    tbb::parallel_for(std::size_t(0), rows, [&](std::size_t j) {
      const double r = radiusOf(scatteredHeight(int(j)));
      for (std::size_t i = 0; i < columns; ++i) {
        const double sun = scatteredCosine(int(i)), across = std::sqrt(std::max(1 - sun * sun, 0.0));
        std::array<double, kWaves> sum{}, down{};
        for (const Gathered& g : rays[j])
          for (int a = 0; a < kAround; ++a) {
            const double toSun =
                g.view * sun + std::sqrt(1 - g.view * g.view) * across * std::cos(kPi * (a + 0.5) / kAround);
            const auto sunAt = [&](double x, double radius) {
              return std::clamp((r * sun + (x - g.path.begin) * toSun) / radius, -1.0, 1.0);
            };
            Spectrum field{};
            for (const Path::Step& s : g.path.steps) {
              // The beam has the edge of the Earth's shadow and is asked for itself.
              const double cosine = sunAt(s.x, s.at.radius);
              const Spectrum source = order == 1
                                          ? beam(reduced.values, s.at, cosine)
                                          : scatteredAt(mean, kScatteredSize.y, s.at.scatteredRow, cosine);
              const float scale = order == 1 ? kEvenly : 1.0f;
              for (std::size_t w = 0; w < kWaves; ++w)
                field[w] += scale * (s.molecules[w] + dust * s.aerosol[w]) * source[w];
            }
            if (g.path.ground) {
              const Spectrum below = scatteredAt(earth, 1, 0, sunAt(g.path.end, kEarthRadius));
              for (std::size_t w = 0; w < kWaves; ++w) field[w] += g.path.left[w] * below[w];
            }
            for (std::size_t w = 0; w < kWaves; ++w) {
              sum[w] += g.solid * double(field[w]);
              if (g.view > 0) down[w] += g.solid * g.view * double(field[w]);
            }
          }
        for (std::size_t w = 0; w < kWaves; ++w) {
          nextMean[j * columns + i][w] = float(sum[w] / (4 * kPi));
          if (j == 0) nextEarth[i][w] = float(down[w] * air_.groundAlbedo / kPi);
        }
      }
    });
    const auto add = [&](Field& all, Field& last, const Field& next) {
      for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t w = 0; w < kWaves; ++w) {
          all[k][w] += next[k][w];
          if (order < kOrders || !(last[k][w] > 0)) continue;
          const float ratio = std::min(next[k][w] / last[k][w], 0.9f);
          all[k][w] += next[k][w] * ratio / (1 - ratio);
        }
      last = next;
    };
    add(sumMean, mean, nextMean);
    add(sumEarth, earth, nextEarth);
  }
  scattered_ = {kScatteredSize, std::move(sumMean)};
  ground_ = {{kScatteredSize.x, 1}, std::move(sumEarth)};
}

Spectrum Atmosphere::radiance(const Path& path, double sun, double fromSun) const {
  // As Nakajima and Tanaka 1988: single scattering by the whole phase function, in a medium that is thinner
  // by what is scattered forward; the rest evenly.
  const std::vector<Spectrum>& beams = (path.orders == Orders::All ? straight_ : sun_).values;
  const auto sunAt = [&](double x, double radius) {
    return std::clamp((path.radius * sun + (x - path.begin) * fromSun) / radius, -1.0, 1.0);
  };
  const float molecular = float(phaseValue(molecular_, fromSun)),
              aerosol = float(phaseValue(aerosol_, fromSun));
  const float dust = float(1 - aerosolMean_);  // what aerosols do not send straight on
  Spectrum out{};
  for (const Path::Step& s : path.steps) {
    const double cosine = sunAt(s.x, s.at.radius);
    const Spectrum lit = beam(beams, s.at, cosine);
    for (std::size_t w = 0; w < kWaves; ++w)
      out[w] += lit[w] * (s.molecules[w] * molecular + s.aerosol[w] * aerosol);
    if (path.orders == Orders::First) continue;
    const Spectrum mean = scatteredAt(scattered_.values, kScatteredSize.y, s.at.scatteredRow, cosine);
    for (std::size_t w = 0; w < kWaves; ++w) out[w] += mean[w] * (s.molecules[w] + dust * s.aerosol[w]);
  }
  if (path.ground) {
    const double cosine = sunAt(path.end, kEarthRadius);
    const Spectrum direct = beam(beams, tableHeight(0), cosine);
    const float lambert = float(std::max(cosine, 0.0) * air_.groundAlbedo / kPi);
    for (std::size_t w = 0; w < kWaves; ++w) out[w] += path.left[w] * direct[w] * lambert;
    if (path.orders == Orders::All) {
      const Spectrum mean = scatteredAt(ground_.values, 1, 0, cosine);
      for (std::size_t w = 0; w < kWaves; ++w) out[w] += path.left[w] * mean[w];
    }
  }
  return out;
}

}  // namespace pileus::scene
