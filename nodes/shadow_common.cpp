#include "nodes/shadow_common.h"

#include <algorithm>

#include "renderer/view/renderer.h"

namespace pileus::nodes {

Result<scene::Light> singleLight(const LightValue& value) {
  if (value.items.size() == 1) return value.items.front().light;
  return fail(Code::Input, "light: holds {} lights; a shadow map is made for one", value.items.size());
}

Result<view::Renderer*> gpuOf(EvalContext& ctx) {
  if (ctx.renderer()) return ctx.renderer();
  return fail(Code::Gpu, "needs a GPU context");
}

int draftResolution(int resolution, const EvalContext& ctx) {
  if (ctx.quality() == Quality::Final) return resolution;
  return std::min(resolution, ctx.renderer() && ctx.renderer()->device().software ? 128 : 256);
}

}  // namespace pileus::nodes
