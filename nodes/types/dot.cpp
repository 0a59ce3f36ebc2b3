// dot: a bend in a link.
#include "nodes/declare/structure.h"

namespace pileus::nodes {

NodeType node_dot() {
  NodeType type = structureNode("dot", "Dot", "reroute bend wire point");
  type.help = "A bend in a link: passes whatever is linked to it, a whole list as well, and costs nothing.";
  addAny(type.inputs, "in", "In", "What to pass on.");
  addAny(type.outputs, "out", "Out", "The same.");
  return type;
}

}  // namespace pileus::nodes
