#include "nodes/types/shadow_common.h"

#include <algorithm>
#include <cmath>

#include "nodes/types/passes.h"
#include "renderer/shadow/shadow_pass.h"

namespace pileus::nodes {

Result<std::vector<scene::Light>> lightsOf(const LightValue& value) {
  if (value.items.empty()) return fail(Code::Input, "light: holds no light; link one");
  std::vector<scene::Light> out;
  for (const LightWithShadow& l : value.items) out.push_back(l.light);
  return out;
}

int draftTexelsOf(int resolution, int draftTexels) {
  constexpr int kUsual = 384, kLeast = 24;  // what maps begin with; what still tells where light comes from
  const int share = resolution < kUsual ? draftTexels * resolution / kUsual : draftTexels;
  return std::min({resolution, draftTexels, std::max(share, kLeast)});
}

int draftResolution(int resolution, const EvalContext& ctx) {
  if (ctx.quality() == Quality::Final) return resolution;
  if (ctx.draftTexels() > 0) return draftTexelsOf(resolution, ctx.draftTexels());
  return std::min(resolution, ctx.renderer() && ctx.renderer()->device().software ? 128 : 256);
}

void warnOfThinMedia(const std::vector<scene::Light>& lights, const volume::InstanceList& media,
                     int resolution, EvalContext& ctx) {
  constexpr int kMost = 4096;  // of describeResolution()
  for (const scene::Light& light : lights) {
    if (light.kind == scene::LightKind::Environment) continue;
    const auto thin =
        shadow::thinnestMedium(light, media, shadow::fitLight(light, media, resolution), resolution);
    if (!thin) continue;
    const double needed = std::ceil(thin->texel / thin->thickness * resolution / 64) * 64;
    ctx.warn(
        fmt::format("resolution: a texel is {:.3g} m wide, but a volume only {:.3g} m thick along the light: "
                    "its shadow is blurred; {}",
                    thin->texel, thin->thickness,
                    needed <= kMost ? fmt::format("{:.0f} texels tell it apart", needed)
                                    : "shadow.ray_march knows no texels"));
    return;
  }
}

namespace {

/// What the compression of deep maps came to, in words on the node.
void noteDeep(const std::vector<std::unique_ptr<shadow::ShadowPass>>& passes, EvalContext& ctx) {
  shadow::DeepStatistics all;
  for (const auto& pass : passes)
    if (const auto s = pass->deepStatistics()) {
      all.vertices += s->vertices;
      all.rawVertices += s->rawVertices;
      all.overBudget += s->overBudget;
      all.texels += s->texels;
      all.worstBound = std::max(all.worstBound, s->worstBound);
    }
  if (all.texels == 0) return;
  ctx.note(fmt::format("{} vertices, {:.1f} MiB with headers; {:.1f}x smaller than uncompressed",
                       all.vertices, double((all.vertices + all.texels) * 8) / (1 << 20), all.compression()));
  if (all.overBudget > 0)
    ctx.warn(fmt::format(
        "node_budget: {} of {} texels needed more vertices and got a larger error bound, up to {:.3g}",
        all.overBudget, all.texels, all.worstBound));
}

}  // namespace

Result<ShadowOut> shadowed(const ShadowIn& in, EvalContext& ctx, const char* what) {
  using Pass = shadow::ShadowPass;
  PILEUS_TRY(const std::vector<scene::Light> bare, lightsOf(in.light));
  const auto spec = shadow::withResolution(in.spec, draftResolution(shadow::resolutionOf(in.spec), ctx));
  const auto begin = [&](view::Renderer&, std::vector<std::unique_ptr<Pass>>& passes) -> Result<void> {
    for (const scene::Light& light : bare)
      if (light.kind != scene::LightKind::Environment)
        passes.push_back(std::make_unique<Pass>(spec, light, in.volumes.items, in.solids.items));
    return {};
  };
  PILEUS_TRY(const auto* queue, runPasses<Pass>(ctx, begin));
  ShadowOut out;
  std::size_t bytes = 0;
  auto pass = queue->passes.begin();
  for (const scene::Light& light : bare) {
    const auto map = light.kind == scene::LightKind::Environment
                         ? shadow::describedShadow(spec, light, in.volumes.items, in.solids.items)
                         : (*pass++)->map();
    bytes += map ? map->bytes() : 0;
    out.light.items.push_back({light, map});
  }
  ctx.reportGpu(0, bytes);
  if (queue->fraction < 1) {
    ctx.pending(queue->fraction, what);
  } else {
    noteDeep(queue->passes, ctx);
    if (shadow::resolutionOf(in.spec) > 0)
      warnOfThinMedia(bare, in.volumes.items, shadow::resolutionOf(in.spec), ctx);
  }
  return out;
}

}  // namespace pileus::nodes
