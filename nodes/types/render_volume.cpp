// render.volume: the picture.
#include <algorithm>
#include <cmath>

#include "nodes/describe.h"
#include "nodes/shadow_common.h"
#include "renderer/view/renderer.h"
#include "renderer/view/volume_render.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volumes;
  LightValue lights;
  SolidValue solids;
  CameraValue camera;
  double step_scale = 1;
  int samples = 16;
};

struct Out {
  ImageValue image;
};

struct State {
  std::unique_ptr<view::VolumeRenderPass> pass;
};

void describe(Describe<In, Out>& d) {
  d.name("Volume Render").category("Render").keywords("picture scattering march beauty");
  d.help("Renders single scattering of the lights in the volumes, and the solids behind and among them, front to back. Any number of "
         "overlapping volumes; the picture refines sample by sample. Background black, alpha 0.");
  d.uses(UsesSize | UsesQuality | UsesFreeCamera);
  d.in("volumes", &In::volumes).many().help("The media to draw.");
  d.in("lights", &In::lights).many().help("The lights, each with its own shadow. None: black.");
  d.in("solids", &In::solids).many().help("The opaque solids to draw. They block a light only where they are linked to its shadow, too.");
  d.in("camera", &In::camera).help("Where the picture is taken from; unlinked: the viewport's free camera, or a view framed on the volumes.");
  d.in("step_scale", &In::step_scale).range(0.05, 16).soft(0.25, 4).logarithmic().help("March step as a multiple of the finest voxel or pixel footprint along the ray.");
  d.in("samples", &In::samples).range(1, 4096).soft(1, 64).help("Jittered samples per pixel. 1: the ray through the pixel centre, without jitter.");
  d.out("image", &Out::image).help("Scene-linear radiance [W/(m^2 sr)], premultiplied, with alpha.");
}

/// The volumes; solids only where there is nothing else: a wide ground would make clouds tiny.
Box3 framed(const In& in) {
  const Box3 volumes = volume::worldBounds(in.volumes.items);
  return volumes.empty() ? scene::worldBounds(in.solids.items) : volumes;
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  PILEUS_TRY(view::Renderer * renderer, gpuOf(ctx));
  auto& state = ctx.state<State>();
  if (!state.pass) {
    view::RenderOptions options{ctx.size(), in.samples, in.step_scale, {}};
    const double aspect = double(options.size.x) / options.size.y;
    if (in.camera.camera) options.camera = *in.camera.camera;
    else if (ctx.freeCamera()) options.camera = *ctx.freeCamera();
    else options.camera = scene::frameBounds(framed(in), aspect);
    if (ctx.quality() == Quality::Draft) {
      options.samples = 1;
      // A CPU draws some 25,000 pixels in the time a drag allows; a GPU draws them all.
      if (renderer->device().software) {
        const double pixels = double(options.size.x) * options.size.y;
        options.size = glm::max(options.size / std::max(1, int(std::ceil(std::sqrt(pixels / 25000)))), ivec2(1));
        options.stepScale *= 1.5;
      }
    }
    state.pass = std::make_unique<view::VolumeRenderPass>(view::RenderScene{options, in.volumes.items, in.lights.items, in.solids.items});
  }
  PILEUS_TRY(const double fraction, state.pass->step(renderer->gpu(), ctx.msLeft()));
  const auto picture = state.pass->picture();
  ctx.reportGpu(state.pass->takeGpuMs(), picture ? picture->color.bytes() : 0);
  if (const auto& r = state.pass->residency(); r.coarsened > 0)
    ctx.warn(fmt::format("{} of the grids are drawn coarser than they are: their bricks need {} MiB, {} MiB are set aside (--gpu-memory)", r.coarsened, r.wantedBytes >> 20, r.budgetBytes >> 20));
  if (fraction < 1) {
    if (picture) ctx.partial(fraction);
    else ctx.pending(fraction, "Uploading bricks");
  }
  return Out{{picture}};
}

}  // namespace

NodeType node_render_volume() { return makeNode<In, Out>("render.volume", 2, describe, evaluate); }

}  // namespace pileus::nodes
