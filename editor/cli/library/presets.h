#pragma once
// pileus presets: those that are part of the program and those of the user's folders; and which of them a
// name means.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/result.h"

namespace pileus::cli {

/// One that is linked into the binary, as the gallery calls it.
struct ShippedPreset {
  std::string file, name, about;  ///< file: "default.json"
  std::vector<std::string> tags;
};

/// All presets there are.
struct PresetSources {
  std::vector<ShippedPreset> shipped;
  std::vector<std::filesystem::path> folders;
};

/// Lists them; what cannot be read is a warning, in JSON an entry with a "fault".
int presetsMain(const PresetSources& sources, bool json);

/// What `pileus render WORD` takes: a file of a folder, or the text of one that is shipped.
struct NamedScene {
  std::filesystem::path file;
  std::string text;  ///< not "": instead of the file
};
/// Is this a preset's name rather than a file? No file of this name is there, and it has no extension.
bool isPresetName(const std::filesystem::path& word);
/// By its name or its file's, one's own before a shipped one. Error (Input): no such preset, or none that is
/// a scene; it says where was looked.
Result<NamedScene> namedScene(const PresetSources& sources, const std::string& name);

}  // namespace pileus::cli
