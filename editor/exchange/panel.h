#pragma once
// The panels of the window by name.
#include <cstddef>

namespace pileus::editor {

/// Panels that have keys of their own; Global ones work everywhere.
enum class Panel { Global, Viewport, Graph, Parameters, Scope, Lab, Log, Timeline, Lights };
inline constexpr std::size_t kPanelValues = static_cast<std::size_t>(Panel::Lights) + 1;

}  // namespace pileus::editor
