#include "editor/timeline_view/timeline_panel.h"

#include <fmt/core.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/timeline_view/timeline_room.h"
#include "editor/timeline_view/timeline_rows.h"
#include "editor/timeline_view/timeline_state.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
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

bool button(Ui& ui, const Timeline& timeline, const char* id, Mark mark, const char* help) {
  const Theme& theme = ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetFrameHeight(), width = theme.px(30);
  const std::string trace = std::string("timeline/") + id;
  const bool pressed = ImGui::InvisibleButton(trace.c_str(), {width, size});
  ui.trace.item(trace);
  const bool over = ImGui::IsItemHovered();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (over) draw->AddRectFilled(at, {at.x + width, at.y + size}, palette::kButtonHover, theme.px(4));
  drawMark(theme, draw, {at.x + 0.5f * width, at.y + 0.5f * size}, mark,
           over ? palette::kTextStrong : palette::kText);
  if (over && timeline.rest.short_) tooltip(theme, help);
  ImGui::SameLine(0, theme.px(2));
  return pressed;
}

void transport(const TimelineRoom& room) {
  if (button(room.ui, room.timeline, "to start", Mark::Start, "To the first frame (Home)"))
    goToEnd(room.session, room.clock, -1);
  if (button(room.ui, room.timeline, "previous key", Mark::PreviousKey, "To the previous key (Shift+,)"))
    goToKey(room.ui.messages, room.session, room.clock, -1);
  const bool playing = room.clock.play.playing();
  if (button(room.ui, room.timeline, "play", playing ? Mark::Pause : Mark::Play,
             playing ? "Stop (K)" : "Play forward (L), backward (J)"))
    togglePlay(room.ui.messages, room.ui.requests, room.session, room.clock);
  if (button(room.ui, room.timeline, "next key", Mark::NextKey, "To the next key (Shift+.)"))
    goToKey(room.ui.messages, room.session, room.clock, 1);
  if (button(room.ui, room.timeline, "to end", Mark::End, "To the last frame (End)"))
    goToEnd(room.session, room.clock, 1);
}

/// A label and a number after it; the cursor stays on the line. Nothing where it would end beyond `right`.
NumberEdit labelled(Ui& ui, const Timeline& timeline, float right, const char* id, const char* label,
                    double& value, const NumberField& field, float width, const char* help) {
  const Theme& theme = ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float name = textWidth(theme.small, label);
  if (at.x + name + theme.space(1.5f) + theme.px(width) > right) return {};
  drawText(ImGui::GetWindowDrawList(), theme.small,
           {at.x, at.y + 0.5f * (ImGui::GetFrameHeight() - theme.small->FontSize)}, palette::kTextDim, label,
           name + 1);
  ImGui::SetCursorScreenPos({at.x + name + theme.space(1.5f), at.y});
  const std::string trace = std::string("timeline/") + id;
  const NumberEdit edit = numberField(ui.fields.number, theme, trace.c_str(), value, field, theme.px(width));
  ui.trace.item(trace);
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive() && timeline.rest.long_) tooltip(theme, help);
  ImGui::SetCursorScreenPos({at.x + name + theme.space(1.5f) + theme.px(width) + theme.space(3), at.y});
  return edit;
}

/// Steps of one drag are one; Esc gives back what was there.
void applySetting(Ui& ui, Session& session, Timeline& timeline, const NumberEdit& edit,
                  Result<nodes::Graph> graph, const char* label) {
  std::optional<nodes::Settings>& before = timeline.settingsBefore;
  if (edit.dragging && !before) before = session.document.graph().settings;
  if (edit.changed) tryEdit(session, ui.messages, std::move(graph), label, edit.dragging ? label : "");
  if (edit.cancelled && before) {
    nodes::Graph old = session.document.graph();
    old.settings = *before;
    tryEdit(session, ui.messages, std::move(old), label, label);
  }
  if (edit.finished) before.reset(), session.document.endMerge();
}

NumberField frameField() {
  NumberField field;
  field.integer = true;
  field.hardMin = -1e6, field.hardMax = 1e6;
  return field;
}

/// As many as there is room for; the document's panel has all of them.
void fields(const TimelineRoom& room, float right) {
  const nodes::Graph& graph = room.session.document.graph();
  const ivec2 range = graph.settings.frames;
  double frame = room.clock.frame;
  if (labelled(room.ui, room.timeline, right, "frame", "Frame", frame, frameField(), 66,
               "The current frame (, and . step)")
          .changed)
    goToFrame(room.clock, static_cast<int>(frame));
  double first = range.x;
  const NumberEdit start = labelled(room.ui, room.timeline, right, "start", "First", first, frameField(), 66,
                                    "First frame of the range");
  const int x = static_cast<int>(first);
  applySetting(room.ui, room.session, room.timeline, start,
               nodes::setFrameRange(graph, {x, std::max(x, range.y)}), "Set first frame");
  double last = range.y;
  const NumberEdit end = labelled(room.ui, room.timeline, right, "end", "Last", last, frameField(), 66,
                                  "Last frame of the range");
  const int y = static_cast<int>(last);
  applySetting(room.ui, room.session, room.timeline, end,
               nodes::setFrameRange(room.session.document.graph(), {std::min(range.x, y), y}),
               "Set last frame");
  double fps = graph.settings.fps;
  NumberField speed;
  speed.softMin = 1, speed.softMax = 120, speed.hardMin = 0.01, speed.hardMax = 1000;
  speed.unit = "fps";
  const NumberEdit rate =
      labelled(room.ui, room.timeline, right, "fps", "Speed", fps, speed, 84, "Frames a second");
  applySetting(room.ui, room.session, room.timeline, rate, nodes::setFps(room.session.document.graph(), fps),
               "Set frame rate");
}

}  // namespace

void drawTimeline(const TimelineRoom& room, ImVec2 min, ImVec2 max) {
  const Theme& theme = room.ui.theme;
  const float bar = theme.px(36);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  updateRest(room.timeline.rest, min, max);
  draw->AddRectFilled(min, max, palette::kPanel);
  draw->AddRectFilled(min, {max.x, min.y + bar}, palette::kBar);
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + 0.5f * (bar - ImGui::GetFrameHeight())});
  transport(room);
  ImGui::SameLine(0, theme.space(4));
  fields(room, max.x - bar - theme.space(2));
  ImGui::SetCursorScreenPos({max.x - bar, min.y});
  if (ImGui::InvisibleButton("timeline close", {bar, bar})) room.settings.showTimeline = false;
  room.ui.trace.item("timeline/close");
  drawText(draw, theme.small,
           {max.x - 0.5f * (bar + textWidth(theme.small, icon::kTimes)),
            min.y + 0.5f * (bar - theme.small->FontSize)},
           ImGui::IsItemHovered() ? palette::kText : palette::kTextDim, icon::kTimes, bar);
  drawTimelineRows(room, {min.x, min.y + bar}, max);
  room.ui.trace.rect("timeline", min, max);
}

}  // namespace pileus::editor
