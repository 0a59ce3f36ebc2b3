#pragma once
// What the shadow nodes share.
#include "nodes/eval_context.h"
#include "nodes/value.h"
#include "renderer/base/result.h"

namespace pileus::nodes {

/// The one light of a value; its old shadow, if any, is left behind. Error (Input) for none or several.
Result<scene::Light> singleLight(const LightValue& value);
/// Error (Gpu) in an evaluation without one.
Result<view::Renderer*> gpuOf(EvalContext& ctx);
/// What a draft makes of a map's resolution: at most 256 texels, 128 on a CPU.
int draftResolution(int resolution, const EvalContext& ctx);

}  // namespace pileus::nodes
