// volume.cloud: procedural clouds of several genera, baked coarse to fine by jobs.
#include "nodes/declare/describe.h"
#include "renderer/base/jobs.h"
#include "renderer/volume/cloud/procedural.h"

namespace pileus::nodes {
namespace {

constexpr int kLeastResolution = 16;

struct In {
  static inline const volume::CloudParams defaults{};  // declared beside the bake
  volume::Genus genus = defaults.genus;
  int seed = defaults.seed;
  dvec3 center = defaults.center;
  dvec3 size = defaults.size;
  double base = defaults.base;
  double top = defaults.top;
  double coverage = defaults.coverage;
  double breadth = defaults.breadth;
  double density = defaults.density;
  double detail = defaults.detail;
  double billow = defaults.billow;
  double wisp = defaults.wisp;
  double anvil = defaults.anvil;
  double age = defaults.age;
  double shear = defaults.shear;
  double wind = defaults.wind;
  double time = defaults.time;
  int resolution = defaults.resolution;
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Cloud").category("Volume").keywords(
      "cumulus stratus stratocumulus cirrus anvil storm procedural noise sky weather bake");
  d.help(
      "Clouds inside a box, baked to voxels: first at a quarter of the resolution, then in full. Nothing "
      "stands outside the box, whatever the wind does.");
  d.in("genus", &In::genus)
      .help("What kind of cloud. Classic ones have no base, top, breadth, wisp, anvil, age, wind or time.");
  d.in("seed", &In::seed).range(0, 1000000000).soft(0, 100).help("Another number, another sky.");
  d.in("center", &In::center)
      .unit("m")
      .range(-1e6, 1e6)
      .soft(-1000, 1000)
      .help("Middle of the box that holds the clouds.");
  d.in("size", &In::size)
      .unit("m")
      .range(1e-3, 1e6)
      .soft(10, 5000)
      .help("Extent of the sky: edge lengths of the box.");
  d.in("base", &In::base)
      .range(0, 1)
      .help("Where the clouds begin, as a part of the box's height. Cumulus is cut level there.");
  d.in("top", &In::top)
      .range(0, 1)
      .help("Up to where the largest clouds reach, as a part of the box's height.");
  d.in("coverage", &In::coverage).range(0, 1).help("The part of the ground under cloud; 0 is a clear sky.");
  d.in("breadth", &In::breadth)
      .range(0.05, 100)
      .soft(0.3, 6)
      .logarithmic()
      .help(
          "Width of the largest cumulus in its heights: 4 flat heaps of fair weather, 1.5 heaps, 0.7 towers. "
          "Of layers and cirrus the size of pads and streaks.");
  d.in("density", &In::density)
      .range(0, 1e6)
      .soft(0.001, 1)
      .logarithmic()
      .help("In the core: with extinction 1 this is sigma_t in 1/m (cumulus: 0.03 to 0.13, cirrus: 0.005).");
  d.in("detail", &In::detail).range(0, 1).help("How strong what is small is: fine heads, fine threads.");
  d.in("billow", &In::billow).range(0, 1).help("Strength of the cauliflower bulges.");
  d.in("wisp", &In::wisp)
      .range(0, 1)
      .help("Torn shreds beside cumulus, softness of the edges of layers, threads of cirrus.");
  d.in("anvil", &In::anvil)
      .range(0, 2)
      .help("Radius of the disc of ice on top of the larger cumulus, in radii of the cloud; 0 is none.");
  d.in("age", &In::age)
      .range(0, 1)
      .help("0: small and crisp, still growing; 0.5: full-grown; 1: soft and thin, dissolving.");
  d.in("shear", &In::shear).range(-10, 10).soft(-1, 1).help("Wind: metres towards +X per metre of height.");
  d.in("wind", &In::wind)
      .unit("m/s")
      .range(-200, 200)
      .soft(-30, 30)
      .help("Carries the clouds towards +X. They form and dissolve at the walls of the box.");
  d.in("time", &In::time)
      .unit("s")
      .range(-1e6, 1e6)
      .soft(0, 600)
      .help("Moment of what is seen: bubbles rise, towers grow and dissolve. Key it, or link a time.");
  d.in("resolution", &In::resolution)
      .range(kLeastResolution, 1024)
      .soft(64, 512)
      .help("Voxels along the longest edge; time and memory grow with its cube.");
  d.out("volume", &Out::volume).help("The clouds as one volume with the default medium.");
}

using Bake = LooseJob<volume::GridPtr>;

/// The bakes in the order they run: the coarse one, then the full one.
struct Bakes {
  Bake coarse, full;
};

Bake startBake(const volume::CloudParams& params, volume::Cores cores) {
  return looseJob<volume::GridPtr>(
      [params, cores](JobControl& control) { return volume::bakeCloud(params, control, cores); });
}

Out placed(const volume::GridPtr& grid) {
  volume::Instance instance;
  instance.shape = volume::Shape::Grid;
  instance.grid = grid;
  instance.worldFromLocal = grid->worldFromIndex;
  Out out;
  out.volume.items.push_back(std::move(instance));
  return out;
}

volume::CloudParams paramsOf(const In& in) {
  return {.genus = in.genus,
          .seed = in.seed,
          .center = in.center,
          .size = in.size,
          .base = in.base,
          .top = in.top,
          .coverage = in.coverage,
          .breadth = in.breadth,
          .density = in.density,
          .detail = in.detail,
          .billow = in.billow,
          .wisp = in.wisp,
          .anvil = in.anvil,
          .shear = in.shear,
          .age = in.age,
          .wind = in.wind,
          .time = in.time,
          .resolution = in.resolution};
}

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  const volume::CloudParams params = paramsOf(in);
  volume::CloudParams quarter = params;
  quarter.resolution = std::max(kLeastResolution, in.resolution / 4);
  auto& bakes = ctx.state<Bakes>();
  if (!bakes.coarse) bakes.coarse = startBake(quarter, volume::Cores::All);
  if (!bakes.coarse->done()) {
    ctx.pending(0.05 * bakes.coarse->progress(), "Baking the cloud, coarse");
    return Out{};
  }
  if (!bakes.coarse->result()) return bakes.coarse->result().error();
  // Drafts of the coarse one are drawn meanwhile.
  if (!bakes.full) bakes.full = startBake(params, volume::Cores::LeaveOne);
  const bool done = bakes.full->done();
  if (done && !bakes.full->result()) return bakes.full->result().error();
  const volume::GridPtr& grid = done ? *bakes.full->result() : *bakes.coarse->result();
  if (!done) ctx.partial(0.05 + 0.95 * bakes.full->progress(), 1, true);
  if (grid->empty()) ctx.warn("no cloud at these parameters: the volume is empty");
  ctx.note(fmt::format("{} active voxels of {:.3g} m", grid->activeVoxels, grid->voxelSize));
  ctx.reportGpu(0, std::size_t(grid->payloadCount) * volume::kStoredVoxels);
  return placed(grid);
}

}  // namespace

NodeType node_volume_cloud() { return makeNode<In, Out>("volume.cloud", 2, describe, evaluate); }

}  // namespace pileus::nodes
