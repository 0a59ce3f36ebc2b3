#include "nodes/types/passes.h"

namespace pileus::nodes {

Result<view::Renderer*> gpuOf(EvalContext& ctx) {
  if (ctx.renderer()) return ctx.renderer();
  return fail(Code::Gpu, "needs a GPU context");
}

}  // namespace pileus::nodes
