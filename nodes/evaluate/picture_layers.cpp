#include "nodes/evaluate/picture_layers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

#include "nodes/declare/value.h"
#include "nodes/evaluate/evaluator.h"
#include "nodes/evaluate/flatten.h"
#include "nodes/graph/graph_groups.h"
#include "renderer/base/text.h"

namespace pileus::nodes {
namespace {

/// How many lights of the picture, one after the other, are of a node.
struct LightsOf {
  std::string node;
  std::size_t count = 0;
};
using Owners = std::vector<LightsOf>;

/// Follows lights upstream through shadows, dots and what is bypassed; nodes keep their order.
class Trace {
 public:
  Trace(const Evaluator& evaluator, const Graph& flat) : evaluator_(evaluator), flat_(flat) {}

  /// The lights that arrive at an input.
  std::optional<Owners> arriving(const std::string& node, const std::string& socket) {
    Owners all;
    for (const Link& link : flat_.links) {
      if (link.muted || link.toNode != node || link.toSocket != socket) continue;
      const auto some = leaving(link.fromNode, link.fromSocket);
      if (!some) return std::nullopt;
      all.insert(all.end(), some->begin(), some->end());
    }
    return all;
  }

 private:
  std::optional<Owners> leaving(const std::string& name, const std::string& socket) {
    constexpr int kDeepest = 1000;
    const Node* node = findNode(flat_, name);
    const NodeType* type = node ? findNodeType(node->type) : nullptr;
    if (!type || ++depth_ > kDeepest) return std::nullopt;
    std::string through;  // the input that its lights come in by
    for (const SocketSpec& input : type->inputs) {
      const bool linked = std::any_of(flat_.links.begin(), flat_.links.end(), [&](const Link& l) {
        return !l.muted && l.toNode == name && l.toSocket == input.id;
      });
      // A metric brings its lights with it, and goes before those that are linked beside it.
      if (linked && !node->bypass && input.type == SocketType::Metric) through = input.id;
      if (linked && through.empty() && (input.type == SocketType::Light || type->id == "dot"))
        through = input.id;
    }
    if (!through.empty()) return arriving(name, through);
    const SocketValue* value = evaluator_.output(name, socket);
    const auto* lights = value ? std::get_if<LightValue>(value) : nullptr;
    if (!lights) return std::nullopt;
    return Owners{{name, lights->items.size()}};
  }

  const Evaluator& evaluator_;
  const Graph& flat_;
  int depth_ = 0;
};

/// The node that made the picture, upstream of an output: through dots and outputs that pass it on.
std::string pictureNode(const Graph& flat, const std::string& output) {
  std::string at = output;
  for (std::size_t i = 0; i < flat.nodes.size(); ++i) {
    const Node* node = findNode(flat, at);
    const NodeType* type = node ? findNodeType(node->type) : nullptr;
    if (!type) return {};
    if (type->inputIndex("lights") >= 0) return at;
    const auto link = std::find_if(flat.links.begin(), flat.links.end(),
                                   [&](const Link& l) { return !l.muted && l.toNode == at; });
    if (link == flat.links.end()) return {};
    at = link->fromNode;
  }
  return {};
}

}  // namespace

std::string layerName(std::string_view node) {
  static constexpr std::array<std::string_view, 14> kTaken{
      "rgb",     "single", "multiple", "rgba", "alpha", "depth", "emission",
      "forward", "motion", "mask",     "all",  "none",  "other", "backward"};
  const std::string out = plainName(node, '_');
  if (out.empty()) return "light";
  if (std::isdigit(static_cast<unsigned char>(out[0]))) return "light_" + out;
  if (out.size() == 1 || std::find(kTaken.begin(), kTaken.end(), lowered(out)) != kTaken.end())
    return out + "_light";
  return out;
}

std::vector<std::string> lightNodes(const Evaluator& evaluator, const Graph& graph,
                                    const std::string& output) {
  const Graph flat = flatten(graph).graph;
  const std::string render = pictureNode(flat, output);
  if (render.empty()) return {};
  const auto owners = Trace(evaluator, flat).arriving(render, "lights");
  std::vector<std::string> all;
  if (owners)
    for (const LightsOf& owner : *owners) all.insert(all.end(), owner.count, owner.node);
  return all;
}

std::string lightGroup(const Graph& root, const std::string& path) {
  const Node* node = findNodeAt(root, path);
  if (!node) return path;
  const auto it = node->params.find("group");
  const auto* name = it == node->params.end() ? nullptr : std::get_if<std::string>(&it->second);
  return name && !name->empty() ? *name : path;
}

namespace {

/// Adds what a layer holds; alpha is that of the picture in all of them.
void addLayer(image::Layer& sum, const image::Layer& one) {
  for (std::size_t i = 0; i < sum.pixels.size(); ++i)
    if (sum.channels != 4 || i % 4 != 3) sum.pixels[i] += one.pixels[i];
}

/// Light layers by whose they are, in the order they come first in.
std::vector<image::Layer> layersByOwner(const image::Image& picture, const std::vector<std::string>& owners) {
  std::vector<image::Layer> named;
  std::vector<std::string> seen;
  const auto take = [&](const std::string& owner, const image::Layer& one) {
    const auto known = std::find(seen.begin(), seen.end(), owner);
    if (known != seen.end()) return addLayer(named[static_cast<std::size_t>(known - seen.begin())], one);
    seen.push_back(owner);
    named.push_back(one);
  };
  for (std::size_t i = 0; i < owners.size(); ++i) {
    take(owners[i], *picture.layer(fmt::format("light{}", i + 1)));
    if (const auto* seenOf = picture.layer(fmt::format("backdrop{}", i + 1))) take(owners[i], *seenOf);
  }
  std::set<std::string> used;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const std::string base = layerName(seen[i]);
    named[i].name = base;
    for (int n = 2; !used.insert(named[i].name).second; ++n) named[i].name = fmt::format("{}_{}", base, n);
  }
  return named;
}

}  // namespace

void nameLightLayers(image::Image& picture, const Evaluator& evaluator, const Graph& graph,
                     const std::string& output) {
  std::vector<std::string> owners = lightNodes(evaluator, graph, output);
  const auto isLight = [&](std::size_t i) { return picture.layer(fmt::format("light{}", i + 1)) != nullptr; };
  const std::size_t count = owners.size();
  if (count == 0 || !isLight(count - 1) || isLight(count)) return;
  if (wantedLayers(graph, output).backdrops)
    for (std::string& owner : owners) owner = lightGroup(graph, owner);
  std::vector<image::Layer> named = layersByOwner(picture, owners);
  std::vector<image::Layer> layers;
  for (image::Layer& layer : picture.layers) {
    const bool first = layer.name == "light1";
    bool light = false;
    for (std::size_t i = 1; i <= count && !light; ++i)
      light = layer.name == fmt::format("light{}", i) || layer.name == fmt::format("backdrop{}", i);
    if (!light) layers.push_back(std::move(layer));
    if (first) std::move(named.begin(), named.end(), std::back_inserter(layers));
  }
  picture.layers = std::move(layers);
}

view::ExtraLayers wantedLayers(const Graph& graph, const std::string& output) {
  const Node* node = findNode(graph, output);
  const NodeType* type = node ? findNodeType(node->type) : nullptr;
  if (!type || type->id != "output.exr") return {};
  const auto on = [&](const char* id) {
    const ParamSpec* spec = type->param(id);
    const ParamValue value = spec ? paramValue(*node, *spec) : ParamValue(false);
    return std::get_if<bool>(&value) && std::get<bool>(value);
  };
  const bool groups = on("light_groups");
  return {on("depth"), groups || on("lights"), on("orders"), groups};
}

}  // namespace pileus::nodes
