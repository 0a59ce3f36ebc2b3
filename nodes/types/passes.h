#pragma once
// What nodes share that work on the GPU, in passes.
#include <memory>
#include <vector>

#include "nodes/declare/eval_context.h"
#include "renderer/base/result.h"
#include "renderer/view/renderer.h"

namespace pileus::nodes {

/// Error (Gpu) in an evaluation without one.
Result<view::Renderer*> gpuOf(EvalContext& ctx);

/// A node's passes, which run one after the other.
template <class Pass>
struct PassQueue {
  std::vector<std::unique_ptr<Pass>> passes;
  std::size_t next = 0;  ///< the first that is not finished
  double fraction = 1;   ///< of all of them, as of the last run; 1: finished

  /// As long as the budget allows, at least one step; GPU milliseconds are added to `gpuMs`.
  Result<void> run(const shadow::Gpu& gpu, const EvalContext& ctx, double& gpuMs) {
    while (next < passes.size()) {
      PILEUS_TRY(const double done, passes[next]->step(gpu, ctx.msLeft()));
      gpuMs += passes[next]->takeGpuMs();
      fraction = (double(next) + done) / double(passes.size());
      if (done < 1) break;
      ++next;
      if (ctx.msLeft() <= 0) break;
    }
    return {};
  }
};

/// Makes a node's passes on its first call, by `begin(renderer, passes)`, and lets them work. Their GPU time
/// is reported; their memory, and that they are still at it, is the caller's to say.
template <class Pass, class Begin>
Result<const PassQueue<Pass>*> runPasses(EvalContext& ctx, const Begin& begin) {
  PILEUS_TRY(view::Renderer * renderer, gpuOf(ctx));
  auto& queue = ctx.state<PassQueue<Pass>>();
  if (queue.passes.empty()) PILEUS_CHECK(begin(*renderer, queue.passes));
  double gpuMs = 0;
  PILEUS_CHECK(queue.run(renderer->gpu(), ctx, gpuMs));
  ctx.reportGpu(gpuMs, 0);
  return &queue;
}

}  // namespace pileus::nodes
