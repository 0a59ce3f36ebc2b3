#pragma once
// Looking through a light: the picture is made with a camera in its place, and moving that moves the light.
#include <optional>
#include <string>

#include "renderer/scene/camera.h"

namespace pileus::editor {

class Messages;
struct Clock;
struct Session;
struct Shown;
struct PreviewRequest;

/// The viewport's camera is that of a light.
struct LightView {
  std::string light;  ///< its path; "" = off
  dvec3 target{0};
  double distance = 1, fov = 8;
};

/// The path of the selected light, else of the first in a selected group, else of the only one there is; "" =
/// none.
std::string lightToUse(const Session& session, const Shown& shown);
void lookThroughLight(Messages& messages, Session& session, const Clock& clock, Shown& shown);
void leaveLightView(Session& session, Shown& shown);
/// The light's camera; nothing where no light is looked through.
std::optional<scene::Camera> lightViewCamera(const Session& session, const Clock& clock, const Shown& shown);
/// The camera was moved: the light goes along.
void moveLightView(Messages& messages, Session& session, Clock& clock, Shown& shown,
                   const scene::Camera& camera, const std::string& mergeKey);
/// The picture is made with the light's camera, whatever is linked.
void applyLightView(const Session& session, const Clock& clock, const Shown& shown, PreviewRequest& request);

}  // namespace pileus::editor
