// Graph files as a whole: versions, faults between nodes, paths relative to the file.
#include "nodes/file/serialize.h"

#include <algorithm>
#include <fstream>

#include "nodes/file/migrations.h"
#include "nodes/file/serialize_json.h"
#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_groups.h"
#include "nodes/graph/graph_sockets.h"
#include "renderer/base/file.h"

namespace fs = std::filesystem;

namespace pileus::nodes {
namespace {

constexpr std::size_t kLargestFile = std::size_t(64) << 20;

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

/// What a file is that one may take for a graph; empty: it may be one.
std::string whatElse(const fs::path& path) {
  using namespace std::string_view_literals;
  std::error_code ec;
  if (!fs::is_regular_file(path, ec)) return {};
  char head[8] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head);
  const std::string_view start(head, sizeof head);
  if (start.starts_with(" BDV\0\0\0\0"sv))
    return "a volume, not a graph: open it with `pileus " + path.string() +
           "`, or make a scene of it with a VDB File node whose file it is";
  if (start.starts_with("\x76\x2f\x31\x01"sv))
    return "an OpenEXR picture, not a graph: open it with `pileus " + path.string() +
           "`, if Pileus exported it";
  return {};
}

}  // namespace

Graph withRelativePaths(const Graph& graph, const fs::path& from, const fs::path& to) {
  Graph result = graph;
  const auto moved = [&](const std::string& text) {
    return text.empty() || (from == to && fs::path(text).is_relative())
               ? text
               : relativeTo((from / text).lexically_normal(), to);
  };
  std::string& ocio = result.settings.ocio;
  if (ocio.find("://") == ocio.npos) ocio = moved(ocio);  // not the name of one that is built in
  for (auto& [name, node] : result.nodes) {
    const NodeType* type = findNodeType(node->type);
    if (!type) continue;
    Node changed = *node;
    if (node->group) changed.group = std::make_shared<const Graph>(withRelativePaths(*node->group, from, to));
    for (const ParamSpec& spec : type->params) {
      if (spec.type != ParamType::File) continue;
      const auto move = [&](ParamValue& value) {
        if (auto* text = std::get_if<std::string>(&value)) *text = moved(*text);
      };
      if (const auto it = changed.params.find(spec.id); it != changed.params.end()) move(it->second);
      if (const auto it = changed.animated.find(spec.id); it != changed.animated.end())
        for (AnimationKey& key : it->second.keys) move(key.value);
    }
    if (!(changed == *node)) node = std::make_shared<const Node>(std::move(changed));
  }
  return result;
}

void checkLinks(const Graph& graph, std::vector<Fault>& faults, const std::string& prefix) {
  std::map<std::pair<std::string, std::string>, std::string> taken;
  const SocketTable table(graph);
  const auto error = [&](const std::string& where, std::string text) {
    faults.push_back({true, prefix + where, std::move(text)});
  };
  for (const Link& link : graph.links) {
    const bool knowsFrom = findNodeType(findNode(graph, link.fromNode)->type),
               knowsTo = findNodeType(findNode(graph, link.toNode)->type);
    const auto out = table.output(link.fromNode, link.fromSocket),
               in = table.input(link.toNode, link.toSocket);
    if (knowsFrom && !out)
      error(link.fromNode + "." + link.fromSocket, "there is no such output, in link " + linkText(link));
    if (knowsTo && !in)
      error(link.toNode + "." + link.toSocket, "there is no such input, in link " + linkText(link));
    if (!in || !knowsTo) continue;
    const std::string where = link.toNode + "." + link.toSocket;
    if (knowsFrom && out && !out->any && !in->any && !convertible(out->type, in->type))
      error(where, fmt::format("takes {}, but {}.{} gives {}", enumId(in->type), link.fromNode,
                               link.fromSocket, enumId(out->type)));
    if (in->many) continue;
    const auto [it, first] = taken.try_emplace({link.toNode, link.toSocket}, linkText(link));
    if (!first) error(where, "takes one link, but has " + it->second + " and " + linkText(link));
  }
  if (const auto order = evaluationOrder(graph); !order) error("links", order.error().message);
  const std::size_t depth = static_cast<std::size_t>(std::count(prefix.begin(), prefix.end(), '/'));
  for (const auto& [name, node] : graph.nodes) {
    if (!node->group) continue;
    if (depth >= kDeepestGroup)
      error(name, fmt::format("groups are nested deeper than {}", kDeepestGroup));
    else
      checkLinks(*node->group, faults, prefix + name + "/");
  }
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
  checkLinks(loaded.graph, loaded.faults, "");
  return loaded;
}

Result<Loaded> loadGraph(const fs::path& path) {
  if (const std::string other = whatElse(path); !other.empty())
    return fail(Code::Input, "{}: {}", path.string(), other);
  PILEUS_TRY(const std::string text, readFile(path, kLargestFile));
  auto loaded = parseGraph(text);
  if (!loaded) return fail(loaded.error().code, "{}: {}", path.string(), loaded.error().message);
  return loaded;
}

std::string graphTextFor(const fs::path& path, const Graph& graph, const fs::path& folder) {
  const fs::path to = absolutePath(path).parent_path();
  return graphText(withRelativePaths(graph, folder.empty() ? to : absolutePath(folder), to));
}

Result<void> saveGraph(const fs::path& path, const Graph& graph, const fs::path& folder, fs::path* kept) {
  if (const auto there = loadGraph(path); there && there->loses()) {
    const auto copy = backUp(path);
    if (!copy)
      return fail(copy.error().code, "{}: what could not be read of it cannot be kept: {}", path.string(),
                  copy.error().message);
    if (kept) *kept = *copy;
  }
  return writeFileAtomic(path, graphTextFor(path, graph, folder));
}

bool Loaded::loses() const {
  return std::any_of(faults.begin(), faults.end(), [](const Fault& f) { return f.lost; });
}

Result<fs::path> backUp(const fs::path& path) {
  constexpr int kMost = 1000;
  PILEUS_TRY(const std::string content, readFile(path, kLargestFile));
  std::error_code ec;
  for (int i = 1; i <= kMost; ++i) {
    const fs::path copy = path.string() + (i == 1 ? ".bak" : fmt::format(".bak{}", i));
    if (fs::exists(fs::symlink_status(copy, ec))) {
      const auto there = readFile(copy, kLargestFile);
      if (there && *there == content) return copy;
      continue;
    }
    PILEUS_CHECK(writeFileAtomic(copy, content));
    return copy;
  }
  return fail(Code::Input, "{}: no copy of it could be kept, there are {} already", path.string(), kMost);
}

std::string faultText(const Fault& fault) {
  return std::string(fault.error ? "error: " : "warning: ") +
         (fault.where.empty() ? "" : fault.where + ": ") + fault.text;
}

}  // namespace pileus::nodes
