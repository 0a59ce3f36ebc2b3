#include "editor/picture/light_mixer.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/picture/preview.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "nodes/evaluate/picture_layers.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_groups.h"
#include "renderer/view/light_mix.h"

namespace pileus::editor {
namespace {

void collect(const nodes::Graph& graph, const std::string& prefix, std::vector<LightAt>& out) {
  for (const auto& [name, node] : graph.nodes) {
    if (node->group)
      collect(*node->group, prefix + name + "/", out);
    else if (node->type.starts_with("light."))
      out.push_back({prefix + name, {}, node});
  }
}

const std::shared_ptr<const view::Picture>* layerOf(const view::Picture& picture, const std::string& name) {
  for (const view::Picture::Named& layer : picture.layers)
    if (layer.name == name) return &layer.picture;
  return nullptr;
}

/// Takes the picture apart: the layers of a channel become one.
Result<void> takeApart(const Session& session, Shown& shown,
                       const std::shared_ptr<const view::Picture>& picture) {
  LightMixer& mixer = shown.mixer;
  mixer.of = picture;
  mixer.layers.clear();
  mixer.rest.reset();
  const std::vector<std::string> nodes =
      nodes::lightNodes(shown.preview.evaluator(), session.document.root(), shownView(session, shown));
  if (nodes.empty() || !layerOf(*picture, fmt::format("light{}", nodes.size())))
    return fail(Code::Input, "this picture has no layer for each light: only Volume Render makes them");
  std::map<std::string, std::vector<view::MixPart>> parts;
  std::vector<std::string> order;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::string channel = nodes::lightGroup(session.document.root(), nodes[i]);
    if (!parts.contains(channel)) order.push_back(channel);
    for (const char* kind : {"light", "backdrop"})
      if (const auto* layer = layerOf(*picture, fmt::format("{}{}", kind, i + 1)))
        parts[channel].push_back({*layer, vec3(1.0f)});
  }
  for (const std::string& channel : order) {
    std::shared_ptr<const view::Picture> one = parts[channel].front().picture;
    if (parts[channel].size() > 1) {
      PILEUS_TRY(one, view::mixLights(shown.renderer.shaders(), *picture, parts[channel]));
    }
    mixer.layers.push_back({channel, std::move(one)});
  }
  if (const auto* rest = layerOf(*picture, "emission")) mixer.rest = *rest;
  return {};
}

Result<void> mix(Shown& shown, const view::Picture& picture) {
  LightMixer& mixer = shown.mixer;
  std::vector<view::MixPart> parts;
  for (const LightMixer::Layer& layer : mixer.layers)
    if (const vec3 gain = mixer.gain(layer.channel); gain != vec3(0.0f))
      parts.push_back({layer.picture, gain});
  if (mixer.rest) parts.push_back({mixer.rest, vec3(1.0f)});
  std::shared_ptr<view::Picture>& into = mixer.mixed[mixer.turn ^= 1];
  const Stopwatch clock;
  PILEUS_TRY(into, view::mixLights(shown.renderer.shaders(), picture, parts, std::move(into)));
  mixer.ms = clock.ms();
  mixer.mixedWith = mixer.channels;
  return {};
}

/// The parameter as it would be, keys too. False: something is linked to it.
Result<bool> change(nodes::Graph& root, const std::string& path, const std::string& id,
                    const std::function<nodes::ParamValue(const nodes::ParamValue&)>& how) {
  const nodes::NodeAt at = nodes::nodeAt(path);
  const nodes::Graph* graph = nodes::graphAt(root, at.scope);
  const nodes::Node* node = nodes::findNodeAt(root, path);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const nodes::ParamSpec* spec = type ? type->param(id) : nullptr;
  if (!graph || !spec) return false;
  for (const nodes::Link& link : graph->links)
    if (!link.muted && link.toNode == at.name && link.toSocket == id) return false;
  if (const auto keyed = node->animated.find(id); keyed != node->animated.end()) {
    const std::vector<nodes::AnimationKey> keys = keyed->second.keys;
    for (const nodes::AnimationKey& key : keys) {
      PILEUS_TRY(root, nodes::setKey(root, path, id, key.frame, how(key.value), key.interpolation));
    }
    return true;
  }
  PILEUS_TRY(root, nodes::setParamAt(root, path, id, how(nodes::paramValue(*node, *spec)), 1));
  return true;
}

}  // namespace

std::vector<LightAt> lightsOf(const nodes::Graph& root) {
  std::vector<LightAt> out;
  collect(root, "", out);
  for (LightAt& light : out) light.channel = nodes::lightGroup(root, light.path);
  return out;
}

bool LightMixer::silent(const std::string& channel) const {
  const bool alone =
      std::any_of(channels.begin(), channels.end(), [](const auto& c) { return c.second.solo; });
  const auto it = channels.find(channel);
  return it == channels.end() ? alone : it->second.muted || (alone && !it->second.solo);
}

vec3 LightMixer::gain(const std::string& channel) const {
  if (silent(channel)) return vec3(0.0f);
  const auto it = channels.find(channel);
  return it == channels.end() ? vec3(1.0f) : vec3(it->second.color * std::exp2(it->second.exposure));
}

bool LightMixer::neutral() const {
  return std::all_of(channels.begin(), channels.end(),
                     [](const auto& c) { return c.second == ChannelMix{}; });
}

bool LightMixer::writes() const {
  return std::any_of(channels.begin(), channels.end(), [](const auto& c) { return c.second.writes(); });
}

LightParams lightParams(const std::string& type) {
  if (type == "light.sun") return {"irradiance", "color"};
  if (type == "light.point" || type == "light.spot") return {"intensity", "color"};
  if (type == "light.environment") return {"exposure", "tint", true};
  return {"exposure", "", true};
}

void applyLights(const Shown& shown, PreviewRequest& request) {
  request.lights = shown.mixer.on;
  if (!shown.lights.any()) return;
  request.switches = shown.lights;
  for (const LightAt& light : lightsOf(request.graph)) {
    if (!shown.lights.off(light.path)) continue;
    const LightParams params = lightParams(light.node->type);
    const nodes::NodeAt at = nodes::nodeAt(light.path);
    if (Result<nodes::Graph> free = nodes::unlinked(request.graph, light.path, params.strength))
      request.graph = std::move(*free);
    request.graph = nodes::clearAnimation(request.graph, light.path, params.strength, 1);
    // As good as nothing where the strength is an exposure.
    if (Result<nodes::Graph> dark =
            nodes::setParamAt(request.graph, light.path, params.strength, params.stops ? -40.0 : 0.0, 1))
      request.graph = std::move(*dark);
  }
}

void stepMixer(const Session& session, Shown& shown) {
  LightMixer& mixer = shown.mixer;
  const std::shared_ptr<const view::Picture> picture = shown.preview.rendered();
  if (!mixer.on || !picture || picture->layers.empty()) {
    shown.preview.showMix(nullptr);
    if (!mixer.on && !mixer.layers.empty()) {
      std::map<std::string, ChannelMix> channels = std::move(mixer.channels);
      mixer = {};
      mixer.channels = std::move(channels);
    }
    return;
  }
  if (mixer.of.lock() != picture) {
    const Result<void> taken = takeApart(session, shown, picture);
    mixer.error = taken ? "" : taken.error().message;
    mixer.mixedWith.clear();
  }
  if (!mixer.error.empty() || mixer.neutral()) {
    mixer.mixedWith.clear();
    return shown.preview.showMix(nullptr);
  }
  if (mixer.mixedWith == mixer.channels && shown.preview.mix()) return;
  if (const Result<void> mixed = mix(shown, *picture); !mixed) {
    mixer.error = mixed.error().message;
    return shown.preview.showMix(nullptr);
  }
  shown.preview.showMix(mixer.mixed[mixer.turn]);
}

Result<nodes::Graph> withMix(const nodes::Graph& root, const std::map<std::string, ChannelMix>& channels,
                             std::vector<std::string>& left) {
  nodes::Graph out = root;
  for (const LightAt& light : lightsOf(root)) {
    const auto it = channels.find(light.channel);
    if (it == channels.end() || !it->second.writes()) continue;
    const ChannelMix& mix = it->second;
    const LightParams params = lightParams(light.node->type);
    if (mix.exposure != 0) {
      PILEUS_TRY(
          const bool done, change(out, light.path, params.strength, [&](const nodes::ParamValue& v) {
            const double before = std::get<double>(v);
            return nodes::ParamValue(params.stops ? before + mix.exposure : before * std::exp2(mix.exposure));
          }));
      if (!done) left.push_back(light.path + "." + params.strength);
    }
    if (mix.color == dvec3(1)) continue;
    bool done = false;
    if (!params.color.empty()) {
      PILEUS_TRY(done, change(out, light.path, params.color, [&](const nodes::ParamValue& v) {
                   return nodes::ParamValue(std::get<dvec3>(v) * mix.color);
                 }));
    }
    if (!done) left.push_back(light.path + (params.color.empty() ? " (no colour)" : "." + params.color));
  }
  return out;
}

void applyMix(Session& session, Shown& shown, Messages& messages) {
  LightMixer& mixer = shown.mixer;
  if (!mixer.writes()) return messages.hint("The mix changes no light.");
  std::vector<std::string> left;
  if (!tryEditRoot(session, messages, withMix(session.document.root(), mixer.channels, left),
                   "Apply light mix"))
    return;
  session.document.endMerge();
  for (auto& [channel, mix] : mixer.channels) mix.exposure = 0, mix.color = dvec3(1);
  std::string names;
  for (const std::string& name : left) names += (names.empty() ? "" : ", ") + name;
  if (left.empty())
    messages.note("The mix is in the lights. One undo takes it back.");
  else
    messages.warn("Not all of the mix could be written, because something is linked or there is no colour: " +
                  names);
}

}  // namespace pileus::editor
