#include "renderer/truth/tune_model.h"

#include <algorithm>
#include <cmath>

namespace pileus::truth {
namespace {

using shadow::ShadowSpec;

bool isExtinction(const ShadowSpec& s) { return s.kind == ShadowSpec::Kind::Extinction; }

int& coefficients(ShadowSpec& s) { return isExtinction(s) ? s.extinction.coefficients : s.coefficients; }

}  // namespace

void TuneModel::fitResolution(const std::vector<TunePoint>& points) {
  // Least squares of p95^2 over 1 / r^2: the slope is B^2.
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const TunePoint& p : points) {
    const double r = shadow::resolutionOf(p.spec), x = 1 / (r * r), y = p.p95 * p.p95;
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double d = n * sxx - sx * sx;
  b2_ = d > 0 ? std::max((n * sxy - sx * sy) / d, 0.0) : 0.0;
}

void TuneModel::add(const TunePoint& point) {
  const int r = shadow::resolutionOf(point.spec);
  const double texels = double(r) * r;
  // Where texels make nearly all of the error, the rest is not resolved: a tenth of it is left.
  const double a2 = std::max(point.p95 * point.p95 - b2_ / texels, 0.01 * point.p95 * point.p95);
  Known k{shadow::withResolution(point.spec, 0),
          a2,
          point.buildMs / texels,
          point.bytes / texels,
          point.nsPerLookup,
          r};
  const auto same =
      std::find_if(known_.begin(), known_.end(), [&](const Known& o) { return o.spec == k.spec; });
  if (same == known_.end())
    known_.push_back(k);
  else if (r >= same->resolution)
    *same = k;
}

std::optional<TuneModel::Known> TuneModel::find(const ShadowSpec& spec) const {
  for (const Known& k : known_)
    if (k.spec == spec) return k;
  return std::nullopt;
}

std::optional<TuneModel::Known> TuneModel::known(const ShadowSpec& spec) const {
  if (auto k = find(spec)) return k;
  // Interval ends in 8 bits, or float instead of half: what that changes where it was tried.
  const bool compact = spec.metric.compact;
  if (isExtinction(spec) && (compact || spec.extinction.storage == shadow::Storage::Float)) {
    const auto simpler = [compact](ShadowSpec s) {
      if (compact)
        s.metric.compact = false;
      else
        s.extinction.storage = s.metric.storage = shadow::Storage::Half;
      return s;
    };
    auto k = known(simpler(spec));
    if (!k) return std::nullopt;
    double change = 0;
    for (const Known& o : known_) {
      if (!isExtinction(o.spec) || simpler(o.spec) == o.spec) continue;
      if (const auto twin = find(simpler(o.spec)); twin && std::abs(o.a2 - twin->a2) > std::abs(change))
        change = o.a2 - twin->a2;
    }
    k->a2 = std::max(k->a2 + change, 0.01 * k->a2);
    return k;
  }
  // Fewer intervals: what that costs the most accurate series of the same weights. Cosines of each interval
  // have none in common.
  if (isExtinction(spec) && spec.metric.metric == shadow::Metric::Interval && spec.metric.intervals != 8 &&
      spec.extinction.basis != shadow::Basis::Piecewise) {
    ShadowSpec eight = spec, probe = spec;
    eight.metric.intervals = 8;
    probe.metric.horizon = 0;
    probe.extinction.basis = shadow::Basis::Cosine;
    probe.extinction.coefficients = 32;
    ShadowSpec probeEight = probe;
    probeEight.metric.intervals = 8;
    const auto few = find(probe), many = find(probeEight);
    auto k = known(eight);
    if (!few || !many || !k) return std::nullopt;
    k->a2 += std::max(few->a2 - many->a2, 0.0);
    return k;
  }
  // Between two counts of coefficients: evenly in logarithms.
  std::optional<Known> below, above;
  int lower = 0, upper = 0;
  for (const Known& o : known_) {
    ShadowSpec same = o.spec, wanted = spec;
    const int n = coefficients(same), w = coefficients(wanted);
    coefficients(same) = w;
    if (!(same == wanted)) continue;
    if (n < w && n > lower) below = o, lower = n;
    if (n > w && (upper == 0 || n < upper)) above = o, upper = n;
  }
  if (!below || !above) return std::nullopt;
  ShadowSpec copy = spec;
  const double t = std::log(double(coefficients(copy)) / lower) / std::log(double(upper) / lower);
  const auto blend = [t](double a, double b) {
    return std::exp((1 - t) * std::log(std::max(a, 1e-16)) + t * std::log(std::max(b, 1e-16)));
  };
  Known k = *below;
  k.a2 = blend(below->a2, above->a2);
  k.buildMs = blend(below->buildMs, above->buildMs);
  k.nsPerLookup = blend(below->nsPerLookup, above->nsPerLookup);
  return k;
}

std::optional<TunePoint> TuneModel::expect(const ShadowSpec& spec) const {
  const auto k = known(shadow::withResolution(spec, 0));
  if (!k) return std::nullopt;
  const double r = shadow::resolutionOf(spec), texels = r * r;
  TunePoint p{spec, std::sqrt(k->a2 + b2_ / texels), k->buildMs * texels, k->nsPerLookup, 0};
  // By layout where that decides; a deep map by what it took.
  const double faces = k->bytes > 0 && shadow::bytesPerTexel(k->spec) > 0
                           ? k->bytes / double(shadow::bytesPerTexel(k->spec))
                           : 1;
  const double layout = double(shadow::bytesPerTexel(spec));
  p.bytes = texels * (layout > 0 ? layout * faces : k->bytes);
  return p;
}

}  // namespace pileus::truth
