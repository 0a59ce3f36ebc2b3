#include "editor/preferences/settings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/base/file.h"
#include "renderer/base/log.h"

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

void read(const json& j, std::vector<NamedLayout>& all) {
  const auto it = j.find("layouts");
  if (it == j.end() || !it->is_object()) return;
  for (const auto& [name, panels] : it->items()) {
    if (name.empty() || !panels.is_object() || all.size() >= 32) continue;
    NamedLayout layout{name, {}};
    readLayout(panels, layout.panels);
    all.push_back(std::move(layout));
  }
}

json layoutsJson(const std::vector<NamedLayout>& all) {
  json j = json::object();
  for (const NamedLayout& l : all) writeLayout(j[l.name], l.panels);
  return j;
}

void read(const json& j, std::vector<FileBookmarks>& all) {
  const auto it = j.find("bookmarks");
  if (it == j.end() || !it->is_object()) return;
  for (const auto& [path, places] : it->items()) {
    FileBookmarks file{path, {}};
    if (!places.is_object() || all.size() >= 50) continue;
    for (const auto& [number, place] : places.items()) {
      if (number.size() != 1 || number[0] < '1' || number[0] > '9' || !place.is_object()) continue;
      CanvasPlace p;
      const auto figure = [&](const char* key, double fallback) {
        const auto v = place.find(key);
        return v != place.end() && v->is_number() && std::isfinite(v->get<double>()) ? v->get<double>()
                                                                                     : fallback;
      };
      p.center = {figure("x", 0), figure("y", 0)};
      p.level = kLevelOfZoom0 + static_cast<int>(std::clamp(figure("zoom", 0), -1.0 * kLevelOfZoom0, 1000.0));
      read(place, "scope", p.scope);
      file.places[static_cast<std::size_t>(number[0] - '1')] = std::move(p);
    }
    all.push_back(std::move(file));
  }
}

json bookmarksJson(const std::vector<FileBookmarks>& all) {
  json j = json::object();
  for (const FileBookmarks& file : all) {
    json places = json::object();
    for (std::size_t i = 0; i < file.places.size(); ++i)
      if (const auto& p = file.places[i])
        places[std::to_string(i + 1)] = {
            {"x", p->center.x}, {"y", p->center.y}, {"zoom", p->level - kLevelOfZoom0}, {"scope", p->scope}};
    if (!file.path.empty() && !places.empty()) j[file.path] = std::move(places);
  }
  return j;
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
  readLayout(j, s);
  readViewSettings(j, s.view);
  if (const auto it = j.find("theme"); it != j.end() && it->is_string())
    s.theme = enumFromId<Appearance>(it->get<std::string>()).value_or(s.theme);
  read(j, "uiScale", s.uiScale, 0, 4);
  if (s.uiScale != 0) s.uiScale = std::max(s.uiScale, 0.5);
  read(j, s.layouts);
  read(j, "viewportResolution", s.viewportResolution, 0.125, 2);
  read(j, "draftMs", s.draftMs, 30, 100);
  read(j, "showInspector", s.showInspector);
  read(j, "showHistogram", s.showHistogram);
  read(j, "showHud", s.showHud);
  read(j, "showTimes", s.showTimes);
  read(j, "showThumbnails", s.showThumbnails);
  read(j, "showMinimap", s.showMinimap);
  read(j, "showStart", s.showStart);
  read(j, "tourSeen", s.tourSeen);
  read(j, s.bookmarks);
  read(j, "recentCommands", s.recentCommands);
  read(j, "recentFiles", s.recentFiles);
  read(j, "recentNodes", s.recentNodes);
  read(j, "recentFolders", s.recentFolders);
  read(j, "folderBookmarks", s.folderBookmarks);
  read(j, "presetFolders", s.presetFolders);
  if (const auto it = j.find("kindFolders"); it != j.end() && it->is_object())
    for (const auto& [kind, where] : it->items())
      if (where.is_string() && s.kindFolders.size() < 32) s.kindFolders[kind] = where.get<std::string>();
  return s;
}

std::string settingsText(const Settings& s) {
  json j = {{"theme", enumId(s.theme)},
            {"uiScale", s.uiScale},
            {"layouts", layoutsJson(s.layouts)},
            {"recentCommands", s.recentCommands},
            {"viewportResolution", s.viewportResolution},
            {"draftMs", s.draftMs},
            {"showInspector", s.showInspector},
            {"showHistogram", s.showHistogram},
            {"showHud", s.showHud},
            {"showStart", s.showStart},
            {"tourSeen", s.tourSeen},
            {"showTimes", s.showTimes},
            {"showThumbnails", s.showThumbnails},
            {"showMinimap", s.showMinimap},
            {"bookmarks", bookmarksJson(s.bookmarks)},
            {"recentFiles", s.recentFiles},
            {"recentNodes", s.recentNodes},
            {"recentFolders", s.recentFolders},
            {"folderBookmarks", s.folderBookmarks},
            {"presetFolders", s.presetFolders},
            {"kindFolders", s.kindFolders}};
  writeLayout(j, s);
  writeViewSettings(j, s.view);
  if (s.window.x > 0) j["window"] = {s.window.x, s.window.y};
  return j.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Settings loadSettings(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kSettingsName;
  std::error_code ec;
  if (!std::filesystem::exists(path, ec)) return {};
  const Result<std::string> text = readFile(path, 1 << 20);
  if (text && json::parse(*text, nullptr, false).is_object()) return settingsFromText(*text);
  setDamagedAside(folder);
  return {};
}

void setDamagedAside(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kSettingsName, aside = path.string() + ".bad";
  std::error_code ec;
  std::filesystem::rename(path, aside, ec);
  log::warn("The settings in {} cannot be read; they were {} and begin anew.", path.string(),
            ec ? "left out" : "renamed to " + aside.filename().string());
}

Result<void> saveSettings(const std::filesystem::path& folder, const Settings& settings) {
  return writeFileAtomic(folder / kSettingsName, settingsText(settings));
}

}  // namespace pileus::editor
