#pragma once
// The strip below the viewport that says what the pixel under the pointer holds, or a pinned one, or an area.
#include <array>
#include <optional>

#include "editor/viewport/pixel_probe.h"

namespace pileus::editor {

struct Settings;
struct Shown;
struct Theme;
struct Viewport;
struct ViewportRoom;

struct Inspector {
  std::optional<dvec2> pointer;  ///< over the picture, 0..1
  std::optional<dvec2> pinned;
  std::optional<dvec2> areaFrom, areaTo;  ///< corners; both while there is an area
  bool draggingArea = false;
  bool pressed = false;              ///< a press that may become a pin
  std::array<PixelProbe, 2> probes;  ///< of the picture, and of what it is compared with

  bool area() const { return areaFrom && areaTo; }
  bool busy() const { return probes[0].busy() || probes[1].busy(); }
};

void toggleInspector(Settings& settings, Viewport& viewport);
/// What the strip wants; 0 while it is off.
float inspectorHeight(const Theme& theme, const Shown& shown, const Settings& settings,
                      const Viewport& viewport);
/// Marks in the picture, the pin and the area; takes clicks and Ctrl+drags over it.
void drawInspectorMarks(const Theme& theme, const Shown& shown, const Settings& settings, Viewport& viewport,
                        bool hovered);
void drawInspectorStrip(const ViewportRoom& room, vec2 lo, vec2 hi);

}  // namespace pileus::editor
