// solid.box: an opaque box.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 center{0};
  dvec3 size{1};
  dvec3 rotate{0};
  Color albedo{vec3(0.5f)};
};

struct Out {
  SolidValue solid;
};

void describe(Describe<In, Out>& d) {
  d.name("Solid Box").category("Solid").keywords("cube block building occluder opaque");
  d.help(
      "An opaque box with exact faces. It catches the shadows of volumes and solids, and casts its own where "
      "it is "
      "linked to a shadow. Matt.");
  d.in("center", &In::center).unit("m").range(-1e6, 1e6).soft(-10, 10).help("Where its middle is.");
  d.in("size", &In::size).unit("m").range(1e-6, 1e6).soft(0.01, 10).help("Edge lengths.");
  d.in("rotate", &In::rotate)
      .unit("deg")
      .range(-36000, 36000)
      .soft(-180, 180)
      .help("Turns about X, then Y, then Z.");
  d.in("albedo", &In::albedo)
      .range(0, 1)
      .help("The part of the light it reflects, evenly (Lambert); linear, in the working space.");
  d.out("solid", &Out::solid).help("One solid.");
}

Result<Out> evaluate(const In& in, EvalContext&) {
  return Out{{{{scene::SolidShape::Box, composeTransform(in.center, in.rotate, in.size), in.albedo.rgb}}}};
}

}  // namespace

NodeType node_solid_box() { return makeNode<In, Out>("solid.box", 1, describe, evaluate); }

}  // namespace pileus::nodes
