#include "editor/graph_view/frames.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/toolkit/ui.h"
#include "nodes/graph/graph_frames.h"

namespace pileus::editor {
namespace {

constexpr double kSmallest = 80;  // canvas units
constexpr char kPopup[] = "##frame title";

std::string named(const char* verb, const nodes::Frame& frame) {
  return std::string(verb) + " frame" + (frame.title.empty() ? "" : " " + frame.title);
}

}  // namespace

float frameHeader(float zoom) { return std::max(30.0f, 22.0f / std::max(zoom, 0.01f)); }

std::optional<Hit> frameAt(const nodes::Graph& graph, vec2 at, float zoom) {
  const float reach = std::clamp(6.0f / zoom, 4.0f, 40.0f);
  for (std::size_t i = graph.frames.size(); i-- > 0;) {
    const nodes::Frame& frame = graph.frames[i];
    const vec2 lo = vec2(frame.at), hi = vec2(frame.at + frame.size);
    if (at.x < lo.x - reach || at.x > hi.x + reach || at.y < lo.y - reach || at.y > hi.y + reach) continue;
    Hit hit;
    hit.kind = Hit::Kind::Frame;
    hit.frame = i;
    hit.sides = {std::abs(at.x - lo.x) <= reach, std::abs(at.y - lo.y) <= reach,
                 std::abs(at.x - hi.x) <= reach, std::abs(at.y - hi.y) <= reach};
    if (hit.sides.any() || at.y <= lo.y + frameHeader(zoom)) return hit;
  }
  return std::nullopt;
}

nodes::Frame resized(const nodes::Frame& frame, const FrameSides& sides, dvec2 by) {
  dvec2 lo = frame.at, hi = frame.at + frame.size;
  if (sides.left) lo.x = std::min(lo.x + by.x, hi.x - kSmallest);
  if (sides.top) lo.y = std::min(lo.y + by.y, hi.y - kSmallest);
  if (sides.right) hi.x = std::max(hi.x + by.x, lo.x + kSmallest);
  if (sides.bottom) hi.y = std::max(hi.y + by.y, lo.y + kSmallest);
  nodes::Frame result = frame;
  result.at = lo;
  result.size = hi - lo;
  return result;
}

void addFrame(Ui& ui, Session& session, Canvas& canvas) {
  const nodes::Graph& graph = session.document.graph();
  const std::set<std::string>& names = session.document.selection();
  nodes::Graph framed;
  if (names.empty()) {
    const dvec2 size = {320, 220};
    const dvec2 middle = canvas.pointerInside ? dvec2(canvas.pointer) : canvas.center;
    nodes::Frame frame;
    frame.title = "Frame";
    frame.at = glm::round(middle - 0.5 * size);
    frame.size = size;
    framed = nodes::addFrame(graph, frame);
  } else {
    framed = nodes::frameAround(graph, names, "Frame");
  }
  // The new frame is the one that was not there; where it stands in the list is the model's choice.
  std::size_t added = 0;
  while (added < graph.frames.size() && framed.frames[added] == graph.frames[added]) ++added;
  if (!tryEdit(session, ui.messages, std::move(framed), "Add frame")) return;
  session.selectedLink.reset();
  canvas.selectedFrame = added;
  renameFrame(session, canvas, added);
}

void setFrameColor(Ui& ui, Session& session, std::size_t index, const std::string& color) {
  const nodes::Graph& graph = session.document.graph();
  if (index >= graph.frames.size()) return;
  nodes::Frame frame = graph.frames[index];
  frame.color = color;
  tryEdit(session, ui.messages, nodes::setFrame(graph, index, frame), named("Colour", frame));
}

void removeFrame(Ui& ui, Session& session, Canvas& canvas, std::size_t index) {
  const nodes::Graph& graph = session.document.graph();
  canvas.selectedFrame.reset();
  if (index < graph.frames.size())
    tryEdit(session, ui.messages, nodes::removeFrame(graph, index), named("Remove", graph.frames[index]));
}

void renameFrame(const Session& session, Canvas& canvas, std::size_t index) {
  const nodes::Graph& graph = session.document.graph();
  if (index >= graph.frames.size()) return;
  canvas.frameTitle = FrameTitleField{index, graph.frames[index].title, true};
}

void selectContent(Session& session, Canvas& canvas, std::size_t index) {
  if (index >= session.document.graph().frames.size()) return;
  session.document.select(nodes::contentOf(session.document.graph(), index).nodes);
  canvas.selectedFrame.reset();
}

void drawFrameTitleField(Ui& ui, Session& session, Canvas& canvas) {
  std::optional<FrameTitleField>& field = canvas.frameTitle;
  if (!field) return;
  const nodes::Graph& graph = session.document.graph();
  if (field->frame >= graph.frames.size()) return field.reset();
  nodes::Frame frame = graph.frames[field->frame];
  const CanvasView view = canvasView(ui.theme, canvas);
  const vec2 at = glm::clamp(view.screen(vec2(frame.at)), view.min,
                             glm::max(view.max - vec2(ui.theme.px(240), ui.theme.px(40)), view.min));
  if (field->opening) {
    ImGui::OpenPopup(kPopup);
    ImGui::SetNextWindowPos(im(at));
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.theme.px(3), ui.theme.px(3)});
  const bool open = ImGui::BeginPopup(kPopup, ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar();
  if (!open) return field.reset();
  if (std::exchange(field->opening, false)) ui.fields.focusHere();
  ImGui::SetNextItemWidth(ui.theme.px(230));
  const bool done = ImGui::InputText(
      "##title", &field->text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui.trace.item("frame title");
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    field->text = frame.title;
    ImGui::CloseCurrentPopup();
  }
  // Left in any way, it keeps what was typed, before anything else happens.
  if (done || ImGui::IsItemDeactivated()) {
    if (field->text != frame.title) {
      frame.title = field->text;
      tryEdit(session, ui.messages, nodes::setFrame(graph, field->frame, frame), "Rename frame");
    }
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
