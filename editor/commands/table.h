#pragma once
// The parts of the table of commands, one file each, in the order of the menus, and what they are written
// with.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "editor/commands/actions.h"
#include "editor/editor.h"

namespace pileus::editor {

constexpr Shortcut ctrl(int key) { return {key, true, false, false}; }
constexpr Shortcut shift(int key) { return {key, false, true, false}; }
constexpr Shortcut alt(int key) { return {key, false, false, true}; }
constexpr Shortcut ctrlShift(int key) { return {key, true, true, false}; }
constexpr Shortcut plain(int key) { return {key, false, false, false}; }

std::span<const Action> fileActions();
std::span<const Action> presetActions();
std::span<const Action> editActions();
std::span<const Action> graphActions();
std::span<const Action> lookActions();
std::span<const Action> numberedActions();
std::span<const Action> viewportActions();
std::span<const Action> cameraActions();
std::span<const Action> displayActions();
std::span<const Action> parameterActions();
std::span<const Action> lightActions();
std::span<const Action> timelineActions();
std::span<const Action> windowActions();
std::span<const Action> viewActions();
std::span<const Action> helpActions();

}  // namespace pileus::editor
