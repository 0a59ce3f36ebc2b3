#pragma once
// What the viewport shows: which node, with which camera, in which manner; the pictures that were made of it
// and what they are compared with. GL thread.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/picture/compare_mode.h"
#include "editor/picture/display_mode.h"
#include "editor/picture/displayed.h"
#include "editor/picture/light_mixer.h"
#include "editor/picture/light_view.h"
#include "editor/picture/look_around.h"
#include "editor/picture/preview.h"
#include "editor/picture/ray_pick.h"
#include "editor/picture/snapshots.h"
#include "editor/picture/view_scene.h"
#include "editor/picture/viewed_node.h"
#include "renderer/view/renderer.h"

namespace pileus::editor {

struct ScreenRect {
  vec2 min{0}, max{0};
};

struct Shown {
  explicit Shown(view::Renderer& theRenderer)
      : renderer(theRenderer), preview(&theRenderer), displayed(theRenderer.shaders()) {}

  view::Renderer& renderer;
  Preview preview;
  std::string activeView;                   ///< node chosen to be seen; "" or gone = the first one
  ViewSlots slots;                          ///< nodes the number keys show
  std::optional<scene::Camera> freeCamera;  ///< where no camera is linked; absent: pictures frame the volumes
  ivec2 renderSize{0};                      ///< what the panel asks the preview for
  LightView look;
  LookAround around;
  DisplayMode mode;
  Displayed displayed;
  CompareMode compare;
  Snapshots snapshots;
  LightMixer mixer;
  LightSwitches lights;
  RayPick ray;
  SceneCache scene;
  std::vector<ScreenRect> places;  ///< of the picture on the screen: more than one where halves are compared
};

}  // namespace pileus::editor
