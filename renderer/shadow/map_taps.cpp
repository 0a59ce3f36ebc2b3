#include "renderer/shadow/map_taps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "renderer/shadow/basis.h"
#include "renderer/shadow/metric.h"

namespace pileus::shadow {
namespace {

/// All floats of one texel of a face, layer by layer.
std::vector<float> fetch(const ShadowBlock& block, int face, ivec2 texel) {
  const gpu::BlockRecord r = block.record();
  const ivec2 at = glm::clamp(texel, ivec2(0), ivec2(block.resolution() - 1));
  std::vector<float> out(std::size_t(block.layers()) * 4, 0.0f);
  glGetTextureSubImage(block.texture(), 0, r.place.x + at.x, r.place.y + at.y,
                       r.place.w + face * block.layers(), 1, 1, block.layers(), GL_RGBA, GL_FLOAT,
                       GLsizei(out.size() * sizeof(float)), out.data());
  return out;
}

/// The four texels around uv and how far uv is on from the first: what the hardware's filter blends.
struct Footprint {
  ivec2 base{0};
  dvec2 on{0};
};

Footprint footprint(int resolution, dvec2 uv) {
  const dvec2 at = glm::clamp(uv * double(resolution), dvec2(0.5), dvec2(resolution - 0.5)) - 0.5;
  return {ivec2(glm::floor(at)), at - glm::floor(at)};
}

double bilinear(dvec2 on, ivec2 corner) {
  return (corner.x ? on.x : 1 - on.x) * (corner.y ? on.y : 1 - on.y);
}

std::vector<double> sample(const ShadowBlock& block, int face, dvec2 uv) {
  const Footprint f = footprint(block.resolution(), uv);
  std::vector<double> out(std::size_t(block.layers()) * 4, 0.0);
  for (const ivec2 corner : {ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1)}) {
    const double w = bilinear(f.on, corner);
    if (w == 0) continue;
    const std::vector<float> texel = fetch(block, face, f.base + corner);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += w * double(texel[i]);
  }
  return out;
}

bool hasMetric(const ShadowMap& map) { return map.metric && map.metric->block; }
bool hasIntervals(const ShadowMap& map) {
  return hasMetric(map) && map.metric->options.metric == Metric::Interval;
}

/// blendOf in lib/mixed_bit.glsl: how the footprint that begins at this texel may be blended.
enum class Blend { Whole, None, Rows, Columns };
Blend blendOf(const ShadowMap& map, int face, ivec2 base) {
  const std::vector<float> first = fetch(*map.block, face, base);
  const auto lowBit = [&](std::size_t channel) {
    if (map.storage == Storage::Float) return (std::bit_cast<std::uint32_t>(first[channel]) & 1u) != 0;
    return (glm::packHalf1x16(first[channel]) & 1u) != 0;
  };
  if (!lowBit(std::size_t(std::min(map.coefficients, 4) - 1))) return Blend::Whole;
  if (map.coefficients < 4 || !lowBit(2)) return Blend::None;
  return lowBit(1) ? Blend::Columns : Blend::Rows;
}

double intervalsEnd(const std::vector<double>& m) {
  double end = 0;
  for (std::size_t j = 0; j + 1 < m.size(); j += 2)
    if (m[j + 1] > m[j]) end = std::max(end, m[j + 1]);
  return end;
}

MapTap readTap(const ShadowMap& map, int face, dvec2 uv) {
  MapTap tap;
  tap.coefficients = sample(*map.block, face, uv);
  tap.coefficients.resize(std::size_t(map.coefficients));
  if (!hasMetric(map)) return tap;
  const MetricOptions& o = map.metric->options;
  tap.metric = sample(*map.metric->block, face, uv);
  tap.metric.resize(std::size_t(hasIntervals(map) ? 2 * o.intervals : o.coefficients));
  if (map.metric->weights) {
    tap.weights = sample(*map.metric->weights, face, uv);
    tap.weights.resize(std::size_t(o.intervals));
    for (double& w : tap.weights) w = w * w * w * w;  // their fourth roots are stored
  }
  if (map.horizon) {
    const std::vector<double> h = sample(*map.horizon, face, uv);
    tap.horizonTau = h[0], tap.horizonEnd = intervalsEnd(tap.metric) + h[1];
  }
  return tap;
}

void readVertices(const ShadowMap& map, MapTaps& out) {
  const auto edge = std::size_t(map.spec.resolution);
  const std::size_t at =
      (std::size_t(out.face) * edge + std::size_t(out.texel.y)) * edge + std::size_t(out.texel.x);
  const uvec2 header = map.deep->read(at, 1).front();
  for (const uvec2 v : map.deep->read(header.x, header.y))
    out.vertices.push_back({double(std::bit_cast<float>(v.x)), double(std::bit_cast<float>(v.y))});
}

std::vector<double> unmuted(const MapTap& tap, std::span<const char> muted) {
  std::vector<double> c = tap.coefficients;
  for (std::size_t k = 0; k < std::min(c.size(), muted.size()); ++k)
    if (muted[k]) c[k] = 0;
  return c;
}

bool piecewise(const ShadowMap& map) { return map.basis == Basis::Piecewise && hasIntervals(map); }

double tauAt(const ShadowMap& map, const MapTap& tap, std::span<const double> c, double x) {
  if (!piecewise(map)) return basisTau(map.basis, c, tapU(map, tap, x));
  const Piece p = pieceOf(tap.metric, x);
  return pieceTau(c, p.count, p.index, p.v);
}

double tapTransmittance(const ShadowMap& map, const MapTap& tap, std::span<const double> c, double x) {
  if (map.kind == ShadowMap::Kind::TransmittanceFunction)
    return std::clamp(basisValue(map.basis, c, x), 1e-9, 1.0);
  double tau = tauAt(map, tap, c, x);
  if (map.horizon) {
    const double end = intervalsEnd(tap.metric);
    if (x > end)
      tau += std::max(tap.horizonTau - tau, 0.0) *
             std::clamp((x - end) / std::max(tap.horizonEnd - end, 1e-7), 0.0, 1.0);
  }
  return std::exp(-tau);
}

double deepTransmittance(const std::vector<DeepVertex>& v, double x) {
  if (v.empty()) return 1;
  std::size_t lo = 0;
  while (lo + 1 < v.size() && v[lo + 1].x <= x) ++lo;
  const DeepVertex &a = v[lo], &b = v[std::min(lo + 1, v.size() - 1)];
  return glm::mix(a.transmittance, b.transmittance,
                  std::clamp((x - a.x) / std::max(b.x - a.x, 1e-9), 0.0, 1.0));
}

}  // namespace

MapTaps readTaps(const ShadowMap& map, int face, dvec2 uv) {
  MapTaps out;
  out.face = face;
  if (map.kind == ShadowMap::Kind::RayMarch) return out;
  const int resolution = map.block ? map.block->resolution() : map.spec.resolution;
  out.texel = glm::clamp(ivec2(glm::floor(uv * double(resolution))), ivec2(0), ivec2(resolution - 1));
  if (map.kind == ShadowMap::Kind::Deep) {
    readVertices(map, out);
    return out;
  }
  // Not clamped, as in the shader: its first texel may be -1.
  const dvec2 at = uv * double(resolution) - 0.5, base = glm::floor(at);
  const Blend blend = map.kind == ShadowMap::Kind::Extinction && hasIntervals(map)
                          ? blendOf(map, face, ivec2(base))
                          : Blend::Whole;
  if (blend == Blend::Whole) {
    out.taps = {readTap(map, face, uv)};
    return out;
  }
  double whole = 0;
  const dvec2 on = at - base;
  for (const ivec2 corner : {ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1)}) {
    if ((blend == Blend::Rows && corner.x) || (blend == Blend::Columns && corner.y)) continue;
    dvec2 place = (base + dvec2(corner) + 0.5) / double(resolution);
    dvec2 share(corner.x ? on.x : 1 - on.x, corner.y ? on.y : 1 - on.y);
    if (blend == Blend::Rows) place.x = uv.x, share.x = 1;
    if (blend == Blend::Columns) place.y = uv.y, share.y = 1;
    MapTap tap = readTap(map, face, place);
    tap.weight = (share.x * share.y + 1e-6) * (tap.metric[1] > tap.metric[0] ? 1.0 : 1e-6);
    whole += tap.weight;
    out.taps.push_back(std::move(tap));
  }
  for (MapTap& tap : out.taps) tap.weight /= whole;
  std::stable_sort(out.taps.begin(), out.taps.end(),
                   [](const MapTap& a, const MapTap& b) { return a.weight > b.weight; });
  return out;
}

double tapU(const ShadowMap& map, const MapTap& tap, double x) {
  return hasMetric(map) ? metricU(map.metric->options.metric, tap.metric, x, tap.weights) : x;
}

double tapsTransmittance(const ShadowMap& map, const MapTaps& taps, double x, std::span<const char> muted) {
  if (map.kind == ShadowMap::Kind::Deep) return deepTransmittance(taps.vertices, x);
  if (taps.taps.empty()) return 1;
  double sum = 0;
  for (const MapTap& tap : taps.taps) sum += tap.weight * tapTransmittance(map, tap, unmuted(tap, muted), x);
  return sum;
}

double tapExtinction(const ShadowMap& map, const MapTap& tap, double u, std::span<const char> muted) {
  const std::vector<double> c = unmuted(tap, muted);
  if (!piecewise(map)) return basisValue(map.basis, c, u);
  // Which interval u falls into, and where in it.
  const auto mass = [&](std::size_t j) {
    return (tap.weights.empty() ? 1 : tap.weights[j]) * (tap.metric[2 * j + 1] - tap.metric[2 * j]);
  };
  double whole = 0;
  std::size_t count = 0;
  for (std::size_t j = 0; 2 * j + 1 < tap.metric.size(); ++j) {
    whole += mass(j);
    count += mass(j) > 0 ? 1 : 0;
  }
  if (!(whole > 0)) return 0;
  double before = 0;
  std::size_t j = 0;
  while (j + 1 < count && u * whole >= before + mass(j)) before += mass(j++);
  const double v = (u * whole - before) / mass(j);
  double perInterval = 0;
  for (std::size_t i = j; i < c.size(); i += count)
    perInterval += c[i] * std::cos(kPi * double(i / count) * v);
  return perInterval * whole / mass(j);
}

}  // namespace pileus::shadow
