#include "editor/parameters/file_state.h"

#include <fmt/core.h>
#include <imgui.h>

#include "editor/document/session.h"
#include "editor/parameters/parameters.h"
#include "editor/toolkit/file_listing.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr double kKeepSeconds = 2;

std::string faultOf(const fs::path& path) {
  std::error_code ec;
  if (fs::is_directory(path, ec)) return "This is a folder.";
  if (fs::exists(path, ec)) return {};
  const fs::path folder = path.parent_path();
  if (!fs::is_directory(folder, ec)) return fmt::format("Missing: there is no folder {}.", folder.string());
  if (!isPattern(path.filename().string()))
    return fmt::format("Missing: no such file in {}.", folder.string());
  return firstOfPattern(path) == path
             ? fmt::format("Missing: no file of that pattern in {}.", folder.string())
             : "";
}

}  // namespace

fs::path absoluteFile(const Session& session, const std::string& text) {
  if (text.empty()) return {};
  const fs::path path = expandedHome(text);
  if (path.is_absolute()) return path.lexically_normal();
  std::error_code ec;
  return fs::absolute(session.document.path().parent_path() / path, ec).lexically_normal();
}

fs::path firstOfPattern(const fs::path& path) {
  const std::string pattern = path.filename().string();
  if (!isPattern(pattern)) return path;
  Result<std::vector<FileEntry>> entries = listFolder(path.parent_path());
  if (!entries) return path;
  sortEntries(*entries, FileOrder::Name, false);
  for (const FileEntry& e : *entries)
    if (!e.folder && matchesPattern(pattern, e.name)) return path.parent_path() / e.name;
  return path;
}

std::string missingFile(const Session& session, Parameters& parameters, const std::string& text) {
  if (text.empty()) return {};
  const fs::path path = absoluteFile(session, text);
  FileStates& states = parameters.files;
  if (states.known.size() > 64) states.known.clear();
  FileStates::Known& known = states.known[path.string()];
  if (ImGui::GetTime() - known.at > kKeepSeconds) known = {faultOf(path), ImGui::GetTime()};
  return known.fault;
}

}  // namespace pileus::editor
