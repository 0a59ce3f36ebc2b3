#pragma once
// What hangs below a node: the error it made, the node it waits for, a warning, progress, and its costs.
#include <string>

#include "editor/graph_view/draw_node.h"

namespace pileus::editor {

struct Canvas;
struct Session;
struct Shown;
struct Theme;

enum class FooterKind { None, Failed, Follower, Warning, Working };
FooterKind footerKind(const nodes::NodeStatus& status);

/// In pixels; an empty one where nothing is shown.
struct FooterRect {
  vec2 min{0}, max{0};
  bool contains(vec2 p) const { return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y; }
};
/// A fault or a warning that does not fit into a line takes up to three.
FooterRect footerRect(const CanvasView& view, const NodePlace& place, const nodes::NodeStatus& status);

void drawFooter(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look);
/// Time and memory, at the right below the node.
void drawCosts(const Theme& theme, const CanvasView& view, const NodePlace& place, const NodeLook& look);

/// The node whose failure keeps `node` from being made: the nearest one upstream; "" = none failed.
std::string sourceOfError(const Session& session, const Shown& shown, const Canvas& canvas,
                          const Layout& layout, const std::string& node);

}  // namespace pileus::editor
