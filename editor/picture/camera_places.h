#pragma once
// Places of the camera to come back to, nine for each file, and making a node of the free camera.
#include <string>

namespace pileus::editor {

struct Editor;

/// `number` from 1.
void saveCameraPlace(Editor& editor, int number);
void goToCameraPlace(Editor& editor, int number);
bool hasCameraPlace(const Editor& editor, int number);
/// The document has another path now: its places come along.
void cameraPlacesFollow(Editor& editor, const std::string& from, const std::string& to);

/// A camera node like the view, linked to what is shown; one undo step.
void cameraFromView(Editor& editor);
void unlinkCamera(Editor& editor);
bool hasLinkedCamera(const Editor& editor);

}  // namespace pileus::editor
