#include "editor/toolkit/draw_text.h"

#include <algorithm>
#include <cmath>

namespace pileus::editor {
namespace {

constexpr std::string_view kEllipsis = "\xe2\x80\xa6";

}  // namespace

float textWidth(ImFont* font, std::string_view text) {
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
}

std::vector<std::string_view> linesOf(ImFont* font, std::string_view text, float width, int most) {
  std::vector<std::string_view> lines;
  while (static_cast<int>(lines.size()) + 1 < most && !text.empty()) {
    const char* end = text.data() + text.size();
    const char* cut = font->CalcWordWrapPositionA(1, text.data(), end, width);
    if (cut == end) break;
    lines.push_back(text.substr(0, static_cast<std::size_t>(cut - text.data())));
    text.remove_prefix(lines.back().size());
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  lines.push_back(text);
  return lines;
}

CutTexts* cutTexts() { return static_cast<CutTexts*>(ImGui::GetIO().UserData); }

void noteCut(vec2 min, vec2 max, std::string_view whole) {
  CutTexts* cut = cutTexts();
  if (cut && cut->all) cut->texts.emplace_back(whole);
  noteHidden(min, max, whole);
}

void noteHidden(vec2 min, vec2 max, std::string_view whole) {
  CutTexts* cut = cutTexts();
  if (cut && ImGui::IsMouseHoveringRect(im(min), im(max)) && ImGui::IsWindowHovered()) cut->under = whole;
}

std::string endOfPath(ImFont* font, const std::string& path, float width) {
  if (textWidth(font, path) <= width) return path;
  std::string end = path;
  const auto tooWide = [&] { return textWidth(font, std::string(kEllipsis) + end) > width; };
  // Whole folders first, then letters of the name.
  for (std::size_t slash = end.find('/', 1); slash != std::string::npos && tooWide();
       slash = end.find('/', 1))
    end.erase(0, slash);
  while (end.size() > 1 && tooWide()) {
    end.erase(0, 1);
    while (!end.empty() && (static_cast<unsigned char>(end.front()) & 0xc0) == 0x80) end.erase(0, 1);
  }
  return std::string(kEllipsis) + end;
}

float drawText(ImDrawList* draw, ImFont* font, vec2 at, ImU32 color, std::string_view text, float width) {
  const ImVec2 where = {std::round(at.x), std::round(at.y)};
  const float full = textWidth(font, text);
  if (full <= width) {
    draw->AddText(font, font->FontSize, where, color, text.data(), text.data() + text.size());
    return full;
  }
  const float dots = textWidth(font, kEllipsis);
  noteCut(vec(where), {where.x + std::max(width, dots), where.y + font->FontSize}, text);
  if (width < dots) return 0;
  const char* cut = nullptr;
  const float part =
      font->CalcTextSizeA(font->FontSize, width - dots, 0, text.data(), text.data() + text.size(), &cut).x;
  draw->AddText(font, font->FontSize, where, color, text.data(), cut);
  draw->AddText(font, font->FontSize, {where.x + std::round(part), where.y}, color, kEllipsis.data(),
                kEllipsis.data() + kEllipsis.size());
  return part + dots;
}

}  // namespace pileus::editor
