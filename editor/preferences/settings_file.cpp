#include "editor/preferences/settings_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "renderer/base/file.h"

namespace pileus::editor {
namespace {

using nlohmann::json;

/// Ours, then what the file holds beside: entries that came from somewhere else.
json joinedRecent(const json& mine, const json& before, const json& file) {
  json all = mine;
  const auto has = [](const json& list, const json& entry) {
    return std::find(list.begin(), list.end(), entry) != list.end();
  };
  for (const json& entry : file)
    if (entry.is_string() && all.size() < 32 && !has(before, entry) && !has(all, entry)) all.push_back(entry);
  return all;
}

}  // namespace

SettingsFile::SettingsFile(std::filesystem::path folder, Settings loaded, double restSeconds)
    : folder_(std::move(folder)), written_(loaded), seen_(std::move(loaded)), rest_(restSeconds) {}

Result<void> SettingsFile::watch(const Settings& now) {
  if (!(now == seen_)) {
    seen_ = now;
    age_.restart();
    due_ = true;
  }
  if (!due_ || age_.ms() < rest_ * 1000) return {};
  return save(now);
}

double SettingsFile::dueSeconds() const { return due_ ? std::max(0.0, rest_ - age_.ms() / 1000) : -1; }

Result<void> SettingsFile::save(const Settings& now) {
  due_ = false;
  seen_ = now;
  const json mine = json::parse(settingsText(now)), before = json::parse(settingsText(written_));
  json file = json::object();
  std::error_code ec;
  if (std::filesystem::exists(folder_ / kSettingsName, ec)) {
    const Result<std::string> text = readFile(folder_ / kSettingsName, 1 << 20);
    file = text ? json::parse(*text, nullptr, false) : json();
    if (!file.is_object()) {
      setDamagedAside(folder_);
      file = json::object();
    }
  }
  for (const auto& [key, value] : mine.items()) {
    const bool changed = !before.contains(key) || before[key] != value;
    if (key.starts_with("recent") && file.contains(key) && file[key].is_array() && before.contains(key))
      file[key] = changed ? joinedRecent(value, before[key], file[key]) : file[key];
    else if (changed || !file.contains(key))
      file[key] = value;
  }
  PILEUS_CHECK(writeFileAtomic(folder_ / kSettingsName,
                               file.dump(2, ' ', false, json::error_handler_t::replace) + "\n"));
  written_ = now;
  return {};
}

}  // namespace pileus::editor
