#pragma once
// How a medium spreads what it scatters, as a figure below its parameters.
#include <string>

namespace pileus::editor {

struct ParameterRoom;

/// The phase function of what the node gives out: distance from the middle is its logarithm, light comes from
/// the left. Nothing where the node was not evaluated yet or gives out no medium.
void drawPhasePlot(const ParameterRoom& room, const std::string& name);

}  // namespace pileus::editor
