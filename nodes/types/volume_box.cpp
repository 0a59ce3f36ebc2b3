// volume.box: an exactly uniform box, never voxelised.
#include "nodes/types/volume_common.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 center{0};
  dvec3 size{1};
  double density = 1;
};

void describe(Describe<In, VolumeOut>& d) {
  d.name("Box").category("Volume").keywords("cube slab uniform fog analytic");
  d.help("A box of uniform density. Analytic: rays meet its exact faces, no voxels are made.");
  d.in("center", &In::center).unit("m").range(-1e6, 1e6).soft(-10, 10).help("Where its middle is.");
  d.in("size", &In::size).unit("m").range(1e-6, 1e6).soft(0.01, 10).help("Edge lengths.");
  describeUniform(d);
}

Result<VolumeOut> evaluate(const In& in, EvalContext&) {
  return uniform(volume::Shape::Box, in.density, in.center, in.size);
}

}  // namespace

NodeType node_volume_box() { return makeNode<In, VolumeOut>("volume.box", 1, describe, evaluate); }

}  // namespace pileus::nodes
