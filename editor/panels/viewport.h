#pragma once
// The viewport: the active output's picture through the display transform, its toolbar, and camera moves with
// the pointer.
#include <imgui.h>

#include <memory>
#include <optional>
#include <string>

#include "renderer/image/color.h"
#include "renderer/scene/camera.h"
#include "renderer/view/display.h"
#include "renderer/view/renderer.h"

namespace pileus::editor {

struct Editor;

struct Viewport {
  explicit Viewport(view::Renderer& renderer) : display(renderer.shaders()) {}

  std::string activeView;                   ///< output node chosen to be seen; "" or gone = the first one
  std::optional<scene::Camera> freeCamera;  ///< where no camera is linked; absent: pictures frame the volumes
  ivec2 renderSize{0};                      ///< what the panel asks the preview for

  enum class Drag { None, Orbit, Pan, Dolly } drag = Drag::None;
  bool wheelEdit = false;  ///< wheel notches merge into one undo step until they rest
  double wheelAt = 0;      ///< ImGui time of the last notch

  view::Display display;
  std::shared_ptr<const image::ColorConfig> colors;
  std::string colorsOf = "\n";  ///< settings.ocio the config was loaded for
  std::string colorError;

  // What the display texture was drawn from.
  const void* drawnPicture = nullptr;
  double drawnFraction = -1;
  int drawnSamples = -1;
  ivec2 drawnSize{0};
  view::DisplaySettings drawnSettings;
  unsigned texture = 0;
};

void drawViewport(Editor& editor, ImVec2 min, ImVec2 max, bool hovered);

}  // namespace pileus::editor
