#include "editor/commands/panel_commands.h"

#include "editor/editor.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/panel_list.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {

bool panelOpen(const Editor& editor, Panel panel) {
  if (panel == Panel::Global) return true;
  return editor.settings.*panelInfo(panel).shown &&
         (editor.now.maximised == Panel::Global || editor.now.maximised == panel);
}

void setPanelOpen(Editor& editor, Panel panel, bool open) {
  const PanelInfo& info = panelInfo(panel);
  if (panel == Panel::Global) return;
  editor.settings.*info.shown = open;
  if (!open && (panel == Panel::Viewport || panel == Panel::Graph))
    editor.settings.*panelInfo(panel == Panel::Viewport ? Panel::Graph : Panel::Viewport).shown = true;
  if (panel == Panel::Scope && !open) editor.shown.ray.picking = false;
  editor.now.maximised = Panel::Global;
}

void toggleMaximised(Editor& editor, Panel panel) {
  if (editor.now.maximised != Panel::Global)
    editor.now.maximised = Panel::Global;
  else if (panel != Panel::Global)
    editor.now.maximised = panel;
}

void revealPanel(Editor& editor, Panel panel) {
  if (!panelOpen(editor, panel)) setPanelOpen(editor, panel, true);
}

void useLayout(Editor& editor, std::string_view name) {
  const NamedLayout* layout = findLayout(editor.settings.layouts, name);
  if (!layout) return;
  static_cast<PanelLayout&>(editor.settings) = layout->panels;
  editor.now.maximised = Panel::Global;
  // The layout for comparing is of little use without a comparison.
  if (name == "Compare" && !editor.shown.compare.on && !shownView(editor.session, editor.shown).empty())
    toggleCompare(editor.messages, editor.shown);
}

}  // namespace pileus::editor
