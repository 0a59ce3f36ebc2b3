#include "nodes/graph/graph.h"

#include <algorithm>
#include <tuple>

namespace pileus::nodes {
namespace {

/// Bytes of a valid UTF-8 sequence at the start of `text`, 0 if it is none.
std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : (lead & 0xF0) == 0xE0       ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if (lead == 0xE0 && byte(1) < 0xA0) return 0;
  if (lead == 0xED && byte(1) > 0x9F) return 0;
  if (lead == 0xF0 && byte(1) < 0x90) return 0;
  if (lead == 0xF4 && byte(1) > 0x8F) return 0;
  return length;
}

}  // namespace

std::string colorConfigPath(const Settings& settings, const std::filesystem::path& folder) {
  const std::string& ocio = settings.ocio;
  const bool builtIn = ocio.find("://") != ocio.npos;
  if (ocio.empty() || builtIn || folder.empty() || !std::filesystem::path(ocio).is_relative()) return ocio;
  return (folder / ocio).string();
}

bool operator==(const Node& a, const Node& b) {
  const auto all = [](const Node& n) {
    return std::tie(n.type, n.at, n.params, n.animated, n.bypass, n.disabled, n.color, n.label, n.expose,
                    n.unknown);
  };
  if (all(a) != all(b)) return false;
  return a.group == b.group || (a.group && b.group && *a.group == *b.group);
}

bool operator==(const Graph& a, const Graph& b) {
  if (a.links != b.links || a.frames != b.frames || a.settings != b.settings || a.unknown != b.unknown ||
      a.nodes.size() != b.nodes.size())
    return false;
  return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), [](const auto& x, const auto& y) {
    return x.first == y.first && (x.second == y.second || *x.second == *y.second);
  });
}

const Node* findNode(const Graph& graph, std::string_view name) {
  const auto it = graph.nodes.find(std::string(name));
  return it == graph.nodes.end() ? nullptr : it->second.get();
}

ParamValue paramValue(const Node& node, const ParamSpec& spec, double frame) {
  ParamValue value = spec.fallback;
  if (const auto keys = node.animated.find(spec.id); keys != node.animated.end())
    value = valueAt(keys->second, frame);
  else if (const auto it = node.params.find(spec.id); it != node.params.end())
    value = it->second;
  else
    return value;
  const auto converted = convertedParam(spec, value);
  return converted ? *converted : spec.fallback;
}

Result<void> checkName(std::string_view name) {
  if (name.empty()) return fail(Code::Arguments, "a node name may not be empty");
  if (name.size() > 128) return fail(Code::Arguments, "a node name may have at most 128 bytes");
  if (name.front() == ' ' || name.back() == ' ')
    return fail(Code::Arguments, "'{}': a node name may not begin or end with a space", name);
  for (std::string_view rest = name; !rest.empty();) {
    const std::size_t length = utf8Length(rest);
    if (length == 0) return fail(Code::Arguments, "the node name is not valid UTF-8");
    if (static_cast<unsigned char>(rest[0]) < 0x20 || rest[0] == 0x7F)
      return fail(Code::Arguments, "a node name may not hold control characters");
    rest.remove_prefix(length);
  }
  for (const auto part : {".", "/", "=", "->"})
    if (name.find(part) != std::string_view::npos)
      return fail(Code::Arguments, "'{}': a node name may not hold '{}'", name, part);
  return {};
}

std::string freeName(const Graph& graph, std::string_view wanted) {
  std::string name(wanted);
  if (!graph.nodes.contains(name)) return name;
  std::size_t end = name.size();
  while (end > 0 && name[end - 1] >= '0' && name[end - 1] <= '9') --end;
  if (end > 1 && end < name.size() && name[end - 1] == ' ') name.resize(end - 1);
  while (name.size() > 116) {  // room for the number; whole characters only
    name.pop_back();
    while (!name.empty() && (static_cast<unsigned char>(name.back()) & 0xC0) == 0x80) name.pop_back();
    if (!name.empty() && static_cast<unsigned char>(name.back()) >= 0xC0) name.pop_back();
  }
  for (int i = 2;; ++i) {
    std::string candidate = name + " " + std::to_string(i);
    if (!graph.nodes.contains(candidate)) return candidate;
  }
}

UpstreamOrder upstreamOrder(const Graph& graph, const std::vector<std::string>& targets) {
  std::map<std::string_view, std::vector<std::string_view>> inputs;
  for (const Link& link : graph.links)
    if (!link.muted && graph.nodes.contains(link.fromNode)) inputs[link.toNode].push_back(link.fromNode);
  enum Mark { New, Open, Done };
  std::map<std::string_view, Mark> marks;
  struct Visit {
    std::string_view name;
    std::size_t next = 0;
  };
  UpstreamOrder result;
  for (const std::string& target : targets) {
    if (!graph.nodes.contains(target) || marks[target] != New) continue;
    std::vector<Visit> stack{{target}};
    marks[target] = Open;
    while (!stack.empty()) {
      Visit& top = stack.back();
      const auto& from = inputs[top.name];
      if (top.next == from.size()) {
        marks[top.name] = Done;
        result.order.emplace_back(top.name);
        stack.pop_back();
        continue;
      }
      const std::string_view source = from[top.next++];
      if (marks[source] == New) {
        marks[source] = Open;
        stack.push_back({source});
      } else if (marks[source] == Open) {
        // The stack from `source` up is the cycle, against the links' direction.
        std::size_t first = stack.size() - 1;
        while (stack[first].name != source) --first;
        std::string path(source);
        for (std::size_t i = stack.size(); i-- > first;) path += " -> " + std::string(stack[i].name);
        for (std::size_t i = first; i < stack.size(); ++i) result.cyclic.emplace(stack[i].name, path);
      }
    }
  }
  return result;
}

Result<std::vector<std::string>> evaluationOrder(const Graph& graph) {
  std::vector<std::string> all;
  for (const auto& [name, node] : graph.nodes) all.push_back(name);
  UpstreamOrder result = upstreamOrder(graph, all);
  if (!result.cyclic.empty()) return fail(Code::Input, "cycle: {}", result.cyclic.begin()->second);
  return std::move(result.order);
}

std::vector<std::string> outputNodes(const Graph& graph) {
  std::vector<std::string> files, views;
  for (const auto& [name, node] : graph.nodes)
    if (const NodeType* type = findNodeType(node->type); type && type->isOutput && !node->disabled)
      (type->id == "output.view" ? views : files).push_back(name);
  files.insert(files.end(), views.begin(), views.end());
  return files;
}

}  // namespace pileus::nodes
