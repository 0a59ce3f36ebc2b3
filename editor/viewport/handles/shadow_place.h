#pragma once
// Placing a light by its shadow.
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

struct Session;
struct Shown;
struct Ui;
struct Viewport;
struct ViewportRoom;

/// Begins with the selected light, else with the only one there is.
void placeByShadow(const ViewportRoom& room);
/// Where the pointer is a free click; true: it was taken.
bool clickShadowPlace(Ui& ui, Session& session, const Shown& shown, Viewport& viewport,
                      const Projection& view, vec2 at);
/// The light follows the pointer.
void followShadowPlace(const ViewportRoom& room, const Projection& view, vec2 at);
void cancelShadowPlace(Session& session, Viewport& viewport);
/// What the next click does; "" = the tool is not in use.
std::string shadowPlaceHint(const ViewportTools& tools);
/// A light's target so that what is at `caster` throws its shadow on `receiver`.
GizmoTarget castingOnto(const GizmoTarget& light, const dvec3& caster, const dvec3& receiver);

}  // namespace pileus::editor
