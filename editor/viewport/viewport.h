#pragma once
// The viewport: the active output's picture through the display transform, its toolbar, and camera moves with
// the pointer.
#include <imgui.h>

#include <optional>
#include <vector>

#include "editor/viewport/inspector.h"
#include "editor/viewport/viewport_tools.h"

namespace pileus::editor {

struct Settings;
struct Shown;
struct ViewportRoom;

struct Viewport {
  enum class Drag { None, Orbit, Pan, Dolly, Turn } drag = Drag::None;
  ViewportTools tools;
  bool wheelEdit = false;  ///< wheel notches merge into one undo step until they rest
  double wheelAt = 0;      ///< ImGui time of the last notch
  Inspector inspector;
};

void drawViewport(const ViewportRoom& room, ImVec2 min, ImVec2 max, bool hovered);
/// Does the display side use the pointer now: a region, an area, a line that is dragged?
bool displayTakesPointer(const Shown& shown, const Settings& settings, const Viewport& viewport);
/// Is something read from the GPU on its way?
bool displayWantsFrame(const Shown& shown, const Settings& settings, const Viewport& viewport);
/// Position in the picture, [0,1]^2 with y down, of a point of the screen; none beside it.
std::optional<vec2> pictureUv(const Shown& shown, vec2 screen);

}  // namespace pileus::editor
