// solid.box: an opaque box.
#include "nodes/types/solid_common.h"

namespace pileus::nodes {
namespace {

void describe(Describe<SolidIn, SolidOut>& d) {
  d.name("Solid Box").category("Solid").keywords("cube block building occluder opaque");
  d.help(
      "An opaque box with exact faces. It catches the shadows of volumes and solids, and casts its own where "
      "it is "
      "linked to a shadow. Matt.");
  describePlaced(d, 10, "Edge lengths.");
}

Result<SolidOut> evaluate(const SolidIn& in, EvalContext&) {
  return placed(scene::SolidShape::Box, in, in.size);
}

}  // namespace

NodeType node_solid_box() { return makeNode<SolidIn, SolidOut>("solid.box", 1, describe, evaluate); }

}  // namespace pileus::nodes
