#include "nodes/shadow_common.h"

#include <algorithm>

namespace pileus::nodes {

Result<scene::Light> singleLight(const LightValue& value) {
  if (value.items.size() == 1) return value.items.front().light;
  return fail(Code::Input, "light: holds {} lights; a shadow map is made for one", value.items.size());
}

Result<view::Renderer*> gpuOf(EvalContext& ctx) {
  if (ctx.renderer()) return ctx.renderer();
  return fail(Code::Gpu, "needs a GPU context");
}

int draftResolution(int resolution, const EvalContext& ctx) { return ctx.quality() == Quality::Draft ? std::min(resolution, 256) : resolution; }

}  // namespace pileus::nodes
