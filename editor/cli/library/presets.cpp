#include "editor/cli/library/presets.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "embedded_presets.h"
#include "nodes/file/preset_folder.h"
#include "renderer/base/log.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

using nlohmann::json;

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

std::vector<nodes::PresetEntry> own(const PresetSources& sources) {
  std::vector<nodes::PresetEntry> all;
  for (const fs::path& folder : sources.folders)
    for (nodes::PresetEntry& e : nodes::presetsIn(folder)) all.push_back(std::move(e));
  return all;
}

std::string kindOf(const nodes::PresetEntry& e) {
  if (!e.type.empty()) return e.type;
  return e.kind == nodes::PresetKind::Document ? "scene" : fmt::format("{} nodes", e.nodes);
}

/// "Dusk", "scene", "A low sun [cloud, warm]", its file.
void printRow(const std::string& name, const std::string& kind, const std::string& about,
              const std::vector<std::string>& tags, const std::string& from) {
  std::string said = about;
  if (!tags.empty()) said += (said.empty() ? "[" : " [") + nodes::presetTagList(tags) + "]";
  fmt::print("{:<28} {:<11} {}\n{:<28} {}\n", name, kind, said, "", from);
}

void printAll(const PresetSources& sources, const std::vector<nodes::PresetEntry>& mine) {
  for (const ShippedPreset& p : sources.shipped)
    printRow(p.name, "scene", p.about, p.tags, "shipped: " + p.file);
  for (const nodes::PresetEntry& e : mine)
    if (e.fault.empty()) printRow(e.name, kindOf(e), e.about, e.tags, e.file.string());
}

json jsonOf(const PresetSources& sources, const std::vector<nodes::PresetEntry>& mine) {
  json list = json::array();
  for (const ShippedPreset& p : sources.shipped)
    list.push_back(
        {{"name", p.name}, {"kind", "document"}, {"about", p.about}, {"tags", p.tags}, {"shipped", p.file}});
  for (const nodes::PresetEntry& e : mine) {
    json row = {{"name", e.name}, {"file", e.file.string()}};
    if (!e.fault.empty()) {
      row["fault"] = e.fault;
    } else {
      row["kind"] = enumId(e.kind);
      row["about"] = e.about;
      row["tags"] = e.tags;
      row["nodes"] = e.nodes;
      row["writable"] = e.writable;
      if (!e.type.empty()) row["type"] = e.type;
    }
    list.push_back(std::move(row));
  }
  return list;
}

}  // namespace

int presetsMain(const PresetSources& sources, bool asJson) {
  const std::vector<nodes::PresetEntry> mine = own(sources);
  if (asJson)
    fmt::print("{}\n", jsonOf(sources, mine).dump(2, ' ', false, json::error_handler_t::replace));
  else
    printAll(sources, mine);
  std::fflush(stdout);
  if (!asJson)
    for (const nodes::PresetEntry& e : mine)
      if (!e.fault.empty()) std::fprintf(stderr, "pileus: warning: %s\n", e.fault.c_str());
  return 0;
}

bool isPresetName(const fs::path& word) {
  std::error_code ec;
  return !word.empty() && word != "-" && !word.has_extension() && !fs::exists(word, ec);
}

Result<NamedScene> namedScene(const PresetSources& sources, const std::string& name) {
  const std::vector<nodes::PresetEntry> mine = own(sources);
  if (const nodes::PresetEntry* found = nodes::findPreset(mine, name)) {
    if (found->kind != nodes::PresetKind::Document)
      return fail(Code::Input, "the preset '{}' ({}) holds {}, not a scene that can be rendered", found->name,
                  found->file.string(),
                  found->kind == nodes::PresetKind::Nodes ? "some nodes" : "parameters");
    return NamedScene{found->file, {}};
  }
  for (const ShippedPreset& p : sources.shipped) {
    if (lower(p.name) != lower(name) && fs::path(p.file).stem() != lower(name)) continue;
    for (const EmbeddedFile& file : embedded_presets())
      if (file.path == p.file) return NamedScene{name, std::string(file.bytes)};
  }
  // One that cannot be read may be the one that was meant.
  for (const nodes::PresetEntry& e : mine)
    if (!e.fault.empty() && lower(e.name) == lower(name)) return fail(Code::Input, "{}", e.fault);
  std::string places;
  for (const fs::path& folder : sources.folders) places += (places.empty() ? "" : ", ") + folder.string();
  return fail(Code::Input, "there is neither a file nor a preset '{}'; `pileus presets` lists those of {}",
              name, places.empty() ? "the program" : "the program and of " + places);
}

}  // namespace pileus::cli
