#pragma once
// pileus check: every fault of graph files, by node and key, without rendering and without a GPU.
#include <filesystem>
#include <string>
#include <vector>

#include "nodes/file/serialize.h"

namespace pileus::cli {

/// What evaluation would refuse although the file reads well: input files that are missing or not chosen,
/// inputs with nothing linked. Errors in what an output needs, warnings elsewhere (but a file that is named
/// and missing is always an error).
std::vector<nodes::Fault> checkNeeds(const nodes::Graph& graph, const std::filesystem::path& folder);

/// Prints "FILE: error: Node.param: text" and warnings on standard error, one line of summary per file on
/// standard output. Exit code: 0 (warnings at most) or 3.
int checkMain(const std::vector<std::string>& files);

}  // namespace pileus::cli
