#pragma once
// What the shadow nodes share. Each makes one map for each light that arrives, one after the other.
#include <memory>
#include <vector>

#include "nodes/declare/eval_context.h"
#include "nodes/declare/value.h"
#include "renderer/base/result.h"
#include "renderer/shadow/shadow_pass.h"

namespace pileus::nodes {

/// The lights of a value; their old shadows, if any, are left behind. Error (Input) for none.
Result<std::vector<scene::Light>> lightsOf(const LightValue& value);
/// Error (Gpu) in an evaluation without one.
Result<view::Renderer*> gpuOf(EvalContext& ctx);
/// What a draft makes of a map's resolution: at most 256 texels, 128 on a CPU.
int draftResolution(int resolution, const EvalContext& ctx);

/// The passes of a node, run in turn within the context's budget.
template <class Pass>
struct PassQueue {
  std::vector<std::unique_ptr<Pass>> passes;
  std::size_t next = 0;

  /// The fraction done, 1 = all; GPU milliseconds are added to `gpuMs`.
  Result<double> run(const shadow::Gpu& gpu, const EvalContext& ctx, double& gpuMs) {
    while (next < passes.size()) {
      PILEUS_TRY(const double fraction, passes[next]->step(gpu, ctx.msLeft()));
      gpuMs += passes[next]->takeGpuMs();
      if (fraction < 1) return (double(next) + fraction) / double(passes.size());
      ++next;
      if (next < passes.size() && ctx.msLeft() <= 0) return double(next) / double(passes.size());
    }
    return 1.0;
  }
};

/// Builds `spec` for every light and returns the lights with their shadows; pending with `what` until all are
/// there.
Result<LightValue> shadowLights(const shadow::ShadowSpec& spec, const LightValue& lights,
                                const VolumeValue& volumes, const SolidValue& solids, EvalContext& ctx,
                                const char* what);

}  // namespace pileus::nodes
