#include "editor/viewport/navigation_preset.h"

namespace pileus::editor {
namespace {

constexpr CameraMove kByButton[] = {CameraMove::Orbit, CameraMove::Dolly, CameraMove::Pan};

}  // namespace

NavigationChoice navigationMove(NavigationPreset preset, const NavigationInput& in) {
  if (in.button < 0 || in.button > 2) return {};
  const bool held = in.alt || (preset == NavigationPreset::Houdini && in.space);
  if (held) return {kByButton[in.button], false, false};
  if (preset == NavigationPreset::Blender && in.button == 2) {
    if (in.shift) return {CameraMove::Pan, false, true};
    return {in.ctrl ? CameraMove::Dolly : CameraMove::Orbit, false, false};
  }
  return {kByButton[in.button], true, false};
}

const char* navigationKeys(NavigationPreset preset, CameraMove move) {
  const bool blender = preset == NavigationPreset::Blender, houdini = preset == NavigationPreset::Houdini;
  switch (move) {
    case CameraMove::Orbit:
      return blender ? "Middle drag, drag" : houdini ? "Space or Alt+drag, drag" : "Alt+drag, drag";
    case CameraMove::Pan:
      return blender   ? "Shift+middle drag"
             : houdini ? "Space or Alt+middle drag, middle drag"
                       : "Alt+middle drag, middle drag";
    case CameraMove::Dolly:
      return blender   ? "Wheel, Ctrl+middle drag, right drag"
             : houdini ? "Wheel, Space or Alt+right drag, right drag"
                       : "Wheel, Alt+right drag, right drag";
    case CameraMove::None:
      break;
  }
  return "";
}

}  // namespace pileus::editor
