#include "renderer/shadow/representation.h"

#include <fmt/core.h>

namespace pileus::shadow {
namespace {

std::string storageSuffix(Storage s) { return s == Storage::Half ? ", half" : ""; }

std::string describeMetric(const MetricOptions& m) {
  switch (m.metric) {
    case Metric::Interval: {
      std::string text = fmt::format("interval K={}", m.intervals);
      if (m.compact) text += " in 8 bits";
      if (m.weighting == Weighting::Root) text += ", weights";
      if (m.horizon > 0) text += fmt::format(", horizon {:g}", m.horizon);
      return text;
    }
    case Metric::Fourier:
      return fmt::format("Fourier {}", m.coefficients);
    case Metric::Cosine:
      return fmt::format("cosine {}", m.coefficients);
    case Metric::None:
      break;
  }
  return "Euclidean";
}

std::string describeBasis(Basis b, int n) {
  switch (b) {
    case Basis::Cosine:
      return fmt::format("{} cosines", n);
    case Basis::Fourier:
      return fmt::format("{} Fourier", n);
    case Basis::Piecewise:
      return fmt::format("{} cosines per interval", n);
    case Basis::Slab:
      break;
  }
  return fmt::format("{} slabs", n);
}

std::size_t layers(int values) { return std::size_t((values + 3) / 4); }
std::size_t layerBytes(Storage s) { return s == Storage::Float ? 16 : 8; }

}  // namespace

ShadowSpec withResolution(ShadowSpec spec, int resolution) {
  spec.resolution = spec.metric.resolution = spec.extinction.resolution = resolution;
  return spec;
}

int resolutionOf(const ShadowSpec& spec) {
  if (spec.kind == ShadowSpec::Kind::RayMarch) return 0;
  return spec.kind == ShadowSpec::Kind::Extinction ? spec.extinction.resolution : spec.resolution;
}

std::string describe(const ShadowSpec& s) {
  using K = ShadowSpec::Kind;
  switch (s.kind) {
    case K::Extinction:
      return describeMetric(s.metric) + " + " + describeBasis(s.extinction.basis, s.extinction.coefficients) +
             (s.extinction.damping ? ", damped" : "") + storageSuffix(s.extinction.storage);
    case K::FourierOpacity:
      return fmt::format("Fourier opacity {}", s.coefficients) + (s.range ? ", near-far" : "") +
             (s.damping ? ", damped" : "") + storageSuffix(s.storage);
    case K::TransmittanceFunction:
      return fmt::format("transmittance function {}", s.coefficients) +
             (s.basis == Basis::Cosine ? ", cosine" : "") + storageSuffix(s.storage);
    case K::Deep:
      return fmt::format("deep, bound {:g}", s.errorBound) +
             (s.filter > 1 ? fmt::format(", {}x{} rays", s.filter, s.filter) : "");
    case K::RayMarch:
      break;
  }
  return "ray march";
}

std::size_t bytesPerTexel(const ShadowSpec& s) {
  using K = ShadowSpec::Kind;
  switch (s.kind) {
    case K::Extinction: {
      const MetricOptions& m = s.metric;
      std::size_t bytes = layers(s.extinction.coefficients) * layerBytes(s.extinction.storage);
      if (m.metric == Metric::None) return bytes;
      if (m.metric != Metric::Interval) return bytes + layers(m.coefficients) * layerBytes(m.storage);
      bytes += layers(2 * m.intervals) * (m.compact ? 4 : layerBytes(m.storage));
      if (m.weighting != Weighting::None) bytes += 4 * layers(m.intervals);
      if (m.horizon > 0) bytes += 4;
      return bytes;
    }
    case K::FourierOpacity:
      return layers(s.coefficients) * layerBytes(s.storage) + (s.range ? layerBytes(s.storage) : 0);
    case K::TransmittanceFunction:
      return layers(s.coefficients) * layerBytes(s.storage);
    case K::Deep:
    case K::RayMarch:
      break;
  }
  return 0;
}

}  // namespace pileus::shadow
