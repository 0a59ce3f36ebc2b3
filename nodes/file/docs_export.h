#pragma once
// docs/nodes.md and the machine-readable list, from the declarations.
#include <string>

namespace pileus::nodes {

std::string nodesMarkdown();
std::string nodesJson();
std::string nodesText();  ///< short table for a terminal

}  // namespace pileus::nodes
