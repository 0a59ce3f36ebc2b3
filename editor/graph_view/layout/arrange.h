#pragma once
// Tidying nodes: layers of a graph, aligning and distributing. Pure geometry of boxes, in canvas units; every
// function returns new top-left corners, one for each box.
#include <vector>

#include "renderer/base/math.h"

namespace pileus::editor {

struct Box {
  dvec2 at{0}, size{0};
  bool operator==(const Box&) const = default;
};

/// A link between boxes, with the heights of its sockets below the boxes' tops.
struct BoxLink {
  int from = 0, to = 0;
  double fromY = 0, toY = 0;
};

/// Space left between the boxes of one layer, and between layers.
inline constexpr double kRowGap = 26, kLayerGap = 84;

/// Links run from left to right: the last nodes stand in the rightmost layer, every other one just left of
/// the first that needs it. Crossings are few, heights compact, and the middle of all boxes stays where it
/// is. What is arranged already comes back as it was. Links of a cycle that lead back are left out of
/// account.
std::vector<dvec2> arranged(const std::vector<Box>& boxes, const std::vector<BoxLink>& links);
/// Links that cross between neighbouring layers, in an arrangement: how good it is.
int crossingsOf(const std::vector<Box>& boxes, const std::vector<BoxLink>& links);

enum class Align { Left, Right, Top, Bottom, CenterX, CenterY };
std::vector<dvec2> aligned(const std::vector<Box>& boxes, Align how);
/// Equal gaps between neighbours; the outermost boxes stay. Fewer than three stay as they are.
std::vector<dvec2> distributed(const std::vector<Box>& boxes, bool horizontal);

}  // namespace pileus::editor
