// group.input: an input of the group it stands in.
#include "nodes/declare/structure.h"

namespace pileus::nodes {

NodeType node_group_input() {
  NodeType type = structureNode("group.input", "Group Input", "subgraph socket expose parameter");
  type.help =
      "One input of the group around it, under this node's name; its type is that of what it feeds. Linked "
      "to a parameter inside, it "
      "lets that parameter be set from outside.";
  addAny(type.outputs, "out", "Out", "What is linked to the group's input.");
  return type;
}

}  // namespace pileus::nodes
