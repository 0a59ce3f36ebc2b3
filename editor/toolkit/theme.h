#pragma once
// Colours, type scale and spacing of the interface: the only place that names a colour or a font size.
#include <imgui.h>

#include <string_view>
#include <vector>

#include "editor/preferences/appearance.h"
#include "nodes/declare/socket_type.h"

namespace pileus::editor {

namespace palette {
/// 0xRRGGBBAA as ImGui keeps it.
constexpr ImU32 color(ImU32 rgba) {
  return IM_COL32(rgba >> 24, (rgba >> 16) & 255, (rgba >> 8) & 255, rgba & 255);
}
// Variables that setPalette() changes: never copy them into something that outlives a frame.
#define COLOR(name, dark, light) inline ImU32 name = color(dark);
#include "editor/toolkit/palette.inc"
#undef COLOR
}  // namespace palette

/// Canvas zoom is always one of these levels, so that each text size is baked and sharp.
struct ZoomLevel {
  float zoom = 1;          ///< screen pixels per canvas unit, UI scale included
  ImFont* text = nullptr;  ///< null: too small to read, no text is drawn
  ImFont* strong = nullptr;
};

struct Theme {
  float scale = 1;
  Appearance appearance = Appearance::Dark;
  ImFont* body = nullptr;             ///< text, 13 px em
  ImFont* strong = nullptr;           ///< the same, semi-bold
  ImFont* title = nullptr;            ///< headings
  ImFont* small = nullptr;            ///< chips, units, hints
  ImFont* mono = nullptr;             ///< figures
  std::vector<ZoomLevel> zoomLevels;  ///< ascending
  int defaultZoom = 0;                ///< index of zoom 1 x scale

  /// Pixels of a design length, whole.
  float px(float design) const;
  /// The spacing scale: 4 design pixels a step.
  float space(float steps = 1) const { return px(4 * steps); }
};

/// Loads fonts into ImGui's atlas, emptied before, and sets its style. Between frames, after the ImGui
/// context exists; textures made from the atlas are the caller's.
Theme makeTheme(float scale, Appearance appearance);
/// Sets the variables of palette::, and nothing else.
void setPalette(Appearance appearance);
/// The same fonts in another appearance. Between frames.
void setAppearance(Theme& theme, Appearance appearance);

ImU32 socketColor(nodes::SocketType type);
/// Header colour and icon of a node category; unknown categories are grey.
ImU32 categoryColor(std::string_view category);
/// A colour the user gave a node, so that a title on it reads in this theme.
ImU32 headerColor(ImU32 chosen);
const char* categoryIcon(std::string_view category);
/// `color` with its alpha multiplied.
ImU32 faded(ImU32 color, float alpha);
/// Between two colours.
ImU32 mixed(ImU32 a, ImU32 b, float t);

}  // namespace pileus::editor
