#include "nodes/file/variations.h"

#include <algorithm>
#include <cmath>

#include "nodes/file/serialize_json.h"

namespace pileus::nodes {
namespace {

constexpr char kMember[] = "variations";
constexpr std::string_view kParams = "params/";

/// Its type and its values.
Node stripped(const Node& node) {
  Node out;
  out.type = node.type;
  out.params = node.params;
  out.animated = node.animated;
  for (const auto& [key, text] : node.unknown)
    if (key.starts_with(kParams)) out.unknown.emplace(key, text);
  if (node.group) out.group = std::make_shared<const Graph>(valuesOf(*node.group));
  return out;
}

/// From a to b on a circle of 360 degrees, at most half of it.
double angleBetween(double a, double b, double t) {
  const double way = std::remainder(b - a, 360.0);
  return a + way * t;
}

/// A turn that may go on beyond a whole one.
bool turns(const ParamSpec& spec) { return spec.unit == "deg" && spec.hardMax - spec.hardMin > 360; }

ParamValue between(const ParamSpec& spec, const ParamValue& a, const ParamValue& b, double t) {
  if (a == b) return a;
  if (const auto* x = std::get_if<double>(&a); x && std::holds_alternative<double>(b)) {
    const double y = std::get<double>(b);
    return turns(spec) ? angleBetween(*x, y, t) : *x + (y - *x) * t;
  }
  if (const auto* x = std::get_if<dvec3>(&a); x && std::holds_alternative<dvec3>(b)) {
    const dvec3 y = std::get<dvec3>(b);
    dvec3 out = *x + (y - *x) * t;
    if (turns(spec))
      for (int i = 0; i < 3; ++i) out[i] = angleBetween((*x)[i], y[i], t);
    return out;
  }
  if (const auto* x = std::get_if<int>(&a);
      x && spec.type == ParamType::Int && std::holds_alternative<int>(b))
    return static_cast<int>(std::lround(*x + (double(std::get<int>(b)) - *x) * t));
  return t < 0.5 ? a : b;
}

Node between(const Node& a, const Node& b, double t) {
  Node out = t < 0.5 ? a : b;  // with what changes half way
  if (a.group && b.group) out.group = std::make_shared<const Graph>(blendedValues(*a.group, *b.group, t));
  const NodeType* type = findNodeType(a.type);
  if (!type) return out;
  for (const ParamSpec& spec : type->params) {
    const std::string unread = std::string(kParams) + spec.id;
    if (a.animated.contains(spec.id) || b.animated.contains(spec.id) || a.unknown.contains(unread) ||
        b.unknown.contains(unread))
      continue;
    const ParamValue value = between(spec, paramValue(a, spec), paramValue(b, spec), t);
    if (value == spec.fallback)
      out.params.erase(spec.id);
    else
      out.params[spec.id] = value;
  }
  return out;
}

}  // namespace

Result<std::vector<Variation>> variationsOf(const Graph& root) {
  std::vector<Variation> out;
  const auto it = root.unknown.find(kMember);
  if (it == root.unknown.end()) return out;
  const Json json = Json::parse(it->second, nullptr, false);
  if (!json.is_array()) return fail(Code::Input, "variations: is not a list");
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Json& entry = json[i];
    const auto wrong = [&](std::string_view what) {
      return fail(Code::Input, "variations[{}]: {}", i, what);
    };
    if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string() || entry.size() != 2 ||
        !entry.contains("graph"))
      return wrong("is not a name and a graph");
    const Result<Loaded> values = parseGraph(entry["graph"].dump());
    if (!values) return wrong(values.error().message);
    out.push_back({entry["name"].get<std::string>(), valuesOf(values->graph)});
  }
  return out;
}

Graph withVariations(const Graph& root, const std::vector<Variation>& variations) {
  Graph out = root;
  Json json = Json::array();
  for (const Variation& v : variations)
    json.push_back({{"name", v.name}, {"graph", graphJson(v.values, false)}});
  if (variations.empty())
    out.unknown.erase(kMember);
  else
    out.unknown[kMember] = json.dump();
  return out;
}

std::string freeVariationName(const std::vector<Variation>& all) {
  for (std::size_t i = all.size() + 1;; ++i) {
    std::string name = fmt::format("Variation {}", i);
    if (std::none_of(all.begin(), all.end(), [&](const Variation& v) { return v.name == name; })) return name;
  }
}

Graph valuesOf(const Graph& root) {
  Graph out;
  for (const auto& [name, node] : root.nodes)
    out.nodes.emplace(name, std::make_shared<const Node>(stripped(*node)));
  return out;
}

Graph withValues(const Graph& root, const Graph& values) {
  Graph out = root;
  for (auto& [name, node] : out.nodes) {
    const Node* from = findNode(values, name);
    if (!from || from->type != node->type) continue;
    Node changed = *node;
    changed.params = from->params;
    changed.animated = from->animated;
    std::erase_if(changed.unknown, [](const auto& u) { return u.first.starts_with(kParams); });
    changed.unknown.insert(from->unknown.begin(), from->unknown.end());
    if (node->group && from->group)
      changed.group = std::make_shared<const Graph>(withValues(*node->group, *from->group));
    if (!(changed == *node)) node = std::make_shared<const Node>(std::move(changed));
  }
  return out;
}

Graph blendedValues(const Graph& a, const Graph& b, double t) {
  if (t <= 0) return a;
  if (t >= 1) return b;
  Graph out;
  for (const auto& [name, node] : a.nodes) {
    const Node* other = findNode(b, name);
    if (!other || other->type != node->type) continue;
    out.nodes.emplace(name, *node == *other ? node : std::make_shared<const Node>(between(*node, *other, t)));
  }
  return out;
}

Graph blendedValues(const std::vector<Variation>& row, double at) {
  if (row.empty()) return {};
  const double last = static_cast<double>(row.size() - 1);
  const double place = std::clamp(at, 0.0, last),
               first = std::min(std::floor(place), std::max(last - 1, 0.0));
  const auto i = static_cast<std::size_t>(first);
  if (row.size() == 1) return row[0].values;
  return blendedValues(row[i].values, row[i + 1].values, place - first);
}

}  // namespace pileus::nodes
