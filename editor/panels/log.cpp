#include "editor/panels/log.h"

#include <fmt/core.h>

#include "editor/editor.h"
#include "renderer/base/log.h"

namespace pileus::editor {

void drawLog(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, palette::kPanel);
  ImGui::SetCursorScreenPos({min.x + theme.space(3), min.y + theme.space(2)});
  ImGui::BeginChild("log", {max.x - min.x - theme.space(4), max.y - min.y - theme.space(3)}, false,
                    ImGuiWindowFlags_HorizontalScrollbar);
  const bool atEnd = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1;
  ImGui::PushFont(theme.mono);
  const std::vector<log::Line> lines = log::history();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const log::Line& line = lines[static_cast<std::size_t>(i)];
      const ImU32 ink = line.level == log::Level::Error     ? palette::kError
                        : line.level == log::Level::Warning ? palette::kWarning
                                                            : palette::kText;
      ImGui::TextDisabled("%s", fmt::format("{:8.2f}", line.seconds).c_str());
      ImGui::SameLine(0, theme.space(3));
      ImGui::PushStyleColor(ImGuiCol_Text, ink);
      ImGui::TextUnformatted(line.text.c_str());
      ImGui::PopStyleColor();
    }
  ImGui::PopFont();
  if (lines.empty()) ImGui::TextDisabled("Nothing has been logged.");
  if (atEnd) ImGui::SetScrollHereY(1);
  ImGui::EndChild();
  editor.trace.rect("log", min, max);
}

}  // namespace pileus::editor
