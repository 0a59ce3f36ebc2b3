// volume.cloud: a procedural field of cumulus, baked coarse to fine by jobs.
#include "nodes/declare/describe.h"
#include "renderer/base/jobs.h"
#include "renderer/volume/procedural.h"

namespace pileus::nodes {
namespace {

constexpr int kLeastResolution = 16;

struct In {
  static inline const volume::CloudParams defaults{};  // declared beside the bake
  int seed = defaults.seed;
  dvec3 center = defaults.center;
  dvec3 size = defaults.size;
  double coverage = defaults.coverage;
  double density = defaults.density;
  double detail = defaults.detail;
  double billow = defaults.billow;
  double shear = defaults.shear;
  int resolution = defaults.resolution;
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Cloud").category("Volume").keywords("cumulus procedural noise sky weather bake");
  d.help(
      "A field of cumulus clouds inside a box, baked to voxels: first at a quarter of the resolution, then "
      "in full.");
  d.in("seed", &In::seed).range(0, 1000000000).soft(0, 100).help("Another number, another sky.");
  d.in("center", &In::center)
      .unit("m")
      .range(-1e6, 1e6)
      .soft(-1000, 1000)
      .help("Middle of the box that holds the clouds.");
  d.in("size", &In::size).unit("m").range(1e-3, 1e6).soft(10, 5000).help("Edge lengths of the box.");
  d.in("coverage", &In::coverage).range(0, 1).help("The part of the ground under cloud; 0 is a clear sky.");
  d.in("density", &In::density)
      .range(0, 1e6)
      .soft(0.001, 1)
      .logarithmic()
      .help("In the core: with extinction 1 this is sigma_t in 1/m (cumulus: 0.03 to 0.06).");
  d.in("detail", &In::detail).range(0, 1).help("How far fine noise erodes the edges.");
  d.in("billow", &In::billow).range(0, 1).help("Strength of the cauliflower bulges.");
  d.in("shear", &In::shear).range(-10, 10).soft(-1, 1).help("Wind: metres towards +X per metre of height.");
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

Bake startBake(const volume::CloudParams& params) {
  return looseJob<volume::GridPtr>(
      [params](JobControl& control) { return volume::bakeCloud(params, control); });
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

Result<Out> evaluate(const In& in, EvalContext& ctx) {
  const volume::CloudParams params{in.seed,   in.center, in.size,  in.coverage,  in.density,
                                   in.detail, in.billow, in.shear, in.resolution};
  volume::CloudParams quarter = params;
  quarter.resolution = std::max(kLeastResolution, in.resolution / 4);
  auto& bakes = ctx.state<Bakes>();
  if (!bakes.coarse) bakes.coarse = startBake(quarter);
  if (!bakes.coarse->done()) {
    ctx.pending(0.05 * bakes.coarse->progress(), "Baking the cloud, coarse");
    return Out{};
  }
  if (!bakes.coarse->result()) return bakes.coarse->result().error();
  if (!bakes.full) bakes.full = startBake(params);
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

NodeType node_volume_cloud() { return makeNode<In, Out>("volume.cloud", 1, describe, evaluate); }

}  // namespace pileus::nodes
