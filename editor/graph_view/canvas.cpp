#include "editor/graph_view/canvas.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "editor/actions.h"
#include "editor/editor.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/graph_view/drag_feedback.h"
#include "editor/graph_view/draw_link.h"
#include "editor/graph_view/draw_node.h"
#include "editor/graph_view/hit_test.h"
#include "editor/graph_view/link_gestures.h"

namespace pileus::editor {
namespace {

CanvasView viewOf(const Editor& editor, ImDrawList* draw) {
  const Canvas& canvas = editor.canvas;
  CanvasView view;
  view.min = canvas.min;
  view.max = canvas.max;
  view.level = editor.theme.zoomLevels[static_cast<std::size_t>(canvas.level)];
  view.draw = draw;
  view.origin = glm::round(0.5f * (canvas.min + canvas.max) - vec2(canvas.center) * view.level.zoom);
  return view;
}

/// Centre and the largest level that shows `names` (all when empty).
void frame(Editor& editor, const Layout& layout, const std::set<std::string>& names) {
  Canvas& canvas = editor.canvas;
  vec2 lo, hi;
  canvas.level = editor.theme.defaultZoom;
  if (!bounds(layout, names, lo, hi)) {
    canvas.center = dvec2(0);
    return;
  }
  canvas.center = dvec2(0.5f * (lo + hi));
  const vec2 room = canvas.max - canvas.min - vec2(editor.theme.px(64), editor.theme.px(56));
  while (canvas.level > 0) {
    const float zoom = editor.theme.zoomLevels[static_cast<std::size_t>(canvas.level)].zoom;
    if ((hi.x - lo.x) * zoom <= room.x && (hi.y - lo.y) * zoom <= room.y) break;
    --canvas.level;
  }
}

void drawGrid(const Theme& theme, const CanvasView& view) {
  for (const auto& [step, color] :
       {std::pair{20.0f, palette::kGrid}, std::pair{100.0f, palette::kGridStrong}}) {
    const float pixels = step * view.level.zoom;
    if (pixels < 9 * theme.scale) continue;
    const vec2 first = view.min - vec2(std::fmod(view.min.x - view.origin.x, pixels),
                                       std::fmod(view.min.y - view.origin.y, pixels));
    for (float x = first.x - pixels; x < view.max.x; x += pixels)
      view.draw->AddLine({std::floor(x) + 0.5f, view.min.y}, {std::floor(x) + 0.5f, view.max.y}, color);
    for (float y = first.y - pixels; y < view.max.y; y += pixels)
      view.draw->AddLine({view.min.x, std::floor(y) + 0.5f}, {view.max.x, std::floor(y) + 0.5f}, color);
  }
}

PointerInput pointerInput(const Editor& editor, bool hovered, Hit hit) {
  const ImGuiIO& io = ImGui::GetIO();
  PointerInput in;
  in.pos = ImGui::IsMousePosValid() ? vec(io.MousePos) : editor.canvas.interaction.last;
  for (int i = 0; i < 3; ++i) {
    in.pressed[i] = ImGui::IsMouseClicked(i);
    in.released[i] = ImGui::IsMouseReleased(i);
  }
  in.doubleClick = ImGui::IsMouseDoubleClicked(0);
  in.shift = io.KeyShift;
  in.ctrl = io.KeyCtrl;
  in.alt = io.KeyAlt;
  in.knife = io.KeysDown[GLFW_KEY_Y];
  in.cancel = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  // The window lost the pointer without telling.
  if (editor.canvas.interaction.busy() && !ImGui::IsAnyMouseDown() && !in.released[0] && !in.released[1] &&
      !in.released[2])
    in.cancel = true;
  in.wheel = hovered ? io.MouseWheel : 0;
  in.over = hovered;
  in.hit = std::move(hit);
  return in;
}

void drawLinks(Editor& editor, const CanvasView& view, const Layout& layout, const Hit& hit) {
  const Canvas& canvas = editor.canvas;
  const bool dragging = canvas.interaction.state == Interaction::State::DraggingLink;
  for (const nodes::Link& link : shownGraph(editor).links) {
    if (dragging && isPickedUp(canvas.interaction.link, link)) continue;
    vec2 from, to;
    nodes::SocketType type;
    if (!linkEnds(layout, link, from, to, type)) continue;
    LinkLook look;
    look.selected = canvas.selectedLink == link || canvas.moving.onto == link;
    look.hovered = hit.kind == Hit::Kind::Link && hit.link == link && !dragging;
    look.muted = link.muted;
    look.dimmed = dragging;
    drawLink(editor.theme, view, from, to, socketColor(type), look);
  }
}

void drawNodes(Editor& editor, const CanvasView& view, const Layout& layout, const Hit& hit) {
  const Canvas& canvas = editor.canvas;
  const bool dragging = canvas.interaction.state == Interaction::State::DraggingLink;
  const std::vector<nodes::Link>& links = shownGraph(editor).links;
  for (const NodePlace& place : layout.nodes) {
    const bool underPointer =
        hit.kind != Hit::Kind::Link && hit.kind != Hit::Kind::Canvas && hit.node == place.name;
    NodeLook look;
    look.selected = editor.document.selection().contains(place.name);
    look.hovered = underPointer && hit.kind == Hit::Kind::Node && !dragging;
    look.showTimes = editor.settings.showTimes;
    look.status = &editor.preview.evaluator().status(place.name);
    if (underPointer && hit.kind != Hit::Kind::Node)
      look.hoveredSocket = hit.socket, look.hoveredInput = hit.kind == Hit::Kind::Input;
    if (dragging)
      look.accepts = [&](const SocketPlace& s) {
        return !canvas.refusals.contains(socketKey(place.name, s.id, s.input));
      };
    look.linked = [&](const SocketPlace& s) {
      return std::any_of(links.begin(), links.end(),
                         [&](const nodes::Link& l) { return l.toNode == place.name && l.toSocket == s.id; });
    };
    drawNode(editor.theme, view, place, look);
    editor.trace.rect("node/" + place.name, im(view.screen(place.min)), im(view.screen(place.max)));
    editor.trace.rect("header/" + place.name, im(view.screen(place.min)),
                      im(view.screen({place.max.x, place.min.y + place.header})));
    const float r = view.px(kSocketRadius);
    for (const SocketPlace& s : place.sockets)
      editor.trace.rect("socket/" + place.name + (s.input ? "/in/" : "/out/") + s.id,
                        im(view.screen(s.at) - r), im(view.screen(s.at) + r));
  }
}

void drawHints(const Editor& editor, const CanvasView& view) {
  if (!editor.document.graph().nodes.empty()) return;
  const Theme& theme = editor.theme;
  const vec2 middle = 0.5f * (view.min + view.max);
  const char* lines[] = {"This graph is empty", "Press Tab, or right-click, to add a node"};
  drawText(view.draw, theme.title,
           {middle.x - 0.5f * textWidth(theme.title, lines[0]), middle.y - theme.px(24)}, palette::kTextDim,
           lines[0], 1e4f);
  drawText(view.draw, theme.body, {middle.x - 0.5f * textWidth(theme.body, lines[1]), middle.y + theme.px(4)},
           palette::kTextFaint, lines[1], 1e4f);
}

/// What is wrong with the node under the resting pointer, or what it is.
void drawTooltip(Editor& editor, const Layout& layout, const Hit& hit, bool hovered) {
  if (!hovered || editor.canvas.interaction.busy() || hit.kind == Hit::Kind::Canvas ||
      hit.kind == Hit::Kind::Link)
    return;
  const NodePlace* place = findPlace(layout, hit.node);
  if (!place) return;
  const nodes::NodeStatus& status = editor.preview.evaluator().status(hit.node);
  std::string text;
  ImU32 ink = palette::kText;
  if (hit.kind != Hit::Kind::Node) {
    if (place->type)
      for (const nodes::SocketSpec& s :
           hit.kind == Hit::Kind::Input ? place->type->inputs : place->type->outputs)
        if (s.id == hit.socket)
          text = s.label + " (" +
                 std::string(nodes::enumInfo(
                                 static_cast<nodes::SocketType*>(nullptr))[static_cast<std::size_t>(s.type)]
                                 .label) +
                 (s.many ? ", takes many links)" : ")") + (s.help.empty() ? "" : "\n" + s.help);
  } else if (status.state == nodes::NodeState::Failed || status.state == nodes::NodeState::Skipped) {
    text = status.error.message;
    ink = status.state == nodes::NodeState::Failed ? palette::kError : palette::kTextDim;
  } else if (!status.warnings.empty() && status.state != nodes::NodeState::Idle) {
    for (const std::string& w : status.warnings) text += (text.empty() ? "" : "\n") + w;
    ink = palette::kWarning;
  } else if (!place->type) {
    text = "Unknown node type " + place->node->type + ": it is kept as it is and does nothing.";
    ink = palette::kWarning;
  }
  if (text.empty()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(editor.theme.px(380));
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  editor.trace.note("tooltip", text);
}

}  // namespace

std::string socketKey(std::string_view node, std::string_view socket, bool input) {
  return std::string(node) + (input ? "/in/" : "/out/") + std::string(socket);
}

void drawCanvas(Editor& editor, ImVec2 min, ImVec2 max, bool hovered) {
  Canvas& canvas = editor.canvas;
  canvas.min = vec(min);
  canvas.max = vec(max);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(min, max, true);
  draw->AddRectFilled(min, max, palette::kCanvas);

  Layout layout = layoutGraph(shownGraph(editor), editor.document.selection());
  if (canvas.level < 0 || canvas.frameAll)
    frame(editor, layout, {});
  else if (canvas.frameSelection)
    frame(editor, layout, editor.document.selection());
  canvas.frameAll = canvas.frameSelection = false;

  CanvasView view = viewOf(editor, draw);
  const bool active = hovered || canvas.interaction.busy();
  const vec2 pointer = view.canvas(vec(ImGui::GetIO().MousePos));
  Hit hit = active ? hitTest(layout, shownGraph(editor), pointer, view.level.zoom / editor.theme.scale,
                             canvas.interaction)
                   : Hit{};
  if (canvas.interaction.state == Interaction::State::DraggingLink) hit = snappedToNode(editor, layout, hit);
  canvas.pointer = pointer;
  canvas.pointerInside = hovered;
  const PointerInput in = pointerInput(editor, hovered, hit);
  const bool selected = editor.document.selection().contains(hit.node);
  const std::uint64_t revision = editor.document.revision();
  const bool moved = canvas.moving.active;
  for (const Command& c : step(canvas.interaction, in, selected, ImGui::GetIO().MouseDragThreshold))
    carryOut(editor, view, layout, c);
  if (editor.document.revision() != revision || moved || canvas.moving.active)
    layout = layoutGraph(shownGraph(editor), editor.document.selection());
  findDropLink(editor, layout);
  view = viewOf(editor, draw);

  drawGrid(editor.theme, view);
  drawLinks(editor, view, layout, hit);
  drawNodes(editor, view, layout, hit);
  drawDragFeedback(editor, view, layout, hit);
  drawHints(editor, view);
  draw->PopClipRect();
  drawTooltip(editor, layout, hit, hovered);
  editor.trace.rect("canvas", min, max);
}

}  // namespace pileus::editor
