#pragma once
// The graph: a plain value. Nodes are shared and immutable, so a copy is cheap and undo is a list of graphs.
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "nodes/declare/node_type.h"
#include "nodes/graph/animation.h"

namespace pileus::nodes {

struct Graph;

struct Node {
  std::string type;                           ///< id; may be unknown (kept, shown as a warning)
  dvec2 at{0};                                ///< canvas position
  std::map<std::string, ParamValue> params;   ///< only values that differ from the type's default
  std::map<std::string, Animation> animated;  ///< of these the key values count, not `params`
  bool bypass = false;                        ///< passes the first input of its first output's type
  bool disabled = false;                      ///< as if it were not there: links from it count as absent
  std::string color, label;                   ///< canvas only; "" = none
  std::vector<std::string> expose;            ///< parameters that are input sockets too
  std::shared_ptr<const Graph> group;         ///< of type "group": what it holds (graph_groups.h)
  /// What this version does not understand, as JSON text, so that it survives a round trip: other members
  /// under their name; under "params/NAME" unknown parameters, expressions and values of a wrong type (the
  /// last make the node fail until it is set again).
  std::map<std::string, std::string> unknown;
};
bool operator==(const Node& a, const Node& b);  ///< groups by content
using NodePtr = std::shared_ptr<const Node>;

struct Link {
  std::string fromNode, fromSocket, toNode, toSocket;
  bool muted = false;
  auto operator<=>(const Link&) const = default;
};

struct Settings {
  ivec2 size{1280, 720};
  ivec2 frames{1, 1};
  double fps = 24;
  std::string ocio;  ///< "" = $OCIO or the shipped config
  std::string workingSpace = "ACEScg";
  std::map<std::string, std::string> unknown;
  bool operator==(const Settings&) const = default;
};

/// Settings::ocio from where the document's files start: what image::ColorConfig::load() takes.
std::string colorConfigPath(const Settings& settings, const std::filesystem::path& folder);

/// A titled rectangle behind nodes; edits in graph_frames.h.
struct Frame {
  std::string title, color;  ///< color: "#rrggbb", "" = none
  dvec2 at{0}, size{0};      ///< upper left corner; canvas units
  std::map<std::string, std::string> unknown;
  bool operator==(const Frame&) const = default;
};

struct Graph {
  std::map<std::string, NodePtr> nodes;  ///< by unique name
  std::vector<Link> links;               ///< order = order within many-inputs
  std::vector<Frame> frames;             ///< back to front
  Settings settings;                     ///< of the whole document; those of a group's graph are never used
  std::map<std::string, std::string>
      unknown;  ///< top-level members not understood ("notes" included), JSON text
};
bool operator==(const Graph& a, const Graph& b);

const Node* findNode(const Graph& graph, std::string_view name);
/// The node's value (at `frame`, if it is animated), or the type's default. Always of the spec's own kind,
/// but perhaps outside its range (a faulty file).
ParamValue paramValue(const Node& node, const ParamSpec& spec, double frame = 1);

/// A node name may not be empty, begin or end with a space or hold . / = -> or control characters; it is
/// UTF-8 of at most 128 bytes. The error says what is wrong.
Result<void> checkName(std::string_view name);
/// `wanted`, or "wanted 2", "wanted 3" ... whatever is free (a number it already ends with is counted up).
std::string freeName(const Graph& graph, std::string_view wanted);

/// Why this link cannot be made, in words for the user (unknown socket, types differ - naming both and a node
/// that would help -, a cycle naming its path), or nothing. A single input that is taken is no reason:
/// connecting replaces its link. Nor is a parameter that is no socket yet: connecting exposes it. Muted links
/// count here: they may come back. For many links at once build one SocketTable (graph_sockets.h).
std::optional<std::string> linkRefusal(const Graph& graph, const Link& link);

// Edits: each returns a new graph. Impossible ones return an Error (Arguments). More of them: graph_edits.h,
// graph_groups.h, graph_frames.h, graph_animation.h.
Result<Graph> addNode(const Graph& graph, std::string_view type, dvec2 at,
                      std::string_view name = {});  ///< name: label of the type by default, made free
/// reconnect: what fed a node's first input of an output's type feeds what that output fed, in its place
/// within many-inputs.
Graph removeNodes(const Graph& graph, const std::set<std::string>& names, bool reconnect = false);
Result<Graph> connect(const Graph& graph, const Link& link);
Graph disconnect(const Graph& graph, const Link& link);  ///< muted or not
Graph setMuted(const Graph& graph, const Link& link, bool muted);
Result<Graph> setParam(const Graph& graph, const std::string& node, const std::string& param,
                       const ParamValue& value);  ///< checked; a default is erased, an animation replaced
Result<Graph> renameNode(const Graph& graph, const std::string& from, const std::string& to);
Graph moveNodes(const Graph& graph, const std::set<std::string>& names, dvec2 by);
Graph setBypass(const Graph& graph, const std::set<std::string>& names, bool bypass);

/// Names in an order where each node follows its inputs (muted links left out); the nodes of a cycle are
/// named in the Error (Input).
Result<std::vector<std::string>> evaluationOrder(const Graph& graph);
/// The nodes that `targets` need, each after its inputs (muted links left out), and for nodes on a cycle its
/// path. Unknown targets are left out.
struct UpstreamOrder {
  std::vector<std::string> order;
  std::map<std::string, std::string> cyclic;
};
UpstreamOrder upstreamOrder(const Graph& graph, const std::vector<std::string>& targets);
/// Output nodes (isOutput) that are not disabled by name, EXR outputs before views.
std::vector<std::string> outputNodes(const Graph& graph);

}  // namespace pileus::nodes
