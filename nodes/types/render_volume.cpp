// render.volume: the picture.
#include <algorithm>

#include "nodes/declare/describe.h"
#include "nodes/types/passes.h"
#include "nodes/types/render_common.h"
#include "renderer/gl/storage.h"
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

/// The picture, and behind it each layer beside it.
struct Pass : view::VolumeRenderPass {
  Pass(std::string layer, view::RenderScene scene)
      : VolumeRenderPass(std::move(scene)), name(std::move(layer)) {}
  std::string name;  ///< of a layer
};
using Passes = std::vector<std::unique_ptr<Pass>>;

/// The passes of the layers that are asked for.
void addLayers(Passes& passes, const view::RenderScene& scene, const view::ExtraLayers& wanted) {
  const auto add = [&](const std::string& name, view::PictureLayer layer) {
    view::RenderScene one = scene;
    one.options.layer = layer;
    passes.push_back(std::make_unique<Pass>(name, std::move(one)));
  };
  using Kind = view::PictureLayer::Kind;
  if (wanted.depth) add("depth", {Kind::Depth, 0});
  for (std::size_t i = 0; wanted.lights && i < scene.lights.size(); ++i)
    add(fmt::format("light{}", i + 1), {Kind::Light, int(i)});
  if (wanted.lights && (view::emits(scene) || view::backdropOf(scene))) add("emission", {Kind::Emission, 0});
}

void describe(Describe<In, Out>& d) {
  d.name("Volume Render").category("Render").keywords("picture scattering march beauty");
  d.help(
      "Renders single scattering of the lights in the volumes, what they emit, and the solids behind and "
      "among them, front to back. Any "
      "number of overlapping volumes; the picture refines sample by sample. Background black, alpha 0.");
  d.uses(UsesSize | UsesQuality | UsesFreeCamera | UsesLayers);
  d.in("volumes", &In::volumes).many().help("The media to draw.");
  d.in("lights", &In::lights)
      .many()
      .help("The lights, each with its own shadow. None: only what emits is seen.");
  d.in("solids", &In::solids)
      .many()
      .help("The opaque solids to draw. They block a light only where they are linked to its shadow, too.");
  d.in("camera", &In::camera)
      .help(
          "Where the picture is taken from; unlinked: the viewport's free camera, or a view framed on the "
          "volumes.");
  d.in("step_scale", &In::step_scale)
      .range(0.05, 16)
      .soft(0.25, 4)
      .logarithmic()
      .help("March step as a multiple of the finest voxel or pixel footprint along the ray.");
  d.in("samples", &In::samples)
      .range(1, 4096)
      .soft(1, 64)
      .help("Jittered samples per pixel. 1: the ray through the pixel centre, without jitter.");
  d.out("image", &Out::image).help("Scene-linear radiance [W/(m^2 sr)], premultiplied, with alpha.");
}

Result<void> begin(const In& in, const EvalContext& ctx, bool software, Passes& passes) {
  view::RenderOptions options = pictureOptions(ctx, in.camera, in.volumes, in.solids, in.samples, software);
  options.stepScale = in.step_scale;
  if (ctx.quality() == Quality::Draft && software) options.stepScale *= 1.5;
  const view::RenderScene scene{options, in.volumes.items, in.lights.items, in.solids.items};
  passes.push_back(std::make_unique<Pass>("", scene));
  passes.back()->beginWith(ctx.seed());
  if (ctx.quality() == Quality::Final) addLayers(passes, scene, ctx.extra());
  return {};
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  PILEUS_TRY(const auto* queue, runPasses<Pass>(ctx, [&](view::Renderer& renderer, Passes& passes) {
               return begin(in, ctx, renderer.device().software, passes);
             }));
  Pass& first = *queue->passes.front();
  const auto picture = first.picture();
  std::size_t bytes = 0;  // of the largest
  for (const auto& pass : queue->passes)
    if (const auto made = pass->picture()) bytes = std::max(bytes, made->color.bytes());
  ctx.reportGpu(0, bytes);
  if (const auto& r = first.residency(); r.coarsened > 0)
    ctx.warn(
        fmt::format("{} of the grids are drawn coarser than they are: their bricks need {}, {} are set aside "
                    "(--gpu-memory)",
                    r.coarsened, gl::neededMib(r.wantedBytes), gl::givenMib(r.budgetBytes)));
  if (queue->fraction >= 1)
    for (std::size_t i = 1; i < queue->passes.size(); ++i)
      first.addLayer({queue->passes[i]->name, queue->passes[i]->picture()});
  else if (picture)
    ctx.partial(queue->fraction);
  else
    ctx.pending(queue->fraction, "Uploading bricks");
  return Out{{picture}};
}

}  // namespace

NodeType node_render_volume() { return makeNode<In, Out>("render.volume", 2, describe, evaluate); }

}  // namespace pileus::nodes
