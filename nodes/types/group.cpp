// group: a graph within the graph.
#include "nodes/declare/structure.h"

namespace pileus::nodes {

NodeType node_group() {
  NodeType type = structureNode("group", "Group", "subgraph nest compound macro");
  type.help =
      "Holds a graph of its own, which is edited by entering it. Its sockets are the group inputs and group "
      "outputs inside, in their "
      "order from top to bottom. It is evaluated as if its nodes stood where it stands.";
  return type;
}

}  // namespace pileus::nodes
