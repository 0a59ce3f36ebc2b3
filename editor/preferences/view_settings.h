#pragma once
// What the viewport remembers between sessions: habits, overlays, and places of the camera for each file.
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "editor/preferences/navigation_preset.h"
#include "renderer/scene/camera.h"

namespace pileus::editor {

struct Overlays {
  bool on = true;       ///< all of them, gizmos included
  bool bounds = false;  ///< of volumes
  bool bricks = false;
  bool lights = true;  ///< icons, cones and directions
  bool solids = false;
  bool grid = false;
  bool safeFrame = false;
  bool axes = true;  ///< the little cross in the corner
  bool operator==(const Overlays&) const = default;
};

struct CameraPlaces {
  std::string path;  ///< of the document; "" = not saved yet
  std::array<std::optional<scene::Camera>, 9> places;
  bool operator==(const CameraPlaces&) const = default;
};

struct ViewSettings {
  NavigationPreset navigation = NavigationPreset::Maya;
  bool localAxes = false;  ///< gizmos along the node's own axes
  Overlays overlays;
  std::vector<CameraPlaces> cameras;  ///< most recently saved file first
  bool operator==(const ViewSettings&) const = default;
};

/// Under "viewport"; what is absent or wrong keeps its default.
void readViewSettings(const nlohmann::json& settings, ViewSettings& view);
void writeViewSettings(nlohmann::json& settings, const ViewSettings& view);

}  // namespace pileus::editor
