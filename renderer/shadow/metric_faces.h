#pragma once
// The paper's first pass: the faces of every bounding box drawn with additive blending into a series metric.
#include "renderer/shadow/map_pass.h"
#include "renderer/shadow/representation.h"

namespace pileus::shadow {

/// Fills every face of `block` (metric cosine or Fourier); the light's record must be bound. Leaves no GL
/// state behind but the program.
Result<void> drawMetricFaces(const Gpu& gpu, const MetricOptions& options, MapPass& pass,
                             const ShadowBlock& block);

}  // namespace pileus::shadow
