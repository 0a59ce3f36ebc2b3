// Graph to JSON text.
#include <cmath>

#include "nodes/file/serialize_json.h"

namespace pileus::nodes {
namespace {

Json numberJson(double value) {
  // Whole numbers are written as 25, and 25 reads back as an integer: the same text either way.
  return std::isfinite(value) ? Json(value) : Json(0);
}

}  // namespace

Json paramJson(const ParamValue& value) {
  if (const auto* v = std::get_if<bool>(&value)) return *v;
  if (const auto* v = std::get_if<int>(&value)) return *v;
  if (const auto* v = std::get_if<double>(&value)) return numberJson(*v);
  if (const auto* v = std::get_if<dvec3>(&value))
    return Json::array({numberJson(v->x), numberJson(v->y), numberJson(v->z)});
  if (const auto* v = std::get_if<Curve>(&value)) {
    Json list = Json::array({std::string(enumId(v->shape))});
    for (const dvec2& p : v->points) list.push_back(Json::array({numberJson(p.x), numberJson(p.y)}));
    return list;
  }
  if (const auto* v = std::get_if<Ramp>(&value)) {
    Json list = Json::array({std::string(enumId(v->shape))});
    for (const RampStop& s : v->stops)
      list.push_back(Json::array(
          {numberJson(s.at), numberJson(s.color.x), numberJson(s.color.y), numberJson(s.color.z)}));
    return list;
  }
  return std::get<std::string>(value);
}

namespace {

Json animationJson(const Animation& animation) {
  Json keys = Json::array();
  for (const AnimationKey& key : animation.keys)
    keys.push_back(
        Json::array({numberJson(key.frame), paramJson(key.value), std::string(enumId(key.interpolation))}));
  return {{"keys", std::move(keys)}};
}

/// Members kept as text go back where they came from, unless something known took their place.
void restoreUnknown(Json& object, const std::string& name, const std::string& text) {
  if (object.contains(name)) return;
  Json value = Json::parse(text, nullptr, false);
  if (!value.is_discarded()) object[name] = std::move(value);
}

Json contentJson(const Graph& graph);

Json nodeJson(const Node& node) {
  Json json = {{"type", node.type}, {"at", Json::array({numberJson(node.at.x), numberJson(node.at.y)})}};
  Json params = Json::object();
  for (const auto& [id, animation] : node.animated) params[id] = animationJson(animation);
  for (const auto& [id, value] : node.params)
    if (!params.contains(id)) params[id] = paramJson(value);
  if (node.group) json["graph"] = contentJson(*node.group);
  if (node.bypass) json["bypass"] = true;
  if (node.disabled) json["disabled"] = true;
  if (!node.color.empty()) json["color"] = node.color;
  if (!node.label.empty()) json["label"] = node.label;
  if (!node.expose.empty()) json["expose"] = node.expose;
  constexpr std::string_view kParams = "params/";
  for (const auto& [name, text] : node.unknown) {
    if (name.starts_with(kParams))
      restoreUnknown(params, name.substr(kParams.size()), text);
    else
      restoreUnknown(json, name, text);
  }
  json["params"] = std::move(params);
  return json;
}

Json settingsJson(const Settings& settings) {
  Json json = {{"size", {settings.size.x, settings.size.y}},
               {"frames", {settings.frames.x, settings.frames.y}},
               {"fps", numberJson(settings.fps)},
               {"ocio", settings.ocio},
               {"workingSpace", settings.workingSpace}};
  for (const auto& [name, text] : settings.unknown) restoreUnknown(json, name, text);
  return json;
}

Json frameJson(const Frame& frame) {
  Json json = {{"at", Json::array({numberJson(frame.at.x), numberJson(frame.at.y)})},
               {"size", Json::array({numberJson(frame.size.x), numberJson(frame.size.y)})}};
  if (!frame.title.empty()) json["title"] = frame.title;
  if (!frame.color.empty()) json["color"] = frame.color;
  for (const auto& [name, text] : frame.unknown) restoreUnknown(json, name, text);
  return json;
}

/// What the whole graph and that of a group have in common.
Json contentJson(const Graph& graph) {
  Json json = {{"nodes", Json::object()}, {"links", Json::array()}};
  for (const auto& [name, node] : graph.nodes) json["nodes"][name] = nodeJson(*node);
  Json muted = Json::array();
  for (const Link& link : graph.links)
    (link.muted ? muted : json["links"])
        .push_back(link.fromNode + "." + link.fromSocket + " -> " + link.toNode + "." + link.toSocket);
  if (!muted.empty()) json["muted"] = std::move(muted);
  for (const Frame& frame : graph.frames) json["frames"].push_back(frameJson(frame));
  for (const auto& [name, text] : graph.unknown) restoreUnknown(json, name, text);
  return json;
}

}  // namespace

Json graphJson(const Graph& graph, bool withSettings) {
  Json json = contentJson(graph);
  json["pileus"] = kFormatVersion;
  if (withSettings) json["settings"] = settingsJson(graph.settings);
  return json;
}

std::string graphText(const Graph& graph) { return writeJson(graphJson(graph, true)); }

}  // namespace pileus::nodes
