#include "editor/preferences/panel_list.h"

namespace pileus::editor {
namespace {

constexpr float kBar = 36;

constexpr PanelInfo kPanels[] = {
    {Panel::Viewport, "viewport", "Viewport", &PanelLayout::showViewport, kBar, 0},
    {Panel::Graph, "graph", "Graph", &PanelLayout::showGraph, 0, 0},
    {Panel::Parameters, "parameters", "Parameters", &PanelLayout::showParameters, 0, 0},
    {Panel::Scope, "scope", "Ray Scope", &PanelLayout::showScope, kBar, kBar},
    {Panel::Lab, "lab", "Lab", &PanelLayout::showLab, kBar, kBar},
    {Panel::Log, "log", "Log", &PanelLayout::showLog, kBar, kBar},
    {Panel::Timeline, "timeline", "Timeline", &PanelLayout::showTimeline, kBar, kBar},
    {Panel::Lights, "lights", "Lights", &PanelLayout::showLights, kBar, kBar},
};

}  // namespace

std::span<const PanelInfo> allPanels() { return kPanels; }

const PanelInfo& panelInfo(Panel panel) {
  for (const PanelInfo& info : kPanels)
    if (info.panel == panel) return info;
  return kPanels[0];
}

}  // namespace pileus::editor
