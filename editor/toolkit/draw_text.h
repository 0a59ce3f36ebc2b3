#pragma once
// Text at a place of the screen, and ImGui's vectors as ours.
#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/math.h"

namespace pileus::editor {

inline vec2 vec(ImVec2 v) { return {v.x, v.y}; }
inline ImVec2 im(vec2 v) { return {v.x, v.y}; }

/// Texts of one frame that found no room: what was cut off one below the pointer can still be read. All that
/// draws text finds it in ImGui's io, as its UserData; null there: nothing is kept.
struct CutTexts {
  bool all = false;                ///< keep each of them, for tests
  std::vector<std::string> texts;  ///< those, from the first drawn to the last
  std::string under;               ///< the one below the pointer, in the window that has it; "": none
  std::string told;                ///< what tooltips say already

  void beginFrame() { texts.clear(), under.clear(), told.clear(); }
};
/// Of this context; null: none is kept.
CutTexts* cutTexts();
/// Says that a text was drawn in part. For those who cut by themselves; drawText() does it.
void noteCut(vec2 min, vec2 max, std::string_view whole);
/// The same of one that is not drawn at all, as it would be too small: it is none of `texts`.
void noteHidden(vec2 min, vec2 max, std::string_view whole);

/// Text at whole pixels, cut with an ellipsis beyond `width`. Returns the width drawn.
float drawText(ImDrawList* draw, ImFont* font, vec2 at, ImU32 color, std::string_view text, float width);
float textWidth(ImFont* font, std::string_view text);
/// Cut between words into `most` lines at most, each within `width` where its words are; the last one holds
/// all the rest.
std::vector<std::string_view> linesOf(ImFont* font, std::string_view text, float width, int most);
/// The path, or where that is too wide an ellipsis and its end: it says more than the beginning. Who draws it
/// tells noteCut().
std::string endOfPath(ImFont* font, const std::string& path, float width);

}  // namespace pileus::editor
