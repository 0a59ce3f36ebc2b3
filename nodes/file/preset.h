#pragma once
// Presets of one's own: a graph file that says of itself what it is called. The member "preset" stands beside
// the nodes, so that a preset is opened, compared and migrated as any other graph. Pure.
#include <array>
#include <map>
#include <string>
#include <vector>

#include "nodes/file/serialize.h"
#include "renderer/base/enum_info.h"

namespace pileus::nodes {

/// What a preset is put to use as.
enum class PresetKind { Document, Nodes, Parameters };
constexpr auto enumInfo(PresetKind*) {
  return std::array{
      EnumItem<PresetKind>{PresetKind::Document, "document", "Scene", "Opens as an unnamed document."},
      EnumItem<PresetKind>{PresetKind::Nodes, "nodes", "Nodes", "Adds nodes with their links."},
      EnumItem<PresetKind>{PresetKind::Parameters, "parameters", "Parameters", "Sets a node's parameters."}};
}

struct Preset {
  PresetKind kind = PresetKind::Document;
  std::string name, about;                     ///< about: one sentence, or ""
  std::vector<std::string> tags;               ///< sorted, each once, lower case
  Graph graph;                                 ///< Nodes: without settings; Parameters: one node
  std::map<std::string, std::string> unknown;  ///< of the member "preset", JSON text
};

inline constexpr std::size_t kLongestPresetText = 400;  ///< bytes of a sentence
inline constexpr std::size_t kMostPresetTags = 16;

/// UTF-8 in one line, not empty, of at most 128 bytes; it may hold any other character, "/" too. Error
/// (Arguments).
Result<void> checkPresetName(std::string_view name);
/// One line of at most kLongestPresetText bytes, or "". Error (Arguments).
Result<void> checkPresetAbout(std::string_view about);
/// "Sunset, low sun,sunset" -> "low sun", "sunset": tags as they are kept.
std::vector<std::string> presetTags(std::string_view list);
std::string presetTagList(const std::vector<std::string>& tags);  ///< "low sun, sunset"

/// The nodes named and the links among them. `kind` is Nodes or Parameters (one node, without its place and
/// its colour). Error (Arguments): there is no such node.
Result<Preset> presetOf(const Graph& graph, const std::set<std::string>& names, PresetKind kind);

/// The text of its file; byte-identical after presetFromText().
std::string presetText(const Preset& preset);
struct LoadedPreset {
  Preset preset;
  std::vector<Fault> faults;  ///< of the graph, as of any file
};
/// Error (Input): no graph, or one that does not say what it is called.
Result<LoadedPreset> presetFromText(std::string_view text);

/// The node's parameters, their keys and what could not be read of them become those of the preset's node;
/// name, place, links and exposed sockets stay. A parameter the preset does not name goes back to its
/// default. Error (Arguments): a node of another type, or no such node.
Result<Graph> withPresetParameters(const Graph& graph, const std::string& node, const Preset& preset);

}  // namespace pileus::nodes
