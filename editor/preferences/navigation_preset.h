#pragma once
// Which buttons move the camera, by the habits of three programs.
#include <array>

#include "renderer/base/enum_info.h"

namespace pileus::editor {

enum class NavigationPreset { Maya, Blender, Houdini };
constexpr auto enumInfo(NavigationPreset*) {
  using T = NavigationPreset;
  return std::array{
      EnumItem<T>{T::Maya, "maya", "Maya",
                  "Alt with the left, middle or right button orbits, pans or dollies."},
      EnumItem<T>{T::Blender, "blender", "Blender",
                  "The middle button orbits, with Shift it pans, with Ctrl it dollies."},
      EnumItem<T>{T::Houdini, "houdini", "Houdini",
                  "Space or Alt with the left, middle or right button orbits, pans or dollies."}};
}

enum class CameraMove { None, Orbit, Pan, Dolly };

/// What is held while a button goes down; buttons as in ImGui: 0 left, 1 right, 2 middle.
struct NavigationInput {
  int button = 0;
  bool shift = false, ctrl = false, alt = false, space = false;
};

struct NavigationChoice {
  CameraMove move = CameraMove::None;
  bool plain = false;      ///< a press without a key: gizmos and picking come before it
  bool usesShift = false;  ///< Shift is part of the gesture and does not make it fine
};

/// Plain drags move the camera in every preset.
NavigationChoice navigationMove(NavigationPreset preset, const NavigationInput& input);
}  // namespace pileus::editor
