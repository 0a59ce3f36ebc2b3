#include "editor/preferences/view_settings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace pileus::editor {
namespace {

using nlohmann::json;

constexpr std::size_t kFiles = 50;

struct Flag {
  const char* id;
  bool Overlays::*member;
};
constexpr Flag kFlags[] = {{"shown", &Overlays::on},
                           {"bounds", &Overlays::bounds},
                           {"bricks", &Overlays::bricks},
                           {"lights", &Overlays::lights},
                           {"solids", &Overlays::solids},
                           {"grid", &Overlays::grid},
                           {"safeFrame", &Overlays::safeFrame},
                           {"axes", &Overlays::axes}};

void readFlag(const json& j, const char* key, bool& value) {
  const auto it = j.find(key);
  if (it != j.end() && it->is_boolean()) value = it->get<bool>();
}

bool readVector(const json& j, const char* key, dvec3& out) {
  const auto it = j.find(key);
  if (it == j.end() || !it->is_array() || it->size() != 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(*it)[i].is_number() || !std::isfinite((*it)[i].get<double>())) return false;
    out[static_cast<int>(i)] = (*it)[i].get<double>();
  }
  return true;
}

json vectorJson(const dvec3& v) { return {v.x, v.y, v.z}; }

std::optional<scene::Camera> readCamera(const json& j) {
  scene::Camera c;
  if (!j.is_object() || !readVector(j, "eye", c.eye) || !readVector(j, "target", c.target))
    return std::nullopt;
  if (!(glm::length(c.eye - c.target) > 1e-9)) return std::nullopt;
  if (!readVector(j, "up", c.up) || !(glm::length(c.up) > 1e-9)) c.up = {0, 1, 0};
  if (const auto fov = j.find("fov"); fov != j.end() && fov->is_number() && std::isfinite(fov->get<double>()))
    c.fov = std::clamp(fov->get<double>(), 0.1, 170.0);
  return c;
}

}  // namespace

void readViewSettings(const json& settings, ViewSettings& view) {
  const auto found = settings.find("viewport");
  if (found == settings.end() || !found->is_object()) return;
  const json& j = *found;
  if (const auto it = j.find("navigation"); it != j.end() && it->is_string())
    view.navigation = enumFromId<NavigationPreset>(it->get<std::string>()).value_or(view.navigation);
  readFlag(j, "localAxes", view.localAxes);
  if (const auto it = j.find("overlays"); it != j.end() && it->is_object())
    for (const Flag& f : kFlags) readFlag(*it, f.id, view.overlays.*f.member);
  const auto cameras = j.find("cameras");
  if (cameras == j.end() || !cameras->is_object()) return;
  for (const auto& [path, places] : cameras->items()) {
    if (!places.is_object() || view.cameras.size() >= kFiles) continue;
    CameraPlaces file{path, {}};
    for (const auto& [number, camera] : places.items())
      if (number.size() == 1 && number[0] >= '1' && number[0] <= '9')
        file.places[static_cast<std::size_t>(number[0] - '1')] = readCamera(camera);
    view.cameras.push_back(std::move(file));
  }
}

void writeViewSettings(json& settings, const ViewSettings& view) {
  json j = {{"navigation", enumId(view.navigation)}, {"localAxes", view.localAxes}};
  for (const Flag& f : kFlags) j["overlays"][f.id] = view.overlays.*f.member;
  json files = json::object();
  for (const CameraPlaces& file : view.cameras) {
    json places = json::object();
    for (std::size_t i = 0; i < file.places.size(); ++i)
      if (const auto& c = file.places[i])
        places[std::to_string(i + 1)] = {{"eye", vectorJson(c->eye)},
                                         {"target", vectorJson(c->target)},
                                         {"up", vectorJson(c->up)},
                                         {"fov", c->fov}};
    if (!file.path.empty() && !places.empty()) files[file.path] = std::move(places);
  }
  j["cameras"] = std::move(files);
  settings["viewport"] = std::move(j);
}

}  // namespace pileus::editor
