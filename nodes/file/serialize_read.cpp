// JSON to graph: reads what it can and reports everything that is wrong.
#include <algorithm>
#include <cmath>
#include <limits>

#include "nodes/file/serialize_json.h"
#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

class Reader {
 public:
  /// `prefix`: the path of the group that is read ("Group/"), "" for the whole.
  explicit Reader(std::vector<Fault>& faults, std::string prefix = {})
      : faults_(&faults), prefix_(std::move(prefix)) {}
  Graph read(const Json& json);

 private:
  void error(const std::string& where, std::string text) {
    faults_->push_back({true, prefix_ + where, std::move(text)});
  }
  /// An error about something that the graph has no place for.
  void lost(const std::string& where, std::string text) {
    faults_->push_back({true, prefix_ + where, std::move(text), true});
  }
  void warning(const std::string& where, std::string text) {
    faults_->push_back({false, prefix_ + where, std::move(text)});
  }
  void settings(const Json& json, Settings& out);
  std::optional<Node> node(const std::string& name, const Json& json);
  void params(const std::string& name, const Json& json, const NodeType* type, Node& out);
  void param(const std::string& where, const Json& json, const ParamSpec& spec, Node& out);
  std::optional<Animation> animation(const std::string& where, const Json& json, const ParamSpec& spec);
  void links(const Json& json, const std::string& list, bool muted, Graph& graph);
  void frames(const Json& json, Graph& graph);
  std::optional<Frame> frame(const std::string& where, const Json& json);
  bool text(const Json& json, const std::string& where, std::string& out);

  std::vector<Fault>* faults_;
  std::string prefix_;
};

std::string shortened(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > 80) {
    text.resize(80);
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80)) text.pop_back();
    text += "...";
  }
  return text;
}

bool isInt(const Json& json) {
  if (!json.is_number_integer()) return false;
  if (json.is_number_unsigned()) return json.get<std::uint64_t>() <= 2147483647u;
  const auto v = json.get<std::int64_t>();
  return v >= std::numeric_limits<int>::min() && v <= std::numeric_limits<int>::max();
}

/// ["smooth", [0, 0], [1, 1]]: a word and rows of as many numbers.
bool isPoints(const Json& json, std::size_t size) {
  if (!json.is_array() || json.size() < 2 || !json[0].is_string()) return false;
  return std::all_of(json.begin() + 1, json.end(), [size](const Json& row) {
    return row.is_array() && row.size() == size &&
           std::all_of(row.begin(), row.end(), [](const Json& v) { return v.is_number(); });
  });
}

std::optional<ParamValue> curve(const Json& json) {
  const auto shape = enumFromId<CurveShape>(json[0].get<std::string>());
  Curve result{{}, shape.value_or(CurveShape::Smooth)};
  for (std::size_t i = 1; i < json.size(); ++i)
    result.points.push_back({json[i][0].get<double>(), json[i][1].get<double>()});
  return shape ? std::optional<ParamValue>(result) : std::nullopt;
}

std::optional<ParamValue> ramp(const Json& json) {
  const auto shape = enumFromId<RampShape>(json[0].get<std::string>());
  Ramp result{{}, shape.value_or(RampShape::Linear)};
  for (std::size_t i = 1; i < json.size(); ++i) {
    const Json& s = json[i];
    const dvec3 color(s[1].get<double>(), s[2].get<double>(), s[3].get<double>());
    result.stops.push_back({s[0].get<double>(), color});
  }
  return shape ? std::optional<ParamValue>(result) : std::nullopt;
}

std::optional<ParamValue> constant(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (isInt(json)) return json.get<int>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  if (json.is_array() && json.size() == 3 && json[0].is_number() && json[1].is_number() &&
      json[2].is_number())
    return dvec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
  if (isPoints(json, 2)) return curve(json);
  if (isPoints(json, 4)) return ramp(json);
  return std::nullopt;
}

bool isPair(const Json& json) {
  return json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number();
}

bool Reader::text(const Json& json, const std::string& where, std::string& out) {
  if (!json.is_string()) return lost(where, shortened(json) + " is not a text"), false;
  out = json.get<std::string>();
  return true;
}

void Reader::settings(const Json& json, Settings& out) {
  if (!json.is_object()) return lost("settings", "is not an object");
  for (const auto& [key, value] : json.items()) {
    const std::string where = "settings." + key;
    const bool ints = isPair(value) && isInt(value[0]) && isInt(value[1]);
    if (key == "size") {
      const ivec2 size = ints ? ivec2(value[0].get<int>(), value[1].get<int>()) : ivec2(0);
      if (!ints)
        lost(where, shortened(value) + " is not two whole numbers");
      else if (size.x < 1 || size.y < 1 || size.x > kLargestSize || size.y > kLargestSize)
        lost(where, fmt::format("{}x{} is outside 1x1..{}x{}", size.x, size.y, kLargestSize, kLargestSize));
      else
        out.size = size;
    } else if (key == "frames") {
      if (!ints)
        lost(where, shortened(value) + " is not two whole numbers");
      else if (value[0].get<int>() > value[1].get<int>())
        lost(where, "the first frame comes after the last");
      else
        out.frames = {value[0].get<int>(), value[1].get<int>()};
    } else if (key == "fps") {
      if (!value.is_number() || !(value.get<double>() > 0) || value.get<double>() > 1000)
        lost(where, shortened(value) + " is not a number above 0 and up to 1000");
      else
        out.fps = value.get<double>();
    } else if (key == "ocio") {
      text(value, where, out.ocio);
    } else if (key == "workingSpace") {
      if (text(value, where, out.workingSpace) && out.workingSpace != "ACEScg")
        warning(where, "'" + out.workingSpace + "' is not supported: ACEScg is used");
    } else {
      out.unknown[key] = value.dump();
      warning(where, "unknown setting; kept as it is");
    }
  }
}

std::optional<Animation> Reader::animation(const std::string& where, const Json& json,
                                           const ParamSpec& spec) {
  if (constantOnly(spec.type)) return error(where, "takes no keys"), std::nullopt;
  if (json.size() != 1 || !json["keys"].is_array() || json["keys"].empty())
    return error(where, "an animation is {\"keys\": [[frame, value, \"smooth\"], ...]}"), std::nullopt;
  Animation result;
  for (const Json& key : json["keys"]) {
    const std::string number = fmt::format("key {}: ", result.keys.size() + 1);
    const bool shaped = key.is_array() && (key.size() == 2 || key.size() == 3) && key[0].is_number() &&
                        (key.size() == 2 || key[2].is_string());
    const auto value = shaped ? constant(key[1]) : std::nullopt;
    if (!value)
      return error(where, number + shortened(key) + " is not [frame, value, \"smooth\"]"), std::nullopt;
    const auto checked = checkedParam(spec, *value);
    if (!checked) return error(where, number + checked.error().message), std::nullopt;
    const std::string kind = key.size() == 3 ? key[2].get<std::string>() : "smooth";
    const auto interpolation = enumFromId<Interpolation>(kind);
    if (!interpolation)
      return error(where, number + "'" + kind + "' is not one of constant, linear, smooth"), std::nullopt;
    const double frame = key[0].get<double>();
    if (!result.keys.empty() && !(frame > result.keys.back().frame))
      return error(where, number + "frames must increase"), std::nullopt;
    result.keys.push_back({frame, *checked, *interpolation});
  }
  return result;
}

void Reader::param(const std::string& where, const Json& json, const ParamSpec& spec, Node& out) {
  const auto keep = [&] { out.unknown["params/" + spec.id] = json.dump(); };
  if (json.is_object() && json.contains("keys")) {
    if (auto keys = animation(where, json, spec))
      out.animated[spec.id] = std::move(*keys);
    else
      keep();
    return;
  }
  if (json.is_object() && json.size() == 1 && json.contains("expr") && json["expr"].is_string()) {
    keep();
    return warning(where, "expressions are not evaluated yet: kept, but the default is used");
  }
  const auto value = constant(json);
  const auto converted = value ? convertedParam(spec, *value) : Result<ParamValue>(Error{});
  if (!converted) {
    keep();
    return error(
        where, value ? converted.error().message : shortened(json) + " is not a value this parameter takes");
  }
  // Outside the range it stays as it is: the node fails with the same words until it is corrected.
  if (const auto checked = checkedParam(spec, *converted); !checked) error(where, checked.error().message);
  if (*converted != spec.fallback) out.params[spec.id] = *converted;
}

void Reader::params(const std::string& name, const Json& json, const NodeType* type, Node& out) {
  if (!json.is_object()) return lost(name + ".params", "is not an object");
  for (const auto& [id, value] : json.items()) {
    const ParamSpec* spec = type ? type->param(id) : nullptr;
    if (spec) {
      param(name + "." + id, value, *spec, out);
      continue;
    }
    out.unknown["params/" + id] = value.dump();
    if (type) warning(name + "." + id, fmt::format("{} has no such parameter; kept as it is", type->id));
  }
}

std::optional<Node> Reader::node(const std::string& name, const Json& json) {
  if (const auto valid = checkName(name); !valid)
    return lost("nodes." + name, valid.error().message), std::nullopt;
  if (!json.is_object()) return lost(name, "is not an object"), std::nullopt;
  if (!json.contains("type") || !json["type"].is_string())
    return lost(name + ".type", "is missing or not a text"), std::nullopt;
  Node result;
  result.type = json["type"].get<std::string>();
  const NodeType* type = findNodeType(result.type);
  if (!type) warning(name, fmt::format("unknown node type '{}'; kept as it is", result.type));
  for (const auto& [key, value] : json.items()) {
    const std::string where = name + "." + key;
    if (key == "type") continue;
    if (key == "at") {
      if (isPair(value))
        result.at = {value[0].get<double>(), value[1].get<double>()};
      else
        lost(where, shortened(value) + " is not two numbers");
    } else if (key == "params") {
      params(name, value, type, result);
    } else if (key == "graph" && result.type == "group" && value.is_object()) {
      result.group = std::make_shared<const Graph>(Reader(*faults_, prefix_ + name + "/").read(value));
    } else if (key == "bypass" || key == "disabled") {
      if (value.is_boolean())
        (key == "bypass" ? result.bypass : result.disabled) = value.get<bool>();
      else
        lost(where, shortened(value) + " is not true or false");
    } else if (key == "color") {
      text(value, where, result.color);
    } else if (key == "label") {
      text(value, where, result.label);
    } else if (key == "expose") {
      std::string id;
      if (!value.is_array())
        lost(where, "is not a list");
      else
        for (const Json& item : value)
          if (text(item, where, id)) result.expose.push_back(id);
    } else {
      result.unknown[key] = value.dump();
      if (key == "graph" && result.type == "group")
        error(where, "is not an object");
      else if (type)
        warning(where, "unknown member; kept as it is");
    }
  }
  if (result.type == "group" && !json.contains("graph")) error(name + ".graph", "is missing");
  return result;
}

std::optional<Link> parseLink(std::string_view text) {
  const auto arrow = text.find(" -> ");
  if (arrow == std::string_view::npos) return std::nullopt;
  const std::string_view from = text.substr(0, arrow), to = text.substr(arrow + 4);
  const auto fromDot = from.rfind('.'), toDot = to.rfind('.');
  if (fromDot == std::string_view::npos || toDot == std::string_view::npos) return std::nullopt;
  Link link{std::string(from.substr(0, fromDot)), std::string(from.substr(fromDot + 1)),
            std::string(to.substr(0, toDot)), std::string(to.substr(toDot + 1)), false};
  if (link.fromNode.empty() || link.fromSocket.empty() || link.toNode.empty() || link.toSocket.empty())
    return std::nullopt;
  return link;
}

void Reader::links(const Json& json, const std::string& list, bool muted, Graph& graph) {
  if (!json.is_array()) return lost(list, "is not a list");
  std::set<Link> seen;
  for (Link link : graph.links) seen.insert((link.muted = false, link));
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string where = fmt::format("{}[{}]", list, i);
    auto link = json[i].is_string() ? parseLink(json[i].get_ref<const std::string&>()) : std::nullopt;
    if (!link) {
      lost(where, shortened(json[i]) + " is not \"Node.output -> Node.input\"");
      continue;
    }
    bool missing = false;
    for (const std::string& name : {link->fromNode, link->toNode})
      if (!graph.nodes.contains(name)) {
        lost(where, shortened(json[i]) + ": there is no node '" + name + "'");
        missing = true;
      }
    if (missing) continue;
    if (!seen.insert(*link).second) {
      error(where, shortened(json[i]) + " is listed twice");
      continue;
    }
    link->muted = muted;
    // A link to a parameter makes it a socket.
    const Node& to = *findNode(graph, link->toNode);
    const NodeType* type = findNodeType(to.type);
    const ParamSpec* spec =
        type && type->inputIndex(link->toSocket) < 0 ? type->param(link->toSocket) : nullptr;
    if (spec && !isSocket(to, *spec)) expose(graph, link->toNode, link->toSocket);
    graph.links.push_back(std::move(*link));
  }
}

std::optional<Frame> Reader::frame(const std::string& where, const Json& json) {
  if (!json.is_object()) return error(where, shortened(json) + " is not an object"), std::nullopt;
  Frame result;
  bool good = true;
  for (const auto& [key, value] : json.items()) {
    const std::string member = where + "." + key;
    if (key == "title" || key == "color") {
      good = text(value, member, key == "title" ? result.title : result.color) && good;
    } else if (key == "at" || key == "size") {
      if (isPair(value))
        (key == "at" ? result.at : result.size) = {value[0].get<double>(), value[1].get<double>()};
      else
        error(member, shortened(value) + " is not two numbers"), good = false;
    } else {
      result.unknown[key] = value.dump();
      warning(member, "unknown member; kept as it is");
    }
  }
  if (good && (result.size.x < 0 || result.size.y < 0)) error(where + ".size", "is below zero"), good = false;
  return good ? std::optional(std::move(result)) : std::nullopt;
}

/// All of them, or the member is kept as it is.
void Reader::frames(const Json& json, Graph& graph) {
  std::vector<Frame> list;
  bool good = json.is_array() && !json.empty();
  if (!json.is_array()) error("frames", "is not a list");
  for (std::size_t i = 0; json.is_array() && i < json.size(); ++i) {
    auto read = frame(fmt::format("frames[{}]", i), json[i]);
    if (read)
      list.push_back(std::move(*read));
    else
      good = false;
  }
  if (good)
    graph.frames = std::move(list);
  else
    graph.unknown["frames"] = json.dump();
}

Graph Reader::read(const Json& json) {
  Graph graph;
  const bool whole = prefix_.empty();
  if (const auto it = json.find("settings"); whole && it != json.end()) settings(*it, graph.settings);
  if (const auto it = json.find("nodes"); it == json.end()) {
    warning("nodes", "is missing");
  } else if (!it->is_object()) {
    lost("nodes", "is not an object");
  } else {
    for (const auto& [name, value] : it->items())
      if (auto read = node(name, value))
        graph.nodes.emplace(name, std::make_shared<const Node>(std::move(*read)));
  }
  if (const auto it = json.find("links"); it != json.end()) links(*it, "links", false, graph);
  if (const auto it = json.find("muted"); it != json.end()) links(*it, "muted", true, graph);
  for (const auto& [key, value] : json.items()) {
    if (key == "nodes" || key == "links" || key == "muted") continue;
    if (whole && (key == "pileus" || key == "settings")) continue;
    if (key == "frames") {
      frames(value, graph);
      continue;
    }
    graph.unknown[key] = value.dump();
    if (key != "notes" && !(whole && (key == "preset" || key == "variations")))
      warning(key, "unknown member; kept as it is");
  }
  return graph;
}

}  // namespace

Graph graphFromJson(const Json& json, std::vector<Fault>& faults) { return Reader(faults).read(json); }

}  // namespace pileus::nodes
