#pragma once
// The light mixer: groups of lights as layers of the picture, added up anew by exposure and colour without
// rendering, and written into the lights. What is listened to is never part of the document. GL thread, but
// for the functions of graphs.
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/picture/light_switches.h"
#include "nodes/graph/graph.h"
#include "renderer/view/picture.h"

namespace pileus::editor {

class Messages;
struct Session;
struct Shown;
struct PreviewRequest;

/// A light node of a document.
struct LightAt {
  std::string path;     ///< "Group/Sun"
  std::string channel;  ///< the name of its group, or its own path
  nodes::NodePtr node;
};
/// All of them, those in groups too, by their paths.
std::vector<LightAt> lightsOf(const nodes::Graph& root);

/// How a group of lights is heard.
struct ChannelMix {
  double exposure = 0;  ///< stops
  dvec3 color{1};       ///< multiplies, in the working space
  bool muted = false, solo = false;
  bool writes() const { return exposure != 0 || color != dvec3(1); }
  bool operator==(const ChannelMix&) const = default;
};

struct LightMixer {
  bool on = false;
  std::map<std::string, ChannelMix> channels;  ///< those that are not here are as they were rendered
  bool silent(const std::string& channel) const;
  vec3 gain(const std::string& channel) const;
  bool neutral() const;  ///< the picture is as it was rendered
  bool writes() const;   ///< there is something to apply

  /// The picture last shown taken apart. Layers of a channel are one picture.
  struct Layer {
    std::string channel;
    std::shared_ptr<const view::Picture> picture;
  };
  std::vector<Layer> layers;
  std::shared_ptr<const view::Picture> rest;            ///< what no light decides: emission; null = nothing
  std::weak_ptr<const view::Picture> of;                ///< the picture
  std::array<std::shared_ptr<view::Picture>, 2> mixed;  ///< taken in turns: each change is another picture
  std::size_t turn = 0;
  std::map<std::string, ChannelMix> mixedWith;
  std::string error;  ///< why there is no mix; "" = none
  double ms = 0;      ///< of the last mix, CPU time until it was given to the driver
};

/// The request asks for layers while the mixer is on, and for no light that is switched off.
void applyLights(const Shown& shown, PreviewRequest& request);
/// Once a frame, after the preview: what the viewport shows is the mix, where there are layers.
void stepMixer(const Session& session, Shown& shown);

/// Exposure and colour of each channel, written into its lights; keys as well. `left`: parameters that could
/// not be written, because something is linked to them or the light has no colour. Errors: Arguments where a
/// value would be out of its range.
Result<nodes::Graph> withMix(const nodes::Graph& root, const std::map<std::string, ChannelMix>& channels,
                             std::vector<std::string>& left);
/// Writes the mix as one undo step; the mixer is neutral then.
void applyMix(Session& session, Shown& shown, Messages& messages);

/// What a light's strength and colour are called; color: "" = it has none.
struct LightParams {
  std::string strength, color;
  bool stops = false;  ///< the strength is an exposure
};
LightParams lightParams(const std::string& type);

}  // namespace pileus::editor
