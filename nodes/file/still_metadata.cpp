#include "nodes/file/still_metadata.h"

#include <span>

#include "nodes/file/serialize.h"
#include "renderer/base/hash.h"
#include "renderer/image/exr.h"

namespace pileus::nodes {

std::map<std::string, std::string> stillMetadata(const Graph& graph, const std::filesystem::path& target,
                                                 const std::filesystem::path& folder) {
  const std::string text = graphText(graph);
  return {{"software", "Pileus"},
          {"pileus:graph", hashBytes(std::as_bytes(std::span(text.data(), text.size()))).hex()},
          {"pileus:workingSpace", graph.settings.workingSpace},
          {image::kGraphAttribute, graphTextFor(target, graph, folder)}};
}

}  // namespace pileus::nodes
