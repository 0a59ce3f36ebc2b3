// Graph files as a whole: versions, faults between nodes, paths relative to the file.
#include "nodes/serialize.h"

#include "nodes/migrations.h"
#include "nodes/serialize_json.h"
#include "renderer/base/file.h"

namespace fs = std::filesystem;

namespace pileus::nodes {
namespace {

constexpr std::size_t kLargestFile = std::size_t(64) << 20;

std::string linkText(const Link& link) {
  return link.fromNode + "." + link.fromSocket + " -> " + link.toNode + "." + link.toSocket;
}

fs::path absolutePath(const fs::path& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal();
}

/// `path` as seen from `folder`; absolute if they share no more than the root.
std::string relativeTo(const fs::path& path, const fs::path& folder) {
  auto a = path.begin(), b = folder.begin();
  int shared = 0;
  for (; a != path.end() && b != folder.end() && *a == *b && !a->empty(); ++a, ++b) ++shared;
  return shared > 1 ? path.lexically_relative(folder).generic_string() : path.generic_string();
}

/// The same graph with every file parameter as it stands in a file in `to`, when relative ones start in
/// `from`.
Graph withRelativePaths(const Graph& graph, const fs::path& from, const fs::path& to) {
  Graph result = graph;
  for (auto& [name, node] : result.nodes) {
    const NodeType* type = findNodeType(node->type);
    if (!type) continue;
    Node changed = *node;
    for (const ParamSpec& spec : type->params) {
      const auto it = changed.params.find(spec.id);
      if (spec.type != ParamType::File || it == changed.params.end()) continue;
      auto* text = std::get_if<std::string>(&it->second);
      if (!text || text->empty() || (from == to && fs::path(*text).is_relative())) continue;
      *text = relativeTo((from / *text).lexically_normal(), to);
    }
    if (changed != *node) node = std::make_shared<const Node>(std::move(changed));
  }
  return result;
}

}  // namespace

void checkLinks(const Graph& graph, std::vector<Fault>& faults) {
  std::map<std::pair<std::string, std::string>, std::string> taken;
  for (const Link& link : graph.links) {
    const NodeType* from = findNodeType(findNode(graph, link.fromNode)->type);
    const NodeType* to = findNodeType(findNode(graph, link.toNode)->type);
    const int out = from ? from->outputIndex(link.fromSocket) : -1,
              in = to ? to->inputIndex(link.toSocket) : -1;
    if (from && out < 0)
      faults.push_back({true, link.fromNode + "." + link.fromSocket,
                        "there is no such output, in link " + linkText(link)});
    if (to && in < 0)
      faults.push_back(
          {true, link.toNode + "." + link.toSocket, "there is no such input, in link " + linkText(link)});
    if (in < 0) continue;
    const SocketSpec& input = to->inputs[static_cast<std::size_t>(in)];
    const std::string where = link.toNode + "." + link.toSocket;
    if (out >= 0 && !convertible(from->outputs[static_cast<std::size_t>(out)].type, input.type))
      faults.push_back(
          {true, where,
           fmt::format("takes {}, but {}.{} gives {}", enumId(input.type), link.fromNode, link.fromSocket,
                       enumId(from->outputs[static_cast<std::size_t>(out)].type))});
    if (input.many) continue;
    const auto [it, first] = taken.try_emplace({link.toNode, link.toSocket}, linkText(link));
    if (!first)
      faults.push_back({true, where, "takes one link, but has " + it->second + " and " + linkText(link)});
  }
  if (const auto order = evaluationOrder(graph); !order)
    faults.push_back({true, "links", order.error().message});
}

Result<Loaded> parseGraph(std::string_view text) {
  Loaded loaded;
  PILEUS_TRY(Json json, parseJson(text, loaded.faults));
  if (!json.is_object()) return fail(Code::Input, "not a Pileus graph: the file holds no object");
  const auto version = json.find("pileus");
  if (version == json.end())
    return fail(Code::Input, "not a Pileus graph: \"pileus\" (the format's version) is missing");
  if (!version->is_number_integer() || *version < 1)
    return fail(Code::Input, "not a Pileus graph: \"pileus\" is not a format version");
  if (*version > kFormatVersion)
    return fail(Code::Input,
                "written by a newer Pileus: format {}, and this one reads up to {}; update Pileus to open it",
                version->dump(), kFormatVersion);
  migrate(json, version->get<int>(), migrations());
  loaded.graph = graphFromJson(json, loaded.faults);
  checkLinks(loaded.graph, loaded.faults);
  return loaded;
}

Result<Loaded> loadGraph(const fs::path& path) {
  PILEUS_TRY(const std::string text, readFile(path, kLargestFile));
  auto loaded = parseGraph(text);
  if (!loaded) return fail(loaded.error().code, "{}: {}", path.string(), loaded.error().message);
  return loaded;
}

Result<void> saveGraph(const fs::path& path, const Graph& graph, const fs::path& folder) {
  const fs::path to = absolutePath(path).parent_path();
  return writeFileAtomic(path,
                         graphText(withRelativePaths(graph, folder.empty() ? to : absolutePath(folder), to)));
}

std::string faultText(const Fault& fault) {
  return std::string(fault.error ? "error: " : "warning: ") +
         (fault.where.empty() ? "" : fault.where + ": ") + fault.text;
}

}  // namespace pileus::nodes
