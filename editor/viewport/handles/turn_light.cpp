#include "editor/viewport/handles/turn_light.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <vector>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/picture/view_scene.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/handles/gizmo_tool.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

constexpr const char* kMergeKey = "turn light";
constexpr double kStep = 0.1, kSnap = 15;  // degrees

/// Its angle about the vertical; null: it is no light from everywhere.
const char* angleOf(const std::string& type) {
  return type == "light.environment" ? "rotation" : type == "light.sky" ? "azimuth" : nullptr;
}

/// Paths of all light from everywhere in a group.
void collect(const nodes::Graph& graph, const std::string& prefix, std::vector<std::string>& out) {
  for (const auto& [name, node] : graph.nodes)
    if (node->group)
      collect(*node->group, prefix + name + "/", out);
    else if (angleOf(node->type))
      out.push_back(prefix + name);
}

std::string chosen(const Session& session, const std::string& inside) {
  const std::string name = onlySelected(session);
  if (name.empty()) return {};
  const std::string path = session.document.scopedName(name);
  const nodes::Graph* group = nodes::groupGraph(session.document.graph(), name);
  if (!group) return path;
  if (inside.starts_with(path + "/")) return inside;
  std::vector<std::string> all;
  collect(*group, path + "/", all);
  return all.size() == 1 ? all.front() : std::string();
}

/// Between half a turn to either side, where no keys lead there.
double wrapped(double degrees) { return degrees - 360 * std::round(degrees / 360); }

}  // namespace

std::optional<TurnDrag> turnable(const Session& session, const Clock& clock, const std::string& inside) {
  const nodes::Graph& root = session.document.root();
  const std::string path = chosen(session, inside);
  const nodes::Node* node = path.empty() ? nullptr : nodes::findNodeAt(root, path);
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const char* param = type ? angleOf(node->type) : nullptr;
  const nodes::ParamSpec* spec = param ? type->param(param) : nullptr;
  if (!spec || node->bypass || node->disabled || !nodes::sourcesOf(root, path, param).empty()) return {};
  const nodes::ParamValue value = nodes::paramValue(*node, *spec, clock.frame);
  const double* angle = std::get_if<double>(&value);
  if (!angle) return {};
  return TurnDrag{path, param, *angle, 0, {}, {}};
}

void hintAtTurn(const ViewportRoom& room) {
  ViewportTools& tools = room.viewport.tools;
  const auto turn = turnable(room.session, room.clock, tools.inside);
  if (!turn) return void(tools.turnHint.clear());
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (std::exchange(tools.turnHint, turn->node) == turn->node) return;
  room.ui.messages.note("A drag sideways turns " + turn->node +
                        " (Shift: fine, Ctrl: by 15 degrees); Alt+drag orbits.");
}

bool beginTurn(const ViewportRoom& room) {
  ViewportTools& tools = room.viewport.tools;
  tools.turn = turnable(room.session, room.clock, tools.inside);
  if (!tools.turn) return false;
  holdFrame(room.clock, *nodes::findNodeAt(room.session.document.root(), tools.turn->node));
  room.session.document.endMerge();
  tools.turn->before = room.session.document.root();
  return true;
}

void continueTurn(const ViewportRoom& room, double degrees, bool snap) {
  TurnDrag& turn = *room.viewport.tools.turn;
  turn.turned += degrees;
  const double step = snap ? kSnap : kStep;
  double angle = std::round((turn.start + turn.turned) / step) * step;
  const nodes::Node* node = nodes::findNodeAt(room.session.document.root(), turn.node);
  if (!node) return;
  if (!node->animated.contains(turn.param)) angle = wrapped(angle);
  angle = std::round(10 * angle) / 10;
  turn.readout = fmt::format("{:.1f}\xc2\xb0", angle);
  tryEditRoot(room.session, room.ui.messages,
              nodes::setParamAt(room.session.document.root(), turn.node, turn.param, angle, room.clock.frame),
              "Turn " + turn.node, kMergeKey);
  room.shown.preview.touch();
}

void drawTurn(const ViewportRoom& room) {
  const auto& turn = room.viewport.tools.turn;
  if (!turn || turn->readout.empty()) return;
  drawReadout(room.ui.theme, vec(ImGui::GetIO().MousePos), turn->readout);
  room.ui.trace.note("turn readout", turn->readout);
}

void endTurn(Session& session, Viewport& viewport) {
  viewport.tools.turn.reset();
  session.document.endMerge();
}

void cancelTurn(Session& session, Viewport& viewport) {
  std::optional<TurnDrag>& turn = viewport.tools.turn;
  if (!turn) return;
  if (!turn->readout.empty()) session.document.editRoot(std::move(turn->before), "", kMergeKey);
  viewport.drag = Viewport::Drag::None;
  viewport.tools.maybeClick = false;
  endTurn(session, viewport);
}

}  // namespace pileus::editor
