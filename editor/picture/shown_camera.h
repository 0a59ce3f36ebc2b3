#pragma once
// Which output the viewport shows, and the camera that makes its picture: a linked camera node (edited as
// undo steps) or the free camera. Nodes are given by their paths: they may be in groups.
#include <string>

#include "renderer/scene/camera.h"

namespace pileus::editor {

class Messages;
struct Clock;
struct Session;
struct Shown;

/// The node on show: the chosen one if it still exists and has a picture, else the first view output; "" =
/// none.
std::string shownView(const Session& session, const Shown& shown);
/// The view output whose display and exposure count: the shown one, else the nearest downstream of the shown
/// node, else the first; "" = none.
std::string displayNode(const Session& session, const Shown& shown);
/// The node whose picture the view shows (nearest upstream with a camera input); "" = none.
std::string cameraUser(const Session& session, const std::string& view);
/// Its input for a camera; "" = it has none.
std::string cameraInput(const Session& session, const std::string& user);
/// The camera node linked to it; "" = none: the free camera.
std::string linkedCamera(const Session& session, const std::string& view);
/// The camera the picture is made with now.
scene::Camera currentCamera(const Session& session, const Clock& clock, const Shown& shown);
/// Edits the linked camera node (steps with one mergeKey become one undo step) or sets the free camera; where
/// that node is locked, looks around.
void setCamera(Messages& messages, Session& session, Clock& clock, Shown& shown, const scene::Camera& camera,
               const std::string& label, const std::string& mergeKey);
/// Edits that camera node, the linked one.
void moveCamera(Messages& messages, Session& session, Clock& clock, Shown& shown, const std::string& name,
                const scene::Camera& camera, const std::string& label, const std::string& mergeKey);

// Actions.
void frameVolumes(Messages& messages, Session& session, Clock& clock, Shown& shown);
void changeExposure(Messages& messages, Session& session, const Clock& clock, const Shown& shown,
                    double stops);
void resetExposure(Messages& messages, Session& session, const Clock& clock, const Shown& shown);

}  // namespace pileus::editor
