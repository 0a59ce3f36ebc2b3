#include "editor/preferences/navigation_preset.h"

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

}  // namespace pileus::editor
