#include "editor/timeline_view/timeline_panel.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/time/playback.h"
#include "editor/timeline_view/timeline_rows.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/widgets.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::editor {
namespace {

enum class Mark { Start, PreviousKey, Play, Pause, NextKey, End };

void triangle(ImDrawList* draw, ImVec2 tip, float size, ImU32 ink) {
  const float half = 0.62f * std::abs(size);
  // Clockwise for either side: the edges are smooth only then.
  if (size > 0)
    draw->AddTriangleFilled({tip.x - size, tip.y - half}, tip, {tip.x - size, tip.y + half}, ink);
  else
    draw->AddTriangleFilled(tip, {tip.x - size, tip.y - half}, {tip.x - size, tip.y + half}, ink);
}

void drawMark(const Theme& theme, ImDrawList* draw, ImVec2 c, Mark mark, ImU32 ink) {
  const float s = theme.px(5), thin = theme.px(2), d = theme.px(4);
  const auto bar = [&](float x) { draw->AddRectFilled({x, c.y - s}, {x + thin, c.y + s}, ink); };
  const auto diamond = [&](float x) {
    draw->AddQuadFilled({x, c.y - d}, {x + d, c.y}, {x, c.y + d}, {x - d, c.y}, ink);
  };
  switch (mark) {
    case Mark::Start:
      bar(c.x - s - thin);
      return triangle(draw, {c.x - s, c.y}, -1.6f * s, ink);
    case Mark::End:
      bar(c.x + s);
      return triangle(draw, {c.x + s, c.y}, 1.6f * s, ink);
    case Mark::PreviousKey:
      diamond(c.x + d);
      return triangle(draw, {c.x - s - thin, c.y}, -s, ink);
    case Mark::NextKey:
      diamond(c.x - d);
      return triangle(draw, {c.x + s + thin, c.y}, s, ink);
    case Mark::Play:
      return triangle(draw, {c.x + s, c.y}, 1.9f * s, ink);
    case Mark::Pause:
      draw->AddRectFilled({c.x - s, c.y - s}, {c.x - 0.3f * s, c.y + s}, ink);
      return draw->AddRectFilled({c.x + 0.3f * s, c.y - s}, {c.x + s, c.y + s}, ink);
  }
}

bool button(Editor& editor, const char* id, Mark mark, const char* help) {
  const Theme& theme = editor.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetFrameHeight(), width = theme.px(30);
  const std::string trace = std::string("timeline/") + id;
  const bool pressed = ImGui::InvisibleButton(trace.c_str(), {width, size});
  editor.trace.item(trace);
  const bool over = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (over) draw->AddRectFilled(at, {at.x + width, at.y + size}, palette::kButtonHover, theme.px(4));
  drawMark(theme, draw, {at.x + 0.5f * width, at.y + 0.5f * size}, mark,
           over ? palette::kTextStrong : palette::kText);
  if (over && editor.timeline.rest.short_) tooltip(theme, help);
  ImGui::SameLine(0, theme.px(2));
  return pressed;
}

void transport(Editor& editor) {
  if (button(editor, "to start", Mark::Start, "To the start of the range (Home)")) goToEnd(editor, -1);
  if (button(editor, "previous key", Mark::PreviousKey, "To the previous key (Shift+,)")) goToKey(editor, -1);
  const bool playing = editor.timeline.clock.playing();
  if (button(editor, "play", playing ? Mark::Pause : Mark::Play,
             playing ? "Stop (K)" : "Play forward (L), backward (J)"))
    togglePlay(editor);
  if (button(editor, "next key", Mark::NextKey, "To the next key (Shift+.)")) goToKey(editor, 1);
  if (button(editor, "to end", Mark::End, "To the end of the range (End)")) goToEnd(editor, 1);
}

/// A label and a number after it; the cursor stays on the line.
NumberEdit labelled(Editor& editor, const char* id, const char* label, double& value,
                    const NumberField& field, float width, const char* help) {
  const Theme& theme = editor.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float name = textWidth(theme.small, label);
  drawText(ImGui::GetWindowDrawList(), theme.small,
           {at.x, at.y + 0.5f * (ImGui::GetFrameHeight() - theme.small->FontSize)}, palette::kTextDim, label,
           name + 1);
  ImGui::SetCursorScreenPos({at.x + name + theme.space(1.5f), at.y});
  const std::string trace = std::string("timeline/") + id;
  const NumberEdit edit =
      numberField(editor.timeline.numbers, theme, trace.c_str(), value, field, theme.px(width));
  editor.trace.item(trace);
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive() && editor.timeline.rest.long_) tooltip(theme, help);
  ImGui::SetCursorScreenPos({at.x + name + theme.space(1.5f) + theme.px(width) + theme.space(3), at.y});
  return edit;
}

/// Steps of one drag are one; Esc gives back what was there.
void applySetting(Editor& editor, const NumberEdit& edit, Result<nodes::Graph> graph, const char* label) {
  std::optional<nodes::Settings>& before = editor.parameters.settingsBefore;
  if (edit.dragging && !before) before = editor.document.graph().settings;
  if (edit.changed) tryEdit(editor, std::move(graph), label, edit.dragging ? label : "");
  if (edit.cancelled && before) {
    nodes::Graph old = editor.document.graph();
    old.settings = *before;
    tryEdit(editor, std::move(old), label, label);
  }
  if (edit.finished) before.reset(), editor.document.endMerge();
}

NumberField frameField() {
  NumberField field;
  field.integer = true;
  field.hardMin = -1e6, field.hardMax = 1e6;
  return field;
}

void fields(Editor& editor) {
  const nodes::Graph& graph = editor.document.graph();
  const ivec2 range = graph.settings.frames;
  double frame = editor.frame;
  if (labelled(editor, "frame", "Frame", frame, frameField(), 66, "The current frame (, and . step)").changed)
    goToFrame(editor, static_cast<int>(frame));
  double first = range.x;
  const NumberEdit start =
      labelled(editor, "start", "Start", first, frameField(), 66, "First frame of the range");
  const int x = static_cast<int>(first);
  applySetting(editor, start, nodes::setFrameRange(graph, {x, std::max(x, range.y)}), "Set first frame");
  double last = range.y;
  const NumberEdit end = labelled(editor, "end", "End", last, frameField(), 66, "Last frame of the range");
  const int y = static_cast<int>(last);
  applySetting(editor, end, nodes::setFrameRange(editor.document.graph(), {std::min(range.x, y), y}),
               "Set last frame");
  double fps = graph.settings.fps;
  NumberField speed;
  speed.softMin = 1, speed.softMax = 120, speed.hardMin = 0.01, speed.hardMax = 1000;
  speed.unit = "fps";
  const NumberEdit rate = labelled(editor, "fps", "Speed", fps, speed, 84, "Frames a second");
  applySetting(editor, rate, nodes::setFps(editor.document.graph(), fps), "Set frame rate");
}

}  // namespace

void drawTimeline(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  const float bar = theme.px(36);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  updateRest(editor.timeline.rest, min, max);
  draw->AddRectFilled(min, max, palette::kPanel);
  draw->AddRectFilled(min, {max.x, min.y + bar}, palette::kBar);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + 0.5f * (bar - ImGui::GetFrameHeight())});
  transport(editor);
  ImGui::SameLine(0, theme.space(4));
  fields(editor);
  ImGui::SetCursorScreenPos({max.x - bar, min.y});
  if (ImGui::InvisibleButton("timeline close", {bar, bar})) editor.settings.showTimeline = false;
  editor.trace.item("timeline/close");
  drawText(draw, theme.small,
           {max.x - 0.5f * (bar + textWidth(theme.small, icon::kTimes)),
            min.y + 0.5f * (bar - theme.small->FontSize)},
           ImGui::IsItemHovered() ? palette::kText : palette::kTextDim, icon::kTimes, bar);
  drawTimelineRows(editor, {min.x, min.y + bar}, max);
  editor.trace.rect("timeline", min, max);
}

}  // namespace pileus::editor
