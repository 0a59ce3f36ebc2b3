#pragma once
// Placing a light by its shadow, and looking through a light.
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

struct PreviewRequest;

/// Begins with the selected light, else with the only one there is.
void placeByShadow(Editor& editor);
/// Where the pointer is a free click; true: it was taken.
bool clickShadowPlace(Editor& editor, const Projection& view, vec2 at);
/// The light follows the pointer.
void followShadowPlace(Editor& editor, const Projection& view, vec2 at);
void cancelShadowPlace(Editor& editor);
/// What the next click does; "" = the tool is not in use.
std::string shadowPlaceHint(const ViewportTools& tools);
/// A light's target so that what is at `caster` throws its shadow on `receiver`.
GizmoTarget castingOnto(const GizmoTarget& light, const dvec3& caster, const dvec3& receiver);

void lookThroughLight(Editor& editor);
void leaveLightView(Editor& editor);
/// The light's camera; nothing where no light is looked through.
std::optional<scene::Camera> lightViewCamera(const Editor& editor);
/// The camera was moved: the light goes along.
void moveLightView(Editor& editor, const scene::Camera& camera, const std::string& mergeKey);
/// The picture is made with the light's camera, whatever is linked.
void applyLightView(const Editor& editor, PreviewRequest& request);

}  // namespace pileus::editor
