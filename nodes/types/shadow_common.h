#pragma once
// What the shadow nodes share. Each makes one map for each light that arrives, one after the other. Of an
// environment they say what map its suns get; whoever needs some of these makes them.
#include <vector>

#include "nodes/declare/describe.h"
#include "nodes/shadows/shadow_inputs.h"

namespace pileus::nodes {

/// What all but shadow.pseudometric give.
struct ShadowOut {
  LightValue light;
};

template <class In, class Out>
void describeCasters(Describe<In, Out>& d,
                     std::string lights = "The lights to shadow; each gets a map of its own.",
                     std::string solids = "Opaque solids that block the light, exactly.") {
  d.in("volumes", &In::volumes).many().help("The media that cast shadows.");
  d.in("light", &In::light).required().help(std::move(lights));
  d.in("solids", &In::solids).many().help(std::move(solids));
}

/// `path` leads from In to the member.
template <class In, class Out, class... Path>
void describeResolution(Describe<In, Out>& d, Path... path) {
  d.in("resolution", path...)
      .unit("texels")
      .range(64, 4096)
      .logarithmic()
      .help("Texels along each edge of the map.");
}

template <class In, class Out, class... Path>
void describeDamping(Describe<In, Out>& d, Path... path) {
  d.in("damping", path...)
      .help(
          "Lanczos factors on the coefficients: fewer rings where transmittance should be level, but a "
          "larger error.");
}

template <class In>
void describeShadowed(Describe<In, ShadowOut>& d) {
  d.out("light", &ShadowOut::light).help("The lights with this shadow.");
}

/// Of a draft's map: a map that is finer than they begin with has `draftTexels`, a coarser one fewer in
/// proportion (environments have sixteen of them), neither more than its own.
int draftTexelsOf(int resolution, int draftTexels);
/// The lights of a value; their old shadows, if any, are left behind. Error (Input) for none.
Result<std::vector<scene::Light>> lightsOf(const LightValue& value);
/// What a draft makes of a map's resolution: at most 256 texels, 128 on a CPU.
int draftResolution(int resolution, const EvalContext& ctx);

/// Says on the node where a map of that resolution has texels wider than a medium is thick along the light,
/// and what helps.
void warnOfThinMedia(const std::vector<scene::Light>& lights, const volume::InstanceList& media,
                     int resolution, EvalContext& ctx);

/// Builds `in.spec` for every light but environments and returns the lights with their shadows; pending with
/// `what` until all are there.
Result<ShadowOut> shadowed(const ShadowIn& in, EvalContext& ctx, const char* what);

}  // namespace pileus::nodes
