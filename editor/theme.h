#pragma once
// Colours, type scale and spacing of the interface: the only place that names a colour or a font size.
#include <imgui.h>

#include <string_view>
#include <vector>

#include "nodes/value.h"

namespace pileus::editor {

namespace palette {
inline constexpr ImU32 kBackground = IM_COL32(18, 20, 24, 255);
inline constexpr ImU32 kPanel = IM_COL32(27, 30, 35, 255);
inline constexpr ImU32 kBar = IM_COL32(32, 35, 41, 255);
inline constexpr ImU32 kPopup = IM_COL32(36, 40, 47, 252);
inline constexpr ImU32 kField = IM_COL32(17, 19, 23, 255);
inline constexpr ImU32 kFieldHover = IM_COL32(23, 26, 31, 255);
inline constexpr ImU32 kFieldFill = IM_COL32(44, 72, 99, 255);
inline constexpr ImU32 kFieldFillHover = IM_COL32(54, 88, 121, 255);
inline constexpr ImU32 kLine = IM_COL32(48, 53, 61, 255);
inline constexpr ImU32 kCanvas = IM_COL32(22, 24, 29, 255);
inline constexpr ImU32 kGrid = IM_COL32(31, 34, 40, 255);
inline constexpr ImU32 kGridStrong = IM_COL32(37, 41, 48, 255);
inline constexpr ImU32 kNode = IM_COL32(42, 46, 54, 255);
inline constexpr ImU32 kNodeBorder = IM_COL32(12, 13, 16, 255);
inline constexpr ImU32 kText = IM_COL32(218, 222, 228, 255);
inline constexpr ImU32 kTextStrong = IM_COL32(245, 247, 250, 255);
inline constexpr ImU32 kTextDim = IM_COL32(151, 159, 171, 255);
inline constexpr ImU32 kTextFaint = IM_COL32(108, 116, 128, 255);
inline constexpr ImU32 kAccent = IM_COL32(98, 165, 224, 255);
inline constexpr ImU32 kAccentDim = IM_COL32(52, 86, 118, 255);
inline constexpr ImU32 kSelect = IM_COL32(242, 183, 88, 255);
inline constexpr ImU32 kWarning = IM_COL32(232, 177, 79, 255);
inline constexpr ImU32 kError = IM_COL32(236, 112, 107, 255);
inline constexpr ImU32 kErrorBack = IM_COL32(74, 34, 36, 255);
inline constexpr ImU32 kWarningBack = IM_COL32(66, 52, 26, 255);
inline constexpr ImU32 kGood = IM_COL32(116, 196, 144, 255);
}  // namespace palette

/// Canvas zoom is always one of these levels, so that each text size is baked and sharp.
struct ZoomLevel {
  float zoom = 1;          ///< screen pixels per canvas unit, UI scale included
  ImFont* text = nullptr;  ///< null: too small to read, no text is drawn
  ImFont* strong = nullptr;
};

struct Theme {
  float scale = 1;
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

/// Loads fonts into ImGui's atlas and sets its style. Call once, after the ImGui context exists and before
/// the first frame.
Theme makeTheme(float scale);

ImU32 socketColor(nodes::SocketType type);
/// Header colour and icon of a node category; unknown categories are grey.
ImU32 categoryColor(std::string_view category);
const char* categoryIcon(std::string_view category);
/// `color` with its alpha multiplied.
ImU32 faded(ImU32 color, float alpha);
/// Between two colours.
ImU32 mixed(ImU32 a, ImU32 b, float t);

}  // namespace pileus::editor
