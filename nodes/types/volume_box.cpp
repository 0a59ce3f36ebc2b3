// volume.box: an exactly uniform box, never voxelised.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 center{0};
  dvec3 size{1};
  double density = 1;
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Box").category("Volume").keywords("cube slab uniform fog analytic");
  d.help("A box of uniform density. Analytic: rays meet its exact faces, no voxels are made.");
  d.in("center", &In::center).unit("m").range(-1e6, 1e6).soft(-10, 10).help("Where its middle is.");
  d.in("size", &In::size).unit("m").range(1e-6, 1e6).soft(0.01, 10).help("Edge lengths.");
  d.in("density", &In::density)
      .range(0, 1e6)
      .soft(0, 10)
      .help("Density inside; the medium's extinction multiplies it.");
  d.out("volume", &Out::volume).help("One volume with the default medium.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  Out out;
  volume::Instance instance;
  instance.shape = volume::Shape::Box;
  instance.density = in.density;
  instance.worldFromLocal = composeTransform(in.center, dvec3(0.0), in.size);
  out.volume.items.push_back(instance);
  return out;
}

}  // namespace

NodeType node_volume_box() { return makeNode<In, Out>("volume.box", 1, describe, evaluate); }

}  // namespace pileus::nodes
