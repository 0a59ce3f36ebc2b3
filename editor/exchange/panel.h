#pragma once
// The panels of the window by name.
namespace pileus::editor {

/// Panels that have keys of their own; Global ones work everywhere.
enum class Panel { Global, Viewport, Graph, Parameters, Scope, Lab, Log, Timeline };

}  // namespace pileus::editor
