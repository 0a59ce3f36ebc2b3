#pragma once
// Places of the camera to come back to, nine for each file, and making a node of the free camera.
#include <string>

namespace pileus::editor {

class Messages;
struct Clock;
struct Session;
struct Settings;
struct Shown;

/// `number` from 1.
void saveCameraPlace(Messages& messages, const Session& session, const Clock& clock, const Shown& shown,
                     Settings& settings, int number);
void goToCameraPlace(Messages& messages, Session& session, Clock& clock, Shown& shown,
                     const Settings& settings, int number);
bool hasCameraPlace(const Session& session, const Settings& settings, int number);
/// The document has another path now: its places come along.
void cameraPlacesFollow(Settings& settings, const std::string& from, const std::string& to);

/// A camera node like the view, linked to what is shown; one undo step.
void cameraFromView(Messages& messages, Session& session, const Clock& clock, const Shown& shown);
void unlinkCamera(Messages& messages, Session& session, const Clock& clock, Shown& shown);
bool hasLinkedCamera(const Session& session, const Shown& shown);

}  // namespace pileus::editor
