#include "editor/status/status_line.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "editor/document/session.h"
#include "editor/picture/exporter.h"
#include "editor/picture/shown.h"
#include "editor/status/log_panel.h"
#include "editor/status/status_room.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "renderer/view/picture.h"

namespace pileus::editor {
namespace {

struct NodeTime {
  std::string name;
  double cpuMs = 0, gpuMs = 0;
};

std::vector<NodeTime> nodeTimes(const Session& session, const Shown& shown) {
  std::vector<NodeTime> times;
  for (const auto& [name, node] : session.document.root().nodes) {
    const nodes::NodeStatus& s = shown.preview.evaluator().status(name);
    if (s.state != nodes::NodeState::Idle && s.cpuMs + s.gpuMs >= 0.05)
      times.push_back({name, s.cpuMs, s.gpuMs});
  }
  std::sort(times.begin(), times.end(),
            [](const NodeTime& a, const NodeTime& b) { return a.cpuMs + a.gpuMs > b.cpuMs + b.gpuMs; });
  return times;
}

std::string ms(double value) {
  return value < 9.95     ? fmt::format("{:.1f} ms", value)
         : value < 9999.5 ? fmt::format("{:.0f} ms", value)
                          : fmt::format("{:.1f} s", value / 1000);
}

std::string pictureText(const Shown& shown) {
  const auto& picture = shown.preview.picture();
  if (!picture) return {};
  std::string text = fmt::format("{} \xc3\x97 {}", picture->size.x, picture->size.y);
  if (picture->samples > 0)
    text += fmt::format(", {} sample{}", picture->samples, picture->samples == 1 ? "" : "s");
  return text;
}

/// Only what is not as it should be: pictures that come slower than the document asks for.
std::string playText(const Session& session, const Clock& clock) {
  const PlayClock& play = clock.play;
  const double wanted = session.document.root().settings.fps;
  const double reached = reachedFps(clock);
  if (!play.playing() || reached > 0.9 * wanted) return {};
  return fmt::format("Plays {:.0f} of {:g} fps   ", reached, wanted);
}

void drawExport(Ui& ui, Exporter& exporter, ImVec2 min, ImVec2 max) {
  const Theme& theme = ui.theme;
  const std::string text =
      fmt::format("Exporting {} {:.0f} %", exporter.target().filename().string(), 100 * exporter.fraction());
  ImGui::SetCursorScreenPos({min.x + theme.space(2), min.y + theme.px(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme.space(2), theme.px(2)});
  if (ImGui::Button("Cancel export")) {
    exporter.cancel();
    ui.messages.info("Export cancelled.");
  }
  ui.trace.item("export/cancel");
  ImGui::PopStyleVar();
  const float x = ImGui::GetItemRectMax().x + theme.space(3), y = 0.5f * (min.y + max.y);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float bar = theme.px(120);
  draw->AddRectFilled({x, y - theme.px(3)}, {x + bar, y + theme.px(3)}, palette::kField, theme.px(3));
  const auto t = static_cast<float>(std::clamp(exporter.active() ? exporter.fraction() : 0.0, 0.0, 1.0));
  draw->AddRectFilled({x, y - theme.px(3)}, {x + bar * t, y + theme.px(3)}, palette::kAccent, theme.px(3));
  drawText(draw, theme.small, {x + bar + theme.space(2), y - 0.5f * theme.small->FontSize}, palette::kText,
           text, max.x - x - bar);
}

/// Warnings and errors since the log was cleared; a click shows them. Returns where it ends.
float drawCounts(Ui& ui, LogPanel& logPanel, ImVec2 min, ImVec2 max) {
  const Theme& theme = ui.theme;
  struct Count {
    log::Level level;
    const char* mark;
    ImU32 ink;
    const char* trace;
  };
  float x = min.x + theme.space(2);
  for (const Count& c : {Count{log::Level::Error, icon::kError, palette::kError, "status/errors"},
                         Count{log::Level::Warning, icon::kWarning, palette::kWarning, "status/warnings"}}) {
    const std::size_t n = logPanel.count(c.level);
    if (n == 0) continue;
    const std::string text = fmt::format("{} {}", c.mark, n);
    const float width = textWidth(theme.small, text) + 2 * theme.space(2);
    ImGui::SetCursorScreenPos({x, min.y});
    if (ImGui::InvisibleButton(c.trace, {width, max.y - min.y})) showLog(ui, logPanel, c.level);
    ui.trace.item(c.trace);
    if (ImGui::IsItemHovered()) {
      ImGui::GetWindowDrawList()->AddRectFilled({x, min.y + theme.px(2)}, {x + width, max.y - theme.px(2)},
                                                palette::kButtonHover, theme.px(4));
      tooltip(theme, c.level == log::Level::Error ? "Errors in the log" : "Warnings in the log");
    }
    drawText(ImGui::GetWindowDrawList(), theme.small,
             {x + theme.space(2), 0.5f * (min.y + max.y - theme.small->FontSize)}, c.ink, text, width);
    x += width;
  }
  return x;
}

/// The message; "" = none is to be shown.
std::string messageText(const Messages& messages) {
  if (!messages.lineVisible()) return {};
  std::string text = messages.line();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return messages.lineLevel() == log::Level::Warning ? std::string(icon::kWarning) + "  " + text : text;
}

void drawMessage(Ui& ui, const std::string& text, ImVec2 min, ImVec2 max, float room) {
  const Theme& theme = ui.theme;
  if (text.empty()) return;
  const bool hint = ui.messages.lineLevel() == log::Level::Warning;
  const float width = drawText(ImGui::GetWindowDrawList(), theme.small,
                               {min.x, 0.5f * (min.y + max.y - theme.small->FontSize)},
                               hint ? palette::kWarning : palette::kTextDim, text, room);
  if (ImGui::IsMouseHoveringRect(min, {min.x + width, max.y}) && ImGui::IsWindowHovered())
    tooltip(theme, ui.messages.line());
  ui.trace.note("status", ui.messages.line());
}

/// The figures at the right, as many as there is room for, each whole: the picture first, the slowest nodes
/// before the faster ones, and last the time of a frame. `used`: their width.
std::string figures(const StatusRoom& room, const std::vector<NodeTime>& times, float width, float& used) {
  constexpr const char* kGap = "   ";
  ImFont* font = room.ui.theme.small;
  std::string text = playText(room.session, room.clock);
  const std::string picture = pictureText(room.shown), frame = "frame " + ms(room.ui.now.frameMs);
  const auto fits = [&](const std::string& more) { return textWidth(font, more) <= width; };
  std::string end = fits(text + picture) ? picture : std::string();
  if (const std::string both = end.empty() ? frame : end + kGap + frame; fits(text + both)) end = both;
  for (std::size_t i = 0; i < std::min<std::size_t>(times.size(), 3); ++i) {
    const std::string next = times[i].name + " " + ms(times[i].cpuMs + times[i].gpuMs) + kGap;
    if (!fits(text + next + end)) break;
    text += next;
  }
  text += end;
  while (text.ends_with(' ')) text.pop_back();
  used = textWidth(font, text);
  return text;
}

void timesTooltip(const Theme& theme, const std::vector<NodeTime>& times) {
  ImGui::BeginTooltip();
  ImGui::TextDisabled("Time of the last evaluation");
  if (ImGui::BeginTable("times", 3, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::PushFont(theme.small);
    for (const char* head : {"Node", "CPU", "GPU"}) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", head);
    }
    for (const NodeTime& t : times) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(t.name.c_str());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(ms(t.cpuMs).c_str());
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(t.gpuMs > 0 ? ms(t.gpuMs).c_str() : "-");
    }
    ImGui::PopFont();
    ImGui::EndTable();
  }
  ImGui::EndTooltip();
}

}  // namespace

void drawStatusLine(const StatusRoom& room, ImVec2 min, ImVec2 max) {
  const Theme& theme = room.ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(min, max, palette::kBar);
  const std::vector<NodeTime> times = nodeTimes(room.session, room.shown);
  const float left = drawCounts(room.ui, room.logPanel, min, max) + theme.space(2);
  // A message goes before the figures: they keep what it leaves, and a third of the line.
  const std::string message = messageText(room.ui.messages);
  const float whole = max.x - theme.space(3) - left, gap = theme.space(6);
  const float wanted = room.exporter.active() ? theme.px(420) : textWidth(theme.small, message);
  const float rest = whole - (wanted > 0 ? wanted + gap : 0);
  float used = 0;
  const std::string text = figures(room, times, std::max(rest, whole / 3), used);
  const float right = max.x - theme.space(3) - used;
  drawText(draw, theme.small, {right, 0.5f * (min.y + max.y - theme.small->FontSize)}, palette::kTextDim,
           text, used + 1);
  if (ImGui::IsMouseHoveringRect({right, min.y}, {right + used, max.y}) && ImGui::IsWindowHovered() &&
      !times.empty())
    timesTooltip(room.ui.theme, times);
  if (room.exporter.active())
    drawExport(room.ui, room.exporter, {left - theme.space(2), min.y}, {right, max.y});
  else
    drawMessage(room.ui, message, {left, min.y}, max, right - left - (text.empty() ? 0 : gap));
  room.ui.trace.rect("status", min, max);
}

}  // namespace pileus::editor
