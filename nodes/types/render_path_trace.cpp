// render.path_trace: the picture with all orders of scattering, without bias.
#include <cmath>
#include <optional>

#include "nodes/declare/describe.h"
#include "nodes/types/passes.h"
#include "nodes/types/render_common.h"
#include "renderer/gl/storage.h"
#include "renderer/view/path_trace.h"
#include "renderer/view/volume_render.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volumes;
  LightValue lights;
  SolidValue solids;
  CameraValue camera;
  int samples = 64;
  int bounces = -1;
  double seconds = 0;
  double noise = 0;
  view::ShadowEstimate transmittance = view::ShadowEstimate::Series;
};

struct Out {
  ImageValue image;
};

/// The picture, and behind it each layer beside it: paths, but for the depth, which is marched.
struct Pass {
  Pass(std::string layer, const view::RenderScene& scene, const view::PathOptions& options)
      : name(std::move(layer)) {
    if (scene.options.layer.kind == view::PictureLayer::Kind::Depth)
      marched.emplace(scene);
    else
      traced.emplace(scene, options);
  }
  Result<double> step(const shadow::Gpu& gpu, double ms) {
    return traced ? traced->step(gpu, ms) : marched->step(gpu, ms);
  }
  double takeGpuMs() { return traced ? traced->takeGpuMs() : marched->takeGpuMs(); }
  std::shared_ptr<const view::Picture> picture() const {
    return traced ? traced->picture() : marched->picture();
  }
  std::string name;  ///< of a layer
  std::optional<view::PathTracePass> traced;
  std::optional<view::VolumeRenderPass> marched;
};
using Passes = std::vector<std::unique_ptr<Pass>>;

void describe(Describe<In, Out>& d) {
  d.name("Path Trace")
      .category("Render")
      .keywords("picture judge reference truth multiple scattering unbiased");
  d.help(
      "Renders all orders of scattering without bias: the truth that faster pictures are judged by. Takes "
      "what "
      "'Volume Render' takes, so that one link swaps them; it ignores step scales and mips. A light without "
      "a "
      "shadow node is shadowed by all that is drawn.");
  d.uses(UsesSize | UsesQuality | UsesFreeCamera | UsesLayers);
  d.in("volumes", &In::volumes).many().help("The media to draw.");
  d.in("lights", &In::lights)
      .many()
      .help("The lights. Their shadow maps only say which light is worth a look, and change no mean.");
  d.in("solids", &In::solids).many().help("The opaque solids to draw, which reflect light to media, too.");
  d.in("camera", &In::camera)
      .help(
          "Where the picture is taken from; unlinked: the viewport's free camera, or a view framed on the "
          "volumes.");
  d.in("samples", &In::samples).range(1, 1 << 20).soft(1, 1024).help("Paths per pixel, at most.");
  d.in("bounces", &In::bounces)
      .range(-1, 100000)
      .soft(-1, 32)
      .help("How often a path scatters behind the first time; -1: without limit, 0: single scattering.");
  d.in("seconds", &In::seconds)
      .unit("s")
      .range(0, 1e6)
      .soft(0, 600)
      .help("Ends it behind a whole sample; 0: no limit. Such a picture is another one each time.");
  d.in("noise", &In::noise)
      .range(0, 1)
      .soft(0, 0.1)
      .help(
          "Ends it once the standard error of a pixel is that part of the mean; 0: no limit. From 16 samples "
          "on.");
  d.in("transmittance", &In::transmittance).help("How shadows are measured; the mean is the same.");
  d.out("image", &Out::image)
      .help(
          "Scene-linear radiance [W/(m^2 sr)], premultiplied, with alpha; in files with "
          "the variance of each pixel's mean.");
}

Result<void> begin(const In& in, const EvalContext& ctx, bool software, Passes& passes) {
  const view::RenderOptions options =
      pictureOptions(ctx, in.camera, in.volumes, in.solids, in.samples, software);
  view::PathOptions paths;
  paths.bounces = in.bounces;
  paths.transmittance = in.transmittance;
  const bool final = ctx.quality() == Quality::Final;
  if (final) paths.seconds = in.seconds, paths.noise = in.noise;
  view::RenderScene scene;
  scene.options = options, scene.volumes = in.volumes.items, scene.lights = in.lights.items;
  scene.solids = in.solids.items;
  passes.push_back(std::make_unique<Pass>("", scene, paths));
  if (passes.back()->traced)
    passes.back()->traced->beginWith(ctx.seed());
  else
    passes.back()->marched->beginWith(ctx.seed());
  if (!final) return {};
  using Kind = view::PictureLayer::Kind;
  const auto add = [&](const std::string& name, view::PictureLayer layer) {
    view::RenderScene one = scene;
    one.options.layer = layer;
    passes.push_back(std::make_unique<Pass>(name, one, paths));
  };
  const view::ExtraLayers& wanted = ctx.extra();
  if (wanted.depth) add("depth", {Kind::Depth, 0});
  if (wanted.orders) add("single", {Kind::Single, 0}), add("multiple", {Kind::Multiple, 0});
  for (std::size_t i = 0; wanted.lights && i < scene.lights.size(); ++i)
    add(fmt::format("light{}", i + 1), {Kind::Light, int(i)});
  if (wanted.lights && (view::emits(scene) || view::backdropOf(scene))) add("emission", {Kind::Emission, 0});
  return {};
}

void report(const view::PathTracePass& pass, EvalContext& ctx) {
  const view::PathStatistics s = pass.statistics();
  ctx.note(fmt::format("{} samples{}, standard error {:.2g} %", s.samples,
                       pass.endedByTime() ? " (ended by time)" : "",
                       s.mean > 0 ? 100 * s.standardError / s.mean : 0));
  if (s.violations > 0) ctx.warn(fmt::format("{} collisions were denser than their bound", s.violations));
  if (s.endless > 0)
    ctx.warn(fmt::format("{} paths did not end and were cut off: is something closed that absorbs nothing?",
                         s.endless));
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  PILEUS_TRY(const auto* queue, runPasses<Pass>(ctx, [&](view::Renderer& renderer, Passes& passes) {
               return begin(in, ctx, renderer.device().software, passes);
             }));
  Pass& first = *queue->passes.front();
  const auto picture = first.picture();
  std::size_t bytes = 0;  // of the largest, with the deviations and half of the samples beside it
  for (const auto& pass : queue->passes)
    if (const auto made = pass->picture()) bytes = std::max(bytes, 3 * made->color.bytes());
  ctx.reportGpu(0, bytes);
  const residency::Residency& r = first.traced ? first.traced->residency() : first.marched->residency();
  if (r.coarsened > 0)
    ctx.warn(
        fmt::format("{} of the grids are drawn coarser than they are: their bricks need {}, {} are set aside "
                    "(--gpu-memory)",
                    r.coarsened, gl::neededMib(r.wantedBytes), gl::givenMib(r.budgetBytes)));
  if (queue->fraction < 1) {
    if (picture)
      ctx.partial(queue->fraction);
    else
      ctx.pending(queue->fraction, "Uploading bricks");
    return Out{{picture}};
  }
  if (!first.traced) return Out{{picture}};
  if (ctx.quality() == Quality::Final) {
    PILEUS_TRY(const auto variance, first.traced->variance());
    first.traced->addLayer({"variance", variance});
    report(*first.traced, ctx);
  }
  for (std::size_t i = 1; i < queue->passes.size(); ++i)
    first.traced->addLayer({queue->passes[i]->name, queue->passes[i]->picture()});
  return Out{{picture}};
}

}  // namespace

NodeType node_render_path_trace() { return makeNode<In, Out>("render.path_trace", 1, describe, evaluate); }

}  // namespace pileus::nodes
