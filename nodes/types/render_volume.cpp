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
  view::Scattering scattering = view::Scattering::Grid;
  int grid_cells = 64;
  double grid_residual = 1e-4;
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

/// What emits, and what is seen of each environment, apart from each other.
void addBackdrops(Passes& passes, view::RenderScene scene) {
  scene.options.layer = {view::PictureLayer::Kind::Emission, 0};
  std::vector<std::shared_ptr<const scene::Environment>> seen;
  for (shadow::ShadowedLight& l : scene.lights) {
    seen.push_back(l.light.environment && l.light.environment->visible ? l.light.environment : nullptr);
    if (!seen.back()) continue;
    auto hidden = std::make_shared<scene::Environment>(*seen.back());
    hidden->visible = false;
    l.light.environment = std::move(hidden);
  }
  if (view::emits(scene)) passes.push_back(std::make_unique<Pass>("emission", scene));
  std::erase_if(scene.volumes, [](const volume::Instance& i) { return volume::emits(i); });
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i]) continue;
    view::RenderScene one = scene;
    one.lights[i].light.environment = seen[i];
    passes.push_back(std::make_unique<Pass>(fmt::format("backdrop{}", i + 1), std::move(one)));
  }
}

/// The passes of the layers that are asked for.
void addLayers(Passes& passes, const view::RenderScene& scene, const view::ExtraLayers& wanted) {
  const auto add = [&](const std::string& name, view::PictureLayer layer) {
    view::RenderScene one = scene;
    one.options.layer = layer;
    passes.push_back(std::make_unique<Pass>(name, std::move(one)));
  };
  using Kind = view::PictureLayer::Kind;
  if (wanted.depth) add("depth", {Kind::Depth, 0});
  if (wanted.orders) add("single", {Kind::Single, 0}), add("multiple", {Kind::Multiple, 0});
  for (std::size_t i = 0; wanted.lights && i < scene.lights.size(); ++i)
    add(fmt::format("light{}", i + 1), {Kind::Light, int(i)});
  if (wanted.lights && wanted.backdrops)
    addBackdrops(passes, scene);
  else if (wanted.lights && (view::emits(scene) || view::backdropOf(scene)))
    add("emission", {Kind::Emission, 0});
}

void describe(Describe<In, Out>& d) {
  d.name("Volume Render").category("Render").keywords("picture scattering march beauty");
  d.help(
      "Renders the light that the volumes scatter and emit, and the solids behind and among them, front to "
      "back. Any number of overlapping volumes; the picture refines sample by sample, under environments "
      "with "
      "other directions each time. Background black, alpha 0.");
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
  d.in("scattering", &In::scattering)
      .help(
          "What of light that was scattered more than once is there. Grid: all of it, solved for on a "
          "lattice "
          "of cells around the volumes; kept while one only looks from elsewhere. Octaves: something like "
          "it, "
          "a look. Single: none.");
  d.in("grid_cells", &In::grid_cells)
      .range(8, 192)
      .soft(16, 128)
      .help(
          "Grid: at most so many cells along the longest edge of the volumes; fewer where the media are so "
          "thin that more would tell nothing. 64 take up to 150 MB while they are solved for.");
  d.in("grid_residual", &In::grid_residual)
      .range(1e-6, 0.1)
      .logarithmic()
      .help("Grid: done once what is scattered is known to that part.");
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

constexpr int kDraftCells = 32;
constexpr double kDraftResidual = 3e-3;

/// Solutions of scattered light, and the suns of the last draft: whoever turns the camera needs no new ones.
/// Maps of the latter go where others find no room.
class Lasting {
 public:
  Lasting() = default;
  Lasting(const Lasting&) = delete;
  Lasting& operator=(const Lasting&) = delete;
  ~Lasting() {
    if (store_) store_->setReclaim(this, {});
  }
  const std::shared_ptr<view::ScatterCache>& scatter() const { return scatter_; }
  const std::shared_ptr<view::KeptSuns>& suns(shadow::ShadowStore& store) {
    if (!store_) store.setReclaim(this, [suns = suns_](std::size_t) { return view::letGo(*suns); });
    store_ = &store;
    return suns_;
  }

 private:
  std::shared_ptr<view::ScatterCache> scatter_ = std::make_shared<view::ScatterCache>();
  std::shared_ptr<view::KeptSuns> suns_ = std::make_shared<view::KeptSuns>();
  shadow::ShadowStore* store_ = nullptr;
};

Result<void> begin(const In& in, EvalContext& ctx, view::Renderer& renderer, Passes& passes) {
  const bool software = renderer.device().software;
  view::RenderOptions options = pictureOptions(ctx, in.camera, in.volumes, in.solids, in.samples, software);
  options.stepScale = in.step_scale;
  options.scatter = {in.scattering, in.grid_cells, in.grid_residual};
  if (ctx.quality() == Quality::Draft) {
    options.scatter.cells = std::min(options.scatter.cells, kDraftCells);
    options.scatter.residual = std::max(options.scatter.residual, kDraftResidual);
  }
  if (ctx.quality() == Quality::Draft && software) options.stepScale *= 1.5;
  const view::RenderScene scene{options, in.volumes.items, in.lights.items, in.solids.items};
  passes.push_back(std::make_unique<Pass>("", scene));
  passes.back()->beginWith(ctx.seed());
  if (ctx.quality() == Quality::Draft)
    passes.back()->keepSuns(ctx.lasting<Lasting>().suns(renderer.shadows()));
  if (ctx.quality() == Quality::Final) addLayers(passes, scene, ctx.extra());
  for (const auto& pass : passes) pass->keepScatterIn(ctx.lasting<Lasting>().scatter());
  return {};
}

void report(const view::ScatterField& field, EvalContext& ctx) {
  for (const transport::Solution& s : field.solutions()) {
    const ivec3 n = s.lattice.cells;
    ctx.note(fmt::format("scattered light: {} x {} x {} cells, {} sweeps, residual {:.1e}", n.x, n.y, n.z,
                         s.sweeps, s.residual));
  }
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  PILEUS_TRY(const auto* queue, runPasses<Pass>(ctx, [&](view::Renderer& renderer, Passes& passes) {
               return begin(in, ctx, renderer, passes);
             }));
  Pass& first = *queue->passes.front();
  const auto picture = first.picture();
  std::size_t bytes = 0;  // of the largest
  for (const auto& pass : queue->passes)
    if (const auto made = pass->picture()) bytes = std::max(bytes, made->color.bytes() + pass->bytesBeside());
  ctx.reportGpu(0, bytes);
  if (const auto& r = first.residency(); r.coarsened > 0)
    ctx.warn(
        fmt::format("{} of the grids are drawn coarser than they are: their bricks need {}, {} are set aside "
                    "(--gpu-memory)",
                    r.coarsened, gl::neededMib(r.wantedBytes), gl::givenMib(r.budgetBytes)));
  if (picture && picture->scene && view::tintedApart(*picture->scene))
    ctx.note("volumes differ in extinction colour: each light has three shadows, one for each channel");
  const auto field = first.scatterField();
  if (field) report(*field, ctx);
  if (queue->fraction >= 1)
    for (std::size_t i = 1; i < queue->passes.size(); ++i)
      first.addLayer({queue->passes[i]->name, queue->passes[i]->picture()});
  else if (picture)
    ctx.partial(queue->fraction);
  else
    ctx.pending(queue->fraction, first.doing());
  return Out{{picture}};
}

}  // namespace

NodeType node_render_volume() { return makeNode<In, Out>("render.volume", 3, describe, evaluate); }

}  // namespace pileus::nodes
