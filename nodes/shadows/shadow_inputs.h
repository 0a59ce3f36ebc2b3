#pragma once
// `In` of the nodes that make shadows. Their parameters are the members of what the renderer builds, declared
// once, by each node's describe(): so a node can be read as a description and written back
// (shadow_spec_nodes.h) without a list of its own.
#include "nodes/declare/value.h"
#include "renderer/shadow/representation.h"

namespace pileus::nodes {

/// Of shadow.pseudometric. Its defaults and those of shadow.extinction are the knee of a measured curve
/// (docs/bench.md).
struct MetricIn {
  VolumeValue volumes;
  LightValue light;
  SolidValue solids;
  shadow::MetricOptions metric{
      .resolution = 384, .weighting = shadow::Weighting::Root, .horizon = shadow::kUsualHorizon};
};

/// Of all others; which one it is stands in `spec.kind`.
struct ShadowIn {
  MetricValue metric;  ///< shadow.extinction only; `spec.metric` is what it holds
  VolumeValue volumes;
  LightValue light;
  SolidValue solids;
  shadow::ShadowSpec spec;
};

inline ShadowIn ofKind(shadow::ShadowSpec::Kind kind) {
  ShadowIn in;
  in.spec.kind = kind;
  return in;
}

}  // namespace pileus::nodes
