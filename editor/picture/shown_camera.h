#pragma once
// Which output the viewport shows, and the camera that makes its picture: a linked camera node (edited as
// undo steps) or the free camera.
#include <string>

#include "renderer/scene/camera.h"

namespace pileus::editor {

struct Editor;

/// The node on show: the chosen one if it still exists and has a picture, else the first view output; "" =
/// none.
std::string shownView(const Editor& editor);
/// The view output whose display and exposure count: the shown one, else the nearest downstream of the shown
/// node, else the first; "" = none.
std::string displayNode(const Editor& editor);
/// The node whose picture the view shows (nearest upstream with a camera input); "" = none.
std::string cameraUser(const Editor& editor, const std::string& view);
/// The camera node linked to it; "" = none: the free camera.
std::string linkedCamera(const Editor& editor, const std::string& view);
/// The camera the picture is made with now.
scene::Camera currentCamera(const Editor& editor);
/// Edits the linked camera node (steps with one mergeKey become one undo step) or sets the free camera.
void setCamera(Editor& editor, const scene::Camera& camera, const std::string& label,
               const std::string& mergeKey);

// Actions.
void frameVolumes(Editor& editor);
void changeExposure(Editor& editor, double stops);
void resetExposure(Editor& editor);

}  // namespace pileus::editor
