#include "editor/cli/graph_file.h"

#include <cstdio>

#include "nodes/file/serialize.h"

namespace fs = std::filesystem;

namespace pileus::cli {

Result<nodes::Graph> loadFaultless(const fs::path& file, const char* what) {
  PILEUS_TRY(nodes::Loaded loaded, nodes::loadGraph(file));
  bool bad = false;
  for (const nodes::Fault& f : loaded.faults) {
    std::fprintf(stderr, "pileus: %s: %s\n", file.c_str(), nodes::faultText(f).c_str());
    bad |= f.error;
  }
  if (bad) return fail(Code::Input, "{}: not {} because of the errors above", file.string(), what);
  return std::move(loaded.graph);
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
  std::string ocio = graph.settings.ocio;
  if (!ocio.empty() && fs::path(ocio).is_relative() && ocio.find("://") == ocio.npos)
    ocio = (folder / ocio).string();
  return image::ColorConfig::load(ocio);
}

}  // namespace pileus::cli
