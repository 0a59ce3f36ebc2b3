#pragma once
// Files that parameters name: where they are, and whether they are there. What the disk said is kept for a
// moment, so that drawing does not ask it each frame.
#include <filesystem>
#include <map>
#include <string>

namespace pileus::editor {

struct Parameters;
struct Session;

struct FileStates {
  struct Known {
    std::string fault;
    double at = -1e9;  ///< ImGui time of the look
  };
  std::map<std::string, Known> known;  ///< by absolute path
};

/// From the document's folder, "~" and patterns included; empty stays empty.
std::filesystem::path absoluteFile(const Session& session, const std::string& text);
/// Why a file to read cannot be found, in words; "" = it is there, or none is named.
std::string missingFile(const Session& session, Parameters& parameters, const std::string& text);
/// The first file of a pattern ("smoke.####.vdb"); other paths stay.
std::filesystem::path firstOfPattern(const std::filesystem::path& path);

}  // namespace pileus::editor
