// volume.transform: moves, turns and scales whole volumes about the origin.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  VolumeValue volume;
  dvec3 translate{0};
  dvec3 rotate{0};
  dvec3 scale{1};
};

struct Out {
  VolumeValue volume;
};

void describe(Describe<In, Out>& d) {
  d.name("Transform").category("Volume").keywords("move rotate scale mirror translate place");
  d.help(
      "Places volumes: scale, then rotation about X, Y and Z, then translation, all about the origin. "
      "Extinction stays per "
      "metre, so a larger volume is optically thicker.");
  d.in("volume", &In::volume).required().help("What to place.");
  d.in("translate", &In::translate).unit("m").range(-1e6, 1e6).soft(-10, 10).help("Moves along the axes.");
  d.in("rotate", &In::rotate)
      .unit("deg")
      .range(-36000, 36000)
      .soft(-180, 180)
      .help("Turns about X, then Y, then Z.");
  d.in("scale", &In::scale)
      .range(-1e6, 1e6)
      .soft(0.01, 10)
      .help("Along each axis; negative mirrors, zero is refused.");
  d.out("volume", &Out::volume).help("The placed volumes.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(in.scale[axis]) < 1e-9)
      return fail(Code::Input, "scale: {} along {} leaves nothing; use a value other than zero",
                  in.scale[axis], "XYZ"[axis]);
  const dmat4 placement = composeTransform(in.translate, in.rotate, in.scale);
  Out out{in.volume};
  for (volume::Instance& instance : out.volume.items)
    instance.worldFromLocal = placement * instance.worldFromLocal;
  return out;
}

}  // namespace

NodeType node_volume_transform() { return makeNode<In, Out>("volume.transform", 1, describe, evaluate); }

}  // namespace pileus::nodes
