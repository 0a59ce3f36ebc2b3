#include "editor/settings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/base/file.h"

namespace pileus::editor {
namespace {

using nlohmann::json;

void read(const json& j, const char* key, double& value, double lo, double hi) {
  const auto it = j.find(key);
  if (it != j.end() && it->is_number() && std::isfinite(it->get<double>()))
    value = std::clamp(it->get<double>(), lo, hi);
}

void read(const json& j, const char* key, bool& value) {
  const auto it = j.find(key);
  if (it != j.end() && it->is_boolean()) value = it->get<bool>();
}

void read(const json& j, const char* key, std::vector<std::string>& list) {
  const auto it = j.find(key);
  if (it == j.end() || !it->is_array()) return;
  list.clear();
  for (const json& entry : *it)
    if (entry.is_string() && list.size() < 32) list.push_back(entry.get<std::string>());
}

}  // namespace

void remember(std::vector<std::string>& list, const std::string& entry, std::size_t limit) {
  std::erase(list, entry);
  list.insert(list.begin(), entry);
  if (list.size() > limit) list.resize(limit);
}

Settings settingsFromText(std::string_view text) {
  Settings s;
  const json j = json::parse(text, nullptr, false);
  if (!j.is_object()) return s;
  if (const auto it = j.find("window");
      it != j.end() && it->is_array() && it->size() == 2 && (*it)[0].is_number() && (*it)[1].is_number()) {
    s.window.x = static_cast<int>(std::clamp((*it)[0].get<double>(), 720.0, 16384.0));
    s.window.y = static_cast<int>(std::clamp((*it)[1].get<double>(), 480.0, 16384.0));
  }
  read(j, "viewportShare", s.viewportShare, 0.15, 0.85);
  read(j, "parametersWidth", s.parametersWidth, 240, 900);
  read(j, "logHeight", s.logHeight, 60, 800);
  read(j, "scopeWidth", s.scopeWidth, 280, 1200);
  read(j, "labHeight", s.labHeight, 160, 1000);
  read(j, "viewportResolution", s.viewportResolution, 0.125, 2);
  read(j, "showTimes", s.showTimes);
  read(j, "showLog", s.showLog);
  read(j, "showScope", s.showScope);
  read(j, "showLab", s.showLab);
  read(j, "recentFiles", s.recentFiles);
  read(j, "recentNodes", s.recentNodes);
  read(j, "recentFolders", s.recentFolders);
  return s;
}

std::string settingsText(const Settings& s) {
  const json j = {{"window", {s.window.x, s.window.y}},
                  {"viewportShare", s.viewportShare},
                  {"parametersWidth", s.parametersWidth},
                  {"logHeight", s.logHeight},
                  {"scopeWidth", s.scopeWidth},
                  {"labHeight", s.labHeight},
                  {"viewportResolution", s.viewportResolution},
                  {"showTimes", s.showTimes},
                  {"showLog", s.showLog},
                  {"showScope", s.showScope},
                  {"showLab", s.showLab},
                  {"recentFiles", s.recentFiles},
                  {"recentNodes", s.recentNodes},
                  {"recentFolders", s.recentFolders}};
  return j.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Settings loadSettings(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "settings.json";
  std::error_code ec;
  if (!std::filesystem::exists(path, ec)) return {};
  const Result<std::string> text = readFile(path, 1 << 20);
  return text ? settingsFromText(*text) : Settings{};
}

Result<void> saveSettings(const std::filesystem::path& folder, const Settings& settings) {
  return writeFileAtomic(folder / "settings.json", settingsText(settings));
}

}  // namespace pileus::editor
