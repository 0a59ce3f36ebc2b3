#pragma once
// Looking around from a locked camera: moves in the viewport leave its node alone and move a view of their
// own, until one goes back.
#include <optional>
#include <string>

#include "renderer/scene/camera.h"

namespace pileus::editor {

class Messages;
struct Clock;
struct PreviewRequest;
struct Session;
struct Shown;

struct LookAround {
  std::string camera;  ///< the one that was left; "" = none was
  scene::Camera view;
};

/// Is the linked camera one that moves leave alone?
bool cameraLocked(const Session& session, const Clock& clock, const Shown& shown);
/// One undo step; unlocked, the view is the camera's again.
void toggleCameraLock(Messages& messages, Session& session, const Clock& clock, Shown& shown);
/// The view from beside the linked camera; nothing where it is looked through.
std::optional<scene::Camera> aroundCamera(const Session& session, const Shown& shown);
void backToCamera(Shown& shown);
/// The camera goes to where one looks around, locked or not; one undo step.
void cameraToView(Messages& messages, Session& session, Clock& clock, Shown& shown);
/// The picture is made from there, whatever is linked.
void applyLookAround(const Session& session, const Shown& shown, PreviewRequest& request);

}  // namespace pileus::editor
