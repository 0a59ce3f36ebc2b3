#pragma once
// The gizmo of the selected node over the picture: drawing it and carrying a drag into the document.
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

/// Of the selected node in the chosen mode.
std::optional<GizmoFrame> currentGizmo(const Editor& editor, const Projection& view);
void drawGizmo(Editor& editor, const Projection& view);
/// Takes hold of the handle under the pointer; false: there is none.
bool beginGizmoDrag(Editor& editor, const Projection& view);
/// Moves what is held, ends at the release.
void continueGizmoDrag(Editor& editor, const Projection& view);
void cancelGizmoDrag(Editor& editor);
/// Text on a chip beside the pointer.
void drawReadout(const Editor& editor, vec2 at, const std::string& text);

}  // namespace pileus::editor
