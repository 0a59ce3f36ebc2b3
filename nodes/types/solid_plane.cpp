// solid.plane: an opaque rectangle.
#include "nodes/types/solid_common.h"

namespace pileus::nodes {
namespace {

void describe(Describe<SolidIn, SolidOut>& d) {
  d.name("Plane").category("Solid").keywords("ground floor wall rectangle opaque surface receiver");
  d.help(
      "An opaque rectangle, level unless turned, without thickness. It catches the shadows of volumes and "
      "solids, and "
      "casts its own where it is linked to a shadow. Both sides are matt.");
  describePlaced(d, 20, "Edge lengths along X and Z; Y is not used.");
}

Result<SolidOut> evaluate(const SolidIn& in, EvalContext&) {
  return placed(scene::SolidShape::Plane, in, dvec3(in.size.x, 1, in.size.z));
}

}  // namespace

NodeType node_solid_plane() {
  return makeNode<SolidIn, SolidOut>("solid.plane", 1, describe, evaluate, {.size = {10, 1, 10}});
}

}  // namespace pileus::nodes
