#pragma once
// Which panels are open and how the window is divided among them: a value that can be kept under a name.
// Rectangles are made of it in app/panel_areas.h.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pileus::editor {

/// Lengths are design pixels: the same at every UI scale.
struct PanelLayout {
  double viewportShare = 0.56;  ///< of the height that viewport and graph divide
  double parametersWidth = 340;
  double scopeWidth = 420;
  double labHeight = 300;
  double logHeight = 200;
  double timelineHeight = 190;
  double lightsHeight = 200;
  bool showViewport = true;
  bool showGraph = true;
  bool showParameters = true;
  bool showScope = false;
  bool showLab = false;
  bool showLog = false;
  bool showTimeline = false;
  bool showLights = false;

  bool operator==(const PanelLayout&) const = default;
};

struct NamedLayout {
  std::string name;
  PanelLayout panels;
  bool operator==(const NamedLayout&) const = default;
};

/// Default, Graph, Look, Compare, Animate: always there, never changed.
std::span<const NamedLayout> builtInLayouts();
/// Of the user's own first, then of the built-in ones; null: there is none of that name.
const NamedLayout* findLayout(std::span<const NamedLayout> own, std::string_view name);
/// Adds it or replaces the one of that name.
void keepLayout(std::vector<NamedLayout>& own, const std::string& name, const PanelLayout& panels);

/// Brings every length into the range that can be used.
void clampLengths(PanelLayout& panels);
/// Absent or wrong entries keep what `panels` had; lengths are clamped to what can be used.
void readLayout(const nlohmann::json& j, PanelLayout& panels);
void writeLayout(nlohmann::json& j, const PanelLayout& panels);

}  // namespace pileus::editor
