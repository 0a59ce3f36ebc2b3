#include "editor/preferences/panel_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace pileus::editor {
namespace {

using nlohmann::json;

struct Length {
  const char* key;
  double PanelLayout::*value;
  double least, most;
};
constexpr Length kLengths[] = {
    {"viewportShare", &PanelLayout::viewportShare, 0.1, 0.9},
    {"parametersWidth", &PanelLayout::parametersWidth, 240, 900},
    {"scopeWidth", &PanelLayout::scopeWidth, 280, 1200},
    {"labHeight", &PanelLayout::labHeight, 160, 1000},
    {"logHeight", &PanelLayout::logHeight, 90, 800},
    {"timelineHeight", &PanelLayout::timelineHeight, 90, 800},
    {"lightsHeight", &PanelLayout::lightsHeight, 90, 800},
};

struct Switch {
  const char* key;
  bool PanelLayout::*value;
};
constexpr Switch kSwitches[] = {
    {"showViewport", &PanelLayout::showViewport},
    {"showGraph", &PanelLayout::showGraph},
    {"showParameters", &PanelLayout::showParameters},
    {"showScope", &PanelLayout::showScope},
    {"showLab", &PanelLayout::showLab},
    {"showLog", &PanelLayout::showLog},
    {"showTimeline", &PanelLayout::showTimeline},
    {"showLights", &PanelLayout::showLights},
};

PanelLayout graphLayout() {
  PanelLayout p;
  p.viewportShare = 0.3;
  return p;
}
PanelLayout lookLayout() {
  PanelLayout p;
  p.showGraph = p.showParameters = false;
  return p;
}
PanelLayout compareLayout() {
  PanelLayout p;
  p.viewportShare = 0.72;
  p.showScope = true;
  p.showParameters = false;
  return p;
}

PanelLayout animateLayout() {
  PanelLayout p;
  p.showTimeline = true;
  return p;
}

}  // namespace

std::span<const NamedLayout> builtInLayouts() {
  static const std::array<NamedLayout, 5> all = {NamedLayout{"Default", PanelLayout{}},
                                                 {"Graph", graphLayout()},
                                                 {"Look", lookLayout()},
                                                 {"Compare", compareLayout()},
                                                 {"Animate", animateLayout()}};
  return all;
}

const NamedLayout* findLayout(std::span<const NamedLayout> own, std::string_view name) {
  for (const std::span<const NamedLayout> list : {own, builtInLayouts()})
    for (const NamedLayout& l : list)
      if (l.name == name) return &l;
  return nullptr;
}

void keepLayout(std::vector<NamedLayout>& own, const std::string& name, const PanelLayout& panels) {
  for (NamedLayout& l : own)
    if (l.name == name) {
      l.panels = panels;
      return;
    }
  own.push_back({name, panels});
}

void clampLengths(PanelLayout& panels) {
  for (const Length& l : kLengths) panels.*l.value = std::clamp(panels.*l.value, l.least, l.most);
}

void readLayout(const json& j, PanelLayout& panels) {
  for (const Length& l : kLengths) {
    const auto it = j.find(l.key);
    if (it != j.end() && it->is_number() && std::isfinite(it->get<double>()))
      panels.*l.value = it->get<double>();
  }
  clampLengths(panels);
  for (const Switch& s : kSwitches) {
    const auto it = j.find(s.key);
    if (it != j.end() && it->is_boolean()) panels.*s.value = it->get<bool>();
  }
  // A window without its two main panels shows nothing to work with.
  if (!panels.showViewport && !panels.showGraph) panels.showViewport = true;
}

void writeLayout(json& j, const PanelLayout& panels) {
  for (const Length& l : kLengths) j[l.key] = panels.*l.value;
  for (const Switch& s : kSwitches) j[s.key] = panels.*s.value;
}

}  // namespace pileus::editor
