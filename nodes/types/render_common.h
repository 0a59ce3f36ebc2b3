#pragma once
// What the nodes that make pictures share: where a picture is taken from, and how large a draft of it is.
#include "nodes/declare/eval_context.h"
#include "nodes/declare/value.h"
#include "renderer/view/render_scene.h"

namespace pileus::nodes {

/// What is common to every picture: size, camera (the linked one, the viewport's, or one framed on the
/// volumes), layer and region of the context; in a draft one sample, and as many pixels as that allows.
view::RenderOptions pictureOptions(const EvalContext& ctx, const CameraValue& camera,
                                   const VolumeValue& volumes, const SolidValue& solids, int samples,
                                   bool software);

}  // namespace pileus::nodes
