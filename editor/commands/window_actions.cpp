// Commands of the window: its panels, layouts and the scale of the interface.
#include "editor/app/look.h"
#include "editor/app/panels.h"
#include "editor/commands/table.h"

namespace pileus::editor {
namespace {

using P = Panel;

template <Panel kPanel>
void togglePanel(Editor& e) {
  setPanelOpen(e, kPanel, !panelOpen(e, kPanel));
}
template <Panel kPanel>
bool panelShown(const Editor& e) {
  return panelOpen(e, kPanel);
}
template <std::size_t kIndex>
void layout(Editor& e) {
  useLayout(e, builtInLayouts()[kIndex].name);
}
template <std::size_t kIndex>
bool layoutShown(const Editor& e) {
  return static_cast<const PanelLayout&>(e.settings) == builtInLayouts()[kIndex].panels;
}

#define PANEL(kind, label, ...)                                                                         \
  {                                                                                                     \
    "view.panel_" #kind, label, "View/Panels", P::Global, {__VA_ARGS__}, togglePanel<P::kind>, nullptr, \
        panelShown<P::kind>                                                                             \
  }

#define LAYOUT(index, id, label) \
  { "view.layout_" id, label, "View/Layouts", P::Global, {}, layout<index>, nullptr, layoutShown<index> }

const Action kActions[] = {
    PANEL(Viewport, "Viewport", alt(GLFW_KEY_1)),
    PANEL(Graph, "Graph", alt(GLFW_KEY_2)),
    PANEL(Parameters, "Parameters", alt(GLFW_KEY_3)),
    PANEL(Scope, "Ray Scope", alt(GLFW_KEY_4), shift(GLFW_KEY_S)),
    PANEL(Lab, "Lab", alt(GLFW_KEY_5)),
    PANEL(Log, "Log", alt(GLFW_KEY_6), plain(GLFW_KEY_F8)),
    PANEL(Timeline, "Timeline", alt(GLFW_KEY_7)),
    LAYOUT(0, "default", "Default"),
    LAYOUT(1, "graph", "Graph"),
    LAYOUT(2, "look", "Look"),
    LAYOUT(3, "compare", "Compare"),
    LAYOUT(4, "animate", "Animate"),
    {"view.maximise",
     "Maximise Panel",
     "View",
     P::Global,
     {ctrl(GLFW_KEY_SPACE)},
     [](Editor& e) { toggleMaximised(e, e.hovered); },
     nullptr,
     [](const Editor& e) { return e.maximised != P::Global; }},
    {"view.scale_up",
     "Larger Interface",
     "View/Interface Scale",
     P::Global,
     {ctrl(GLFW_KEY_EQUAL), ctrlShift(GLFW_KEY_EQUAL), ctrl(GLFW_KEY_KP_ADD)},
     [](Editor& e) { stepUiScale(e, 1); },
     nullptr,
     nullptr,
     true},
    {"view.scale_down",
     "Smaller Interface",
     "View/Interface Scale",
     P::Global,
     {ctrl(GLFW_KEY_MINUS), ctrl(GLFW_KEY_KP_SUBTRACT)},
     [](Editor& e) { stepUiScale(e, -1); }},
    {"view.scale_screen",
     "Size the Screen Asks For",
     "View/Interface Scale",
     P::Global,
     {ctrl(GLFW_KEY_0), ctrl(GLFW_KEY_KP_0)},
     [](Editor& e) { chooseUiScale(e, 0); },
     nullptr,
     [](const Editor& e) { return e.uiScale == 0; }},
};

}  // namespace

std::span<const Action> windowActions() { return kActions; }

}  // namespace pileus::editor
