#pragma once
// The viewport: the active output's picture through the display transform, its toolbar, and camera moves with
// the pointer.
#include <imgui.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/picture/snapshots.h"
#include "editor/viewport/display_mode.h"
#include "editor/viewport/inspector.h"
#include "editor/viewport/viewport_tools.h"
#include "renderer/gl/gpu_timer.h"
#include "renderer/image/color.h"
#include "renderer/scene/camera.h"
#include "renderer/view/display.h"
#include "renderer/view/picture.h"
#include "renderer/view/renderer.h"

namespace pileus::editor {

struct Editor;

struct Viewport {
  explicit Viewport(view::Renderer& renderer) : display(renderer.shaders()) {}

  std::string activeView;                   ///< node chosen to be seen; "" or gone = the first one
  std::optional<scene::Camera> freeCamera;  ///< where no camera is linked; absent: pictures frame the volumes
  ivec2 renderSize{0};                      ///< what the panel asks the preview for

  enum class Drag { None, Orbit, Pan, Dolly } drag = Drag::None;
  ViewportTools tools;
  bool wheelEdit = false;  ///< wheel notches merge into one undo step until they rest
  double wheelAt = 0;      ///< ImGui time of the last notch

  view::Display display;
  std::shared_ptr<const image::ColorConfig> colors;
  std::string colorsOf = "\n";  ///< settings.ocio the config was loaded for
  std::string colorError;

  /// A picture through the display transform, and what it was drawn from.
  struct Drawn {
    std::shared_ptr<const view::Picture> picture;
    double fraction = -1;
    int samples = -1;
    ivec2 size{0};
    view::DisplaySettings settings;
    unsigned texture = 0;
  };
  static constexpr std::size_t kThumbnails = 4;  ///< first slot of those
  /// The picture, the truth it is compared with, the sides of a wipe between stills, and their thumbnails.
  std::array<Drawn, kThumbnails + Snapshots::kMost> drawn;
  unsigned texture = 0;  ///< of the picture; 0 = none

  struct Rect {
    vec2 min{0}, max{0};
  };
  DisplayMode mode;
  Inspector inspector;
  Snapshots snapshots;
  gl::GpuTimer displayTimer;
  double displayMs = 0;  ///< of the display stage, as last known

  std::vector<Rect> shown;  ///< where the picture is on the screen: more than once when halves are compared
};

void drawViewport(Editor& editor, ImVec2 min, ImVec2 max, bool hovered);
/// `picture` through the shown output's display transform; redrawn only where something has changed. 0: it
/// cannot be. Slot 0 is the viewport's own.
unsigned displayTexture(Editor& editor, const std::shared_ptr<const view::Picture>& picture, ivec2 size,
                        std::size_t slot);
/// Does the display side use the pointer now: a region, an area, a line that is dragged?
bool displayTakesPointer(const Editor& editor);
/// Is something read from the GPU on its way?
bool displayWantsFrame(const Editor& editor);
/// Position in the picture, [0,1]^2 with y down, of a point of the screen; none beside it.
std::optional<vec2> pictureUv(const Viewport& viewport, vec2 screen);

}  // namespace pileus::editor
