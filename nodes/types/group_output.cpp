// group.output: an output of the group it stands in.
#include "nodes/declare/structure.h"

namespace pileus::nodes {

NodeType node_group_output() {
  NodeType type = structureNode("group.output", "Group Output", "subgraph socket result");
  type.help = "One output of the group around it, under this node's name.";
  addAny(type.inputs, "in", "In", "What the group gives there.");
  return type;
}

}  // namespace pileus::nodes
