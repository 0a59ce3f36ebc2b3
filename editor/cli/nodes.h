#pragma once
// pileus nodes: every node type and parameter on standard output.

namespace pileus::cli {

enum class NodesFormat { Text, Markdown, Json };

/// Returns the exit code: 0.
int nodesMain(NodesFormat format);

}  // namespace pileus::cli
