// volume.sphere: an exactly uniform ball, never voxelised.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 center{0};
  double radius = 0.5;
  double density = 1;
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Sphere").category("Volume").keywords("ball uniform fog analytic ellipsoid");
  d.help("A ball of uniform density. Analytic: rays meet its exact surface, no voxels are made.");
  d.in("center", &In::center).unit("m").range(-1e6, 1e6).soft(-10, 10).help("Where its middle is.");
  d.in("radius", &In::radius)
      .unit("m")
      .range(1e-6, 1e6)
      .soft(0.01, 10)
      .help("From the middle to the surface.");
  d.in("density", &In::density)
      .range(0, 1e6)
      .soft(0, 10)
      .help("Density inside; the medium's extinction multiplies it.");
  d.out("volume", &Out::volume).help("One volume with the default medium.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  Out out;
  volume::Instance instance;
  instance.shape = volume::Shape::Ball;
  instance.density = in.density;
  instance.worldFromLocal = composeTransform(in.center, dvec3(0.0), dvec3(in.radius));
  out.volume.items.push_back(instance);
  return out;
}

}  // namespace

NodeType node_volume_sphere() { return makeNode<In, Out>("volume.sphere", 1, describe, evaluate); }

}  // namespace pileus::nodes
