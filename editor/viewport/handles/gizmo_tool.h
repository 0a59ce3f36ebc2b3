#pragma once
// The gizmo of the selected node over the picture: drawing it and carrying a drag into the document.
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

struct Session;
struct Theme;
struct Viewport;
struct ViewportRoom;

/// Of the selected node in the chosen mode.
std::optional<GizmoFrame> currentGizmo(const ViewportRoom& room, const Projection& view);
void drawGizmo(const ViewportRoom& room, const Projection& view);
/// Takes hold of the handle under the pointer; false: there is none.
bool beginGizmoDrag(const ViewportRoom& room, const Projection& view);
/// Moves what is held, ends at the release.
void continueGizmoDrag(const ViewportRoom& room, const Projection& view);
void cancelGizmoDrag(Session& session, Viewport& viewport);
/// Text on a chip beside the pointer.
void drawReadout(const Theme& theme, vec2 at, const std::string& text);

}  // namespace pileus::editor
