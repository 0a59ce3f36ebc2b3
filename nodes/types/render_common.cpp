#include "nodes/types/render_common.h"

#include <algorithm>
#include <cmath>

#include "renderer/volume/autofit.h"

namespace pileus::nodes {
namespace {

/// The volumes; solids only where there is nothing else: a wide ground would make clouds tiny.
Box3 framed(const VolumeValue& volumes, const SolidValue& solids) {
  const Box3 bulk = volume::worldBulkBounds(volumes.items);
  return bulk.empty() ? scene::worldBounds(solids.items) : bulk;
}

/// As many pixels as the context allows in a drag, of the picture's shape; in a region they are all spent
/// there.
ivec2 draftSize(const view::RenderOptions& o, const EvalContext& ctx, bool software) {
  const int allowed = ctx.draftPixels() > 0 ? ctx.draftPixels() : software ? 25000 : o.size.x * o.size.y;
  const dvec2 part = o.region.max - o.region.min;
  const double pixels = double(o.size.x) * o.size.y * std::clamp(part.x * part.y, 1e-4, 1.0);
  const double by = std::max(1.0, std::sqrt(pixels / std::max(allowed, 1)));
  return glm::max(ivec2(glm::round(dvec2(o.size) / by)), ivec2(1));
}

}  // namespace

view::RenderOptions pictureOptions(const EvalContext& ctx, const CameraValue& camera,
                                   const VolumeValue& volumes, const SolidValue& solids, int samples,
                                   bool software) {
  view::RenderOptions options;
  options.size = ctx.size();
  options.samples = samples;
  options.layer = ctx.layer();
  options.region = ctx.region();
  if (camera.camera)
    options.camera = *camera.camera;
  else if (ctx.freeCamera())
    options.camera = *ctx.freeCamera();
  else
    options.camera = scene::frameBounds(framed(volumes, solids), double(options.size.x) / options.size.y);
  if (ctx.quality() == Quality::Draft) {
    options.samples = 1;
    options.size = draftSize(options, ctx, software);
  }
  return options;
}

}  // namespace pileus::nodes
