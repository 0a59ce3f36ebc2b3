#pragma once
// What a lookup reads of a light's map at one place, brought to the CPU, and its evaluation in double
// precision: the twin of lib/shadow_map.glsl, for looking at one ray. GL thread to read; the values are
// plain.
#include <span>
#include <vector>

#include "renderer/shadow/shadow_map.h"

namespace pileus::shadow {

/// One set of values that is evaluated as a whole: a blend of four texels where they agree, else one of the
/// four.
struct MapTap {
  double weight = 1;            ///< of its transmittance; all taps together 1
  std::vector<double> metric;   ///< interval ends (a0, b0, a1, b1, ...) or coefficients; empty: Euclidean
  std::vector<double> weights;  ///< of the intervals; empty: 1
  std::vector<double> coefficients;
  double horizonTau = 0;  ///< all there is on the ray, where the metric has a horizon
  double horizonEnd = 0;  ///< x of the last exit
};

struct DeepVertex {
  double x = 0, transmittance = 1;
};

struct MapTaps {
  int face = 0;
  ivec2 texel{0};                    ///< the nearest one
  std::vector<MapTap> taps;          ///< heaviest first; empty for Deep and RayMarch
  std::vector<DeepVertex> vertices;  ///< Deep: of the nearest texel
};

/// At (u, v) of a face, each in [0, 1]. Waits for the GPU.
MapTaps readTaps(const ShadowMap& map, int face, dvec2 uv);

/// u(x), the share of the metric in front of x, by one tap.
double tapU(const ShadowMap& map, const MapTap& tap, double x);
/// Extinction over u by one tap's series: d tau / d u at u in (0, 1), coefficients muted as below. Extinction
/// only.
double tapExtinction(const ShadowMap& map, const MapTap& tap, double u, std::span<const char> muted = {});
/// T(x) in front of x in [0, 1]; coefficients whose place in `muted` is not 0 count as 0 (`muted` may be
/// shorter). Extinction and TransmittanceFunction; Deep: by the nearest texel's vertices; RayMarch: 1.
double tapsTransmittance(const ShadowMap& map, const MapTaps& taps, double x,
                         std::span<const char> muted = {});

}  // namespace pileus::shadow
