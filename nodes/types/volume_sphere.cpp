// volume.sphere: an exactly uniform ball, never voxelised.
#include "nodes/types/volume_common.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 center{0};
  double radius = 0.5;
  double density = 1;
};

void describe(Describe<In, VolumeOut>& d) {
  d.name("Sphere").category("Volume").keywords("ball uniform fog analytic ellipsoid");
  d.help("A ball of uniform density. Analytic: rays meet its exact surface, no voxels are made.");
  d.in("center", &In::center).unit("m").range(-1e6, 1e6).soft(-10, 10).help("Where its middle is.");
  d.in("radius", &In::radius)
      .unit("m")
      .range(1e-6, 1e6)
      .soft(0.01, 10)
      .help("From the middle to the surface.");
  describeUniform(d);
}

Result<VolumeOut> evaluate(const In& in, EvalContext&) {
  return uniform(volume::Shape::Ball, in.density, in.center, dvec3(in.radius));
}

}  // namespace

NodeType node_volume_sphere() { return makeNode<In, VolumeOut>("volume.sphere", 1, describe, evaluate); }

}  // namespace pileus::nodes
