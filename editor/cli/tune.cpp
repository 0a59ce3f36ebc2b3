#include "editor/cli/tune.h"

#include <algorithm>
#include <cstdio>

#include "editor/cli/scene_file.h"
#include "nodes/file/serialize.h"
#include "nodes/shadows/shadow_groups.h"
#include "renderer/base/profile.h"
#include "renderer/shadow/shadow_map.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

std::string goalText(const truth::TuneGoal& goal) {
  switch (goal.bound) {
    case truth::TuneBound::P95:
      return fmt::format("p95 |dT| <= {:g}", goal.limit);
    case truth::TuneBound::Milliseconds:
      return fmt::format("{:g} ms", goal.limit);
    case truth::TuneBound::Mebibytes:
      break;
  }
  return fmt::format("{:g} MiB", goal.limit);
}

std::string candidateText(const truth::TuneCandidate& c) {
  return fmt::format("{}, {} texels: p95 {:.4f}, {:.3f} MiB, {:.2f} ms", shadow::describe(c.spec),
                     shadow::resolutionOf(c.spec), c.p95, double(c.bytes) / (1 << 20), c.ms());
}

void printCurve(const truth::Tuner& tuner) {
  const auto best = tuner.best();
  fmt::print("{:<2}{:>9} {:>9} {:>9} {:>9} {:>10} {:>7}  {}\n", "", "MiB", "p95 |dT|", "mean", "build ms",
             "ns/lookup", "texels", "representation");
  for (const truth::TuneCandidate& c : tuner.curve())
    fmt::print("{:<2}{:>9.3f} {:>9.4f} {:>9.5f} {:>9.2f} {:>10.1f} {:>7}  {}\n",
               best && c.spec == best->spec ? "*" : "", double(c.bytes) / (1 << 20), c.p95, c.mean, c.buildMs,
               c.nsPerLookup, shadow::resolutionOf(c.spec), shadow::describe(c.spec));
}

/// The graph with the group's nodes tuned.
Result<nodes::Graph> tuneGroup(const SceneFile& file, const TuneArguments& a, const nodes::ShadowGroup& group,
                               double share, const nodes::Graph& graph) {
  truth::TuneGoal goal = a.goal;
  if (goal.bound != truth::TuneBound::P95)
    goal.limit *= share;  // what is spent is shared by number of lights
  truth::Tuner tuner(group.casters, group.nodes.front().spec, goal,
                     {{.count = a.points}, std::min(128, a.maxResolution), a.maxResolution});
  const shadow::Gpu gpu = file.renderer->gpu();
  MeasureProgress progress;
  for (double done = 0; done < 1;) {
    if (interrupted()) return fail(Code::Cancelled, "cancelled");
    const auto step = tuner.step(gpu, 250);
    if (!step) return fail(step.error().code, "{}: {}", a.file.string(), step.error().message);
    progress.show(done = *step, tuner.doing());
  }
  progress.finish();
  printCurve(tuner);
  const auto best = tuner.best();
  if (!best)
    return fail(Code::Bound, "{}: {} cannot be met; nearest is {}", a.file.string(), goalText(goal),
                candidateText(*tuner.nearest()));
  fmt::print("{} tried; {}\n", tuner.measured().size(), candidateText(*best));
  return nodes::writeGroup(graph, group, best->spec);
}

Result<void> run(const TuneArguments& a) {
  std::error_code ec;
  if (fs::exists(a.out, ec) && !a.overwrite)
    return fail(Code::Input, "{}: exists; --overwrite replaces it", a.out.string());
  PILEUS_TRY(const SceneFile file, openScene(a.file, a.render));
  const std::vector<nodes::ShadowGroup> groups =
      nodes::shadowGroups(file.graph, file.renderNode, file.graph.settings.frames.x, file.scene);
  if (groups.empty())
    return fail(Code::Input, "{}: no light of {} has a shadow map to tune", a.file.string(), file.renderNode);
  std::size_t lights = 0;
  for (const nodes::ShadowGroup& g : groups) lights += g.casters.size();
  nodes::Graph graph = file.graph;
  for (const nodes::ShadowGroup& g : groups) {
    PILEUS_TRY(graph, tuneGroup(file, a, g, double(g.casters.size()) / double(lights), graph));
  }
  PILEUS_CHECK(nodes::saveGraph(a.out, graph, fs::absolute(a.file).parent_path()));
  fmt::print("{}: {} written\n", a.out.string(), goalText(a.goal));
  std::fflush(stdout);
  return {};
}

}  // namespace

int tuneMain(const TuneArguments& arguments) {
  const Result<void> r = run(arguments);
  if (r) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "pileus: {}\n", r.error().message);
  return static_cast<int>(r.error().code);
}

}  // namespace pileus::cli
