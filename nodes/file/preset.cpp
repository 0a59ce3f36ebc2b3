#include "nodes/file/preset.h"

#include <algorithm>

#include "nodes/file/serialize_json.h"

namespace pileus::nodes {
namespace {

constexpr char kMember[] = "preset";
constexpr std::size_t kLongestName = 128, kLongestTag = 40;

/// Text in one line that a file can hold.
bool isLine(std::string_view text) {
  const bool control = std::any_of(text.begin(), text.end(),
                                   [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (control) return false;
  try {
    (void)Json(text).dump();
  } catch (const Json::exception&) {
    return false;  // not UTF-8
  }
  return true;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

Json memberJson(const Preset& preset) {
  Json json = {{"kind", enumId(preset.kind)}, {"name", preset.name}};
  if (!preset.about.empty()) json["about"] = preset.about;
  if (!preset.tags.empty()) json["tags"] = preset.tags;
  for (const auto& [name, text] : preset.unknown)
    if (!json.contains(name)) json[name] = Json::parse(text, nullptr, false);
  return json;
}

Error wrong(std::string_view key, std::string_view text) {
  return fail(Code::Input, "not a preset: preset.{} {}", key, text);
}

/// What the member says; everything but a broken kind or name is forgiven.
Result<Preset> readMember(const Json& json) {
  if (!json.is_object()) return fail(Code::Input, "not a preset: \"preset\" is not an object");
  Preset out;
  const auto kind = json.find("kind"), name = json.find("name");
  if (kind == json.end() || !kind->is_string()) return wrong("kind", "is missing");
  const auto known = enumFromId<PresetKind>(kind->get<std::string>());
  if (!known) return wrong("kind", "is not document, nodes or parameters");
  if (name == json.end() || !name->is_string()) return wrong("name", "is missing");
  out.kind = *known;
  out.name = name->get<std::string>();
  if (const auto good = checkPresetName(out.name); !good) return wrong("name", good.error().message);
  for (const auto& [key, value] : json.items()) {
    if (key == "kind" || key == "name") continue;
    const bool texts = value.is_array() &&
                       std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_string(); });
    if (key == "about" && value.is_string())
      out.about = value.get<std::string>();
    else if (key == "tags" && texts)
      out.tags = value.get<std::vector<std::string>>();
    else
      out.unknown[key] = value.dump();
  }
  return out;
}

}  // namespace

Result<void> checkPresetName(std::string_view name) {
  if (trimmed(name).empty()) return fail(Code::Arguments, "a preset needs a name");
  if (trimmed(name).size() != name.size())
    return fail(Code::Arguments, "a preset's name may not begin or end with a space");
  if (name.size() > kLongestName)
    return fail(Code::Arguments, "a preset's name may have at most {} bytes", kLongestName);
  if (!isLine(name))
    return fail(Code::Arguments, "a preset's name is one line of UTF-8, without control characters");
  return {};
}

Result<void> checkPresetAbout(std::string_view about) {
  if (about.size() <= kLongestPresetText && isLine(about)) return {};
  return fail(Code::Arguments,
              "a preset's sentence is one line of at most {} bytes of UTF-8, without control characters",
              kLongestPresetText);
}

std::vector<std::string> presetTags(std::string_view list) {
  std::vector<std::string> out;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    std::string tag(trimmed(list.substr(0, end)));
    list.remove_prefix(std::min(end + 1, list.size()));
    for (char& c : tag)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (!tag.empty() && tag.size() <= kLongestTag && isLine(tag)) out.push_back(std::move(tag));
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  if (out.size() > kMostPresetTags) out.resize(kMostPresetTags);
  return out;
}

std::string presetTagList(const std::vector<std::string>& tags) {
  std::string out;
  for (const std::string& tag : tags) out += (out.empty() ? "" : ", ") + tag;
  return out;
}

Result<Preset> presetOf(const Graph& graph, const std::set<std::string>& names, PresetKind kind) {
  Preset out;
  out.kind = kind;
  for (const std::string& name : names) {
    const auto it = graph.nodes.find(name);
    if (it == graph.nodes.end()) return fail(Code::Arguments, "there is no node named '{}'", name);
    if (kind == PresetKind::Nodes) {
      out.graph.nodes.insert(*it);
      continue;
    }
    Node node = *it->second;  // its values alone
    node.at = dvec2(0);
    node.bypass = node.disabled = false;
    node.color.clear();
    node.label.clear();
    node.expose.clear();
    std::erase_if(node.unknown, [](const auto& u) { return !u.first.starts_with("params/"); });
    out.graph.nodes.emplace(name, std::make_shared<const Node>(std::move(node)));
  }
  if (out.graph.nodes.empty()) return fail(Code::Arguments, "there are no nodes to keep");
  if (kind == PresetKind::Parameters && out.graph.nodes.size() != 1)
    return fail(Code::Arguments, "the parameters of one node are kept at a time");
  for (const Link& link : graph.links)
    if (out.graph.nodes.contains(link.fromNode) && out.graph.nodes.contains(link.toNode))
      out.graph.links.push_back(link);
  return out;
}

std::string presetText(const Preset& preset) {
  Json json = graphJson(preset.graph, preset.kind == PresetKind::Document);
  json[kMember] = memberJson(preset);
  return writeJson(json);
}

Result<LoadedPreset> presetFromText(std::string_view text) {
  PILEUS_TRY(Loaded loaded, parseGraph(text));
  const auto member = loaded.graph.unknown.find(kMember);
  if (member == loaded.graph.unknown.end())
    return fail(Code::Input, "not a preset: \"preset\" (what it is called) is missing");
  PILEUS_TRY(Preset preset, readMember(Json::parse(member->second, nullptr, false)));
  loaded.graph.unknown.erase(member);
  if (preset.kind == PresetKind::Parameters && loaded.graph.nodes.size() != 1)
    return wrong("kind", "is parameters, but the file does not hold one node");
  if (preset.kind == PresetKind::Nodes && loaded.graph.nodes.empty())
    return wrong("kind", "is nodes, but the file holds none");
  preset.graph = std::move(loaded.graph);
  return LoadedPreset{std::move(preset), std::move(loaded.faults)};
}

Result<Graph> withPresetParameters(const Graph& graph, const std::string& node, const Preset& preset) {
  const Node* present = findNode(graph, node);
  if (!present) return fail(Code::Arguments, "there is no node named '{}'", node);
  if (preset.kind != PresetKind::Parameters || preset.graph.nodes.size() != 1)
    return fail(Code::Arguments, "the preset '{}' holds no parameters of one node", preset.name);
  const Node& from = *preset.graph.nodes.begin()->second;
  if (from.type != present->type)
    return fail(Code::Arguments, "{}: the preset '{}' is of the node type {}", node, preset.name, from.type);
  Node changed = *present;
  changed.params = from.params;
  changed.animated = from.animated;
  if (from.group) changed.group = from.group;
  const auto isParameter = [](const auto& u) { return u.first.starts_with("params/"); };
  std::erase_if(changed.unknown, isParameter);
  for (const auto& entry : from.unknown)
    if (isParameter(entry)) changed.unknown.insert(entry);
  Graph result = graph;
  result.nodes[node] = std::make_shared<const Node>(std::move(changed));
  return result;
}

}  // namespace pileus::nodes
