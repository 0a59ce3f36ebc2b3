#include "editor/cli/graph_file.h"

#include <algorithm>
#include <cstdio>

#include <fmt/ranges.h>

namespace fs = std::filesystem;

namespace pileus::cli {

Result<nodes::Graph> loadFaultless(const fs::path& file, const char* what) {
  return withoutFaults(nodes::loadGraph(file), file, what);
}

Result<nodes::Graph> withoutFaults(Result<nodes::Loaded> loaded, const fs::path& file, const char* what) {
  if (!loaded) return loaded.error();
  bool bad = false;
  for (const nodes::Fault& f : loaded->faults) {
    std::fprintf(stderr, "pileus: %s: %s\n", file.c_str(), nodes::faultText(f).c_str());
    bad |= f.error;
  }
  if (bad) return fail(Code::Input, "{}: not {} because of the errors above", file.string(), what);
  return std::move(loaded->graph);
}

Result<std::string> outputNode(const nodes::Graph& graph, const fs::path& file, const std::string& wanted) {
  const std::vector<std::string> all = nodes::outputNodes(graph);
  if (!wanted.empty()) {
    if (std::find(all.begin(), all.end(), wanted) != all.end()) return wanted;
    return fail(Code::Arguments, "--output: {} has no output node named '{}'{}", file.string(), wanted,
                all.empty() ? "" : "; it has " + fmt::format("{}", fmt::join(all, ", ")));
  }
  if (all.empty())
    return fail(Code::Input, "{}: has no output node (output.exr or output.view)", file.string());
  std::vector<std::string> files;
  for (const std::string& n : all)
    if (nodes::findNode(graph, n)->type == "output.exr") files.push_back(n);
  const std::vector<std::string>& candidates = files.empty() ? all : files;
  if (candidates.size() == 1) return candidates.front();
  return fail(Code::Arguments, "{}: has several output nodes ({}); choose one with --output", file.string(),
              fmt::join(candidates, ", "));
}

DisplayChoice displayOf(const nodes::Graph& graph, const std::string& preferred) {
  const nodes::Node* shown = nodes::findNode(graph, preferred);
  if (!shown || shown->type != "output.view") {
    shown = nullptr;
    for (const std::string& n : nodes::outputNodes(graph))
      if (const nodes::Node* node = nodes::findNode(graph, n); node->type == "output.view") shown = node;
  }
  if (!shown) return {};
  const nodes::NodeType& type = *nodes::findNodeType("output.view");
  return {std::get<std::string>(nodes::paramValue(*shown, *type.param("display"))),
          std::get<std::string>(nodes::paramValue(*shown, *type.param("view"))),
          std::get<double>(nodes::paramValue(*shown, *type.param("exposure"))),
          std::get<std::string>(nodes::paramValue(*shown, *type.param("look"))),
          std::get<double>(nodes::paramValue(*shown, *type.param("gamma")))};
}

Result<std::shared_ptr<const image::ColorConfig>> colorConfigOf(const nodes::Graph& graph,
                                                                const fs::path& folder) {
  return image::ColorConfig::load(nodes::colorConfigPath(graph.settings, folder));
}

}  // namespace pileus::cli
