// Commands of the window: its panels, layouts and the scale of the interface.
#include "editor/commands/look.h"
#include "editor/commands/panel_commands.h"
#include "editor/commands/table.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/ui.h"

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

#define PANEL(kind, title, ...)                                                              \
  {                                                                                          \
    .id = "view.panel_" #kind, .label = title, .menu = "View/Panels", .keys = {__VA_ARGS__}, \
    .run = togglePanel<P::kind>, .checked = panelShown<P::kind>                              \
  }

#define LAYOUT(index, name, title)                                                           \
  {                                                                                          \
    .id = "view.layout_" name, .label = title, .menu = "View/Layouts", .run = layout<index>, \
    .checked = layoutShown<index>                                                            \
  }

const Action kActions[] = {
    PANEL(Viewport, "Viewport", alt(GLFW_KEY_1)),
    PANEL(Graph, "Graph", alt(GLFW_KEY_2)),
    PANEL(Parameters, "Parameters", alt(GLFW_KEY_3)),
    PANEL(Scope, "Ray Scope", alt(GLFW_KEY_4), shift(GLFW_KEY_S)),
    PANEL(Lab, "Lab", alt(GLFW_KEY_5)),
    PANEL(Log, "Log", alt(GLFW_KEY_6), plain(GLFW_KEY_F8)),
    PANEL(Timeline, "Timeline", alt(GLFW_KEY_7)),
    PANEL(Lights, "Lights", alt(GLFW_KEY_8)),
    LAYOUT(0, "default", "Default"),
    LAYOUT(1, "graph", "Graph"),
    LAYOUT(2, "look", "Look"),
    LAYOUT(3, "compare", "Compare"),
    LAYOUT(4, "animate", "Animate"),
    {.id = "view.maximise",
     .label = "Maximise Panel",
     .menu = "View",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_SPACE)},
     .run = [](Editor& e) { toggleMaximised(e, e.now.hovered); },
     .checked = [](const Editor& e) { return e.now.maximised != P::Global; }},
    {.id = "view.scale_up",
     .label = "Larger Interface",
     .menu = "View/Interface Scale",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_EQUAL), ctrlShift(GLFW_KEY_EQUAL), ctrl(GLFW_KEY_KP_ADD)},
     .run = [](Editor& e) { stepUiScale(e, 1); },
     .separator = true},
    {.id = "view.scale_down",
     .label = "Smaller Interface",
     .menu = "View/Interface Scale",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_MINUS), ctrl(GLFW_KEY_KP_SUBTRACT)},
     .run = [](Editor& e) { stepUiScale(e, -1); }},
    {.id = "view.scale_screen",
     .label = "Size the Screen Asks For",
     .menu = "View/Interface Scale",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_0), ctrl(GLFW_KEY_KP_0)},
     .run = [](Editor& e) { chooseUiScale(e, 0); },
     .checked = [](const Editor& e) { return e.now.uiScale == 0; }},
};

}  // namespace

std::span<const Action> windowActions() { return kActions; }

}  // namespace pileus::editor
