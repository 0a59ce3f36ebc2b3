// solid.plane: an opaque rectangle.
#include "nodes/declare/describe.h"

namespace pileus::nodes {
namespace {

struct In {
  dvec3 center{0};
  dvec3 size{10, 1, 10};
  dvec3 rotate{0};
  Color albedo{vec3(0.5f)};
};

struct Out {
  SolidValue solid;
};

void describe(Describe<In, Out>& d) {
  d.name("Plane").category("Solid").keywords("ground floor wall rectangle opaque surface receiver");
  d.help(
      "An opaque rectangle, level unless turned, without thickness. It catches the shadows of volumes and "
      "solids, and "
      "casts its own where it is linked to a shadow. Both sides are matt.");
  d.in("center", &In::center).unit("m").range(-1e6, 1e6).soft(-10, 10).help("Where its middle is.");
  d.in("size", &In::size)
      .unit("m")
      .range(1e-6, 1e6)
      .soft(0.01, 20)
      .help("Edge lengths along X and Z; Y is not used.");
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
  const dmat4 placed = composeTransform(in.center, in.rotate, dvec3(in.size.x, 1, in.size.z));
  return Out{{{{scene::SolidShape::Plane, placed, in.albedo.rgb}}}};
}

}  // namespace

NodeType node_solid_plane() { return makeNode<In, Out>("solid.plane", 1, describe, evaluate); }

}  // namespace pileus::nodes
