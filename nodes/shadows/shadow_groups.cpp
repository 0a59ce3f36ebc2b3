#include "nodes/shadows/shadow_groups.h"

#include <algorithm>

namespace pileus::nodes {
namespace {

using shadow::ShadowSpec;

bool alike(const ShadowSpec& a, const ShadowSpec& b) {
  const bool metric = (a.metric.metric == shadow::Metric::None) == (b.metric.metric == shadow::Metric::None);
  return a.kind == b.kind && (a.kind != ShadowSpec::Kind::Extinction || metric);
}

}  // namespace

std::vector<ShadowGroup> shadowGroups(const Graph& graph, const std::string& renderNode, double frame,
                                      const view::RenderScene& scene) {
  std::vector<ShadowGroup> groups;
  for (const ShadowNodes& n : shadowsOf(graph, renderNode, frame)) {
    if (n.spec.kind == ShadowSpec::Kind::RayMarch) continue;
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [&](const ShadowGroup& g) { return alike(g.nodes.front().spec, n.spec); });
    (same == groups.end() ? groups.emplace_back() : *same).nodes.push_back(n);
  }
  for (const truth::Caster& c : truth::casters(scene)) {
    const auto& shadow = scene.lights[std::size_t(c.light)].shadow;
    for (ShadowGroup& g : groups)
      if (shadow && alike(g.nodes.front().spec, shadow->spec)) g.casters.push_back(c);
  }
  std::erase_if(groups, [](const ShadowGroup& g) { return g.casters.empty(); });
  return groups;
}

Result<Graph> writeGroup(const Graph& graph, const ShadowGroup& group, const ShadowSpec& spec) {
  Graph out = graph;
  for (const ShadowNodes& n : group.nodes) {
    PILEUS_TRY(out, writeShadow(out, n, spec));
  }
  return out;
}

}  // namespace pileus::nodes
