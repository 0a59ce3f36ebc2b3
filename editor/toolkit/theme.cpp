#include "editor/toolkit/theme.h"

#include <algorithm>
#include <cmath>

#include "editor/toolkit/icon_ranges.h"
#include "editor/toolkit/icons.h"
#include "embedded_fonts.h"
#include "renderer/base/log.h"

namespace pileus::editor {
namespace {

constexpr float kCanvasText = 16;  // canvas units of a node's text line

const ImWchar kTextRange[] = {0x20,   0x7e,   0xa0,   0xff,   0x131,  0x131,  0x394,  0x394,  0x3c0,
                              0x3c4,  0x2010, 0x2027, 0x2032, 0x203a, 0x2070, 0x207f, 0x2190, 0x2193,
                              0x2212, 0x2212, 0x2248, 0x2248, 0x2264, 0x2265, 0};
const ImWchar kCanvasRange[] = {0x20, 0x7e, 0xb0, 0xb7, 0xc0, 0xff, 0x2010, 0x2026, 0x2212, 0x2212, 0};
const ImWchar kIconRange[] = {
    0xf002, 0xf002, 0xf00c, 0xf00d, 0xf011, 0xf011, 0xf015, 0xf017, 0xf01e, 0xf01e, 0xf021, 0xf023, 0xf02e,
    0xf030, 0xf03a, 0xf03a, 0xf03e, 0xf042, 0xf047, 0xf047, 0xf04c, 0xf04c, 0xf054, 0xf054, 0xf059, 0xf05b,
    0xf05e, 0xf062, 0xf065, 0xf06a, 0xf06e, 0xf071, 0xf07b, 0xf07c, 0xf080, 0xf080, 0xf08b, 0xf090, 0xf096,
    0xf096, 0xf09c, 0xf09c, 0xf0ac, 0xf0ac, 0xf0b0, 0xf0b0, 0xf0c2, 0xf0c7, 0xf0db, 0xf0db, 0xf0e2, 0xf0e2,
    0xf0ea, 0xf0ea, 0xf0f3, 0xf0f3, 0xf108, 0xf108, 0xf111, 0xf111, 0xf11c, 0xf11c, 0xf120, 0xf120, 0xf127,
    0xf127, 0xf12d, 0xf12d, 0xf142, 0xf142, 0xf185, 0xf186, 0xf1b2, 0xf1b2, 0xf1da, 0xf1da, 0xf1de, 0xf1de,
    0xf1ec, 0xf1ec, 0xf1f8, 0xf1f8, 0xf1fb, 0xf1fc, 0xf201, 0xf201, 0xf245, 0xf248, 0xf24d, 0xf24d, 0};

std::string_view fontBytes(std::string_view ending) {
  for (const EmbeddedFile& file : embedded_fonts())
    if (file.path.ends_with(ending)) return file.bytes;
  return {};
}

ImFont* addFont(std::string_view ending, float pixels, const ImWchar* range, bool icons) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const std::string_view bytes = fontBytes(ending);
  if (bytes.empty()) {
    log::error("The font {} is not in this build; the built-in one is used.", ending);
    return atlas.AddFontDefault();
  }
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;  // the bytes are part of the executable
  config.OversampleH = pixels < 20 ? 2 : 1;
  config.OversampleV = 1;
  config.RasterizerMultiply = 1.1f;
  ImFont* font = atlas.AddFontFromMemoryTTF(const_cast<char*>(bytes.data()), static_cast<int>(bytes.size()),
                                            pixels, &config, range);
  const std::string_view glyphs = fontBytes("forkawesome-webfont.ttf");
  if (icons && !glyphs.empty()) {
    ImFontConfig merge;
    merge.FontDataOwnedByAtlas = false;
    merge.MergeMode = true;
    merge.PixelSnapH = true;
    merge.GlyphMinAdvanceX = std::round(pixels * 1.1f);
    merge.GlyphOffset.y = std::round(pixels * 0.04f);
    atlas.AddFontFromMemoryTTF(const_cast<char*>(glyphs.data()), static_cast<int>(glyphs.size()),
                               std::round(pixels * 0.92f), &merge, kIconRange);
  }
  return font;
}

void applyStyle(const Theme& theme) {
  ImGuiStyle& s = ImGui::GetStyle();
  s = ImGuiStyle();
  s.WindowPadding = {theme.space(3), theme.space(3)};
  s.FramePadding = {theme.space(2), theme.px(5)};
  s.ItemSpacing = {theme.space(2), theme.px(6)};
  s.ItemInnerSpacing = {theme.px(6), theme.px(4)};
  s.CellPadding = {theme.space(1), theme.px(3)};
  s.IndentSpacing = theme.space(4);
  s.ScrollbarSize = theme.px(11);
  s.GrabMinSize = theme.px(10);
  s.WindowBorderSize = 0;
  s.ChildBorderSize = 0;
  s.PopupBorderSize = 1;
  s.FrameBorderSize = 0;
  s.WindowRounding = 0;
  s.ChildRounding = theme.px(4);
  s.FrameRounding = theme.px(4);
  s.PopupRounding = theme.px(6);
  s.ScrollbarRounding = theme.px(6);
  s.GrabRounding = theme.px(4);
  s.WindowTitleAlign = {0.0f, 0.5f};
  s.WindowMenuButtonPosition = ImGuiDir_None;
  s.CircleTessellationMaxError = 0.2f;
  s.CurveTessellationTol = 0.8f;

  const auto set = [&](ImGuiCol slot, ImU32 color) {
    s.Colors[slot] = ImGui::ColorConvertU32ToFloat4(color);
  };
  set(ImGuiCol_Text, palette::kText);
  set(ImGuiCol_TextDisabled, palette::kTextFaint);
  set(ImGuiCol_WindowBg, palette::kPanel);
  set(ImGuiCol_ChildBg, 0);
  set(ImGuiCol_PopupBg, palette::kPopup);
  set(ImGuiCol_Border, palette::kLine);
  set(ImGuiCol_FrameBg, palette::kField);
  set(ImGuiCol_FrameBgHovered, palette::kFieldHover);
  set(ImGuiCol_FrameBgActive, palette::kFieldHover);
  set(ImGuiCol_TitleBg, palette::kBar);
  set(ImGuiCol_TitleBgActive, palette::kBar);
  set(ImGuiCol_MenuBarBg, palette::kBar);
  set(ImGuiCol_ScrollbarBg, 0);
  set(ImGuiCol_ScrollbarGrab, palette::kScroll);
  set(ImGuiCol_ScrollbarGrabHovered, palette::kScrollHover);
  set(ImGuiCol_ScrollbarGrabActive, palette::kScrollActive);
  set(ImGuiCol_CheckMark, palette::kAccent);
  set(ImGuiCol_SliderGrab, palette::kAccent);
  set(ImGuiCol_SliderGrabActive, palette::kAccent);
  set(ImGuiCol_Button, palette::kButton);
  set(ImGuiCol_ButtonHovered, palette::kButtonHover);
  set(ImGuiCol_ButtonActive, palette::kAccentDim);
  set(ImGuiCol_Header, palette::kAccentDim);
  set(ImGuiCol_HeaderHovered, palette::kRowHover);
  set(ImGuiCol_HeaderActive, palette::kAccentDim);
  set(ImGuiCol_Separator, palette::kLine);
  set(ImGuiCol_SeparatorHovered, palette::kAccent);
  set(ImGuiCol_SeparatorActive, palette::kAccent);
  set(ImGuiCol_TextSelectedBg, palette::kTextSelected);
  set(ImGuiCol_NavHighlight, palette::kAccent);
  set(ImGuiCol_ModalWindowDimBg, palette::kDim);
  set(ImGuiCol_PlotHistogram, palette::kAccent);
  set(ImGuiCol_TableBorderLight, palette::kLine);
  set(ImGuiCol_TableRowBgAlt, palette::kRowAlt);
}

struct SocketInk {
  std::string_view type;
  const ImU32* color;
};

const SocketInk kSocketInks[] = {{"volume", &palette::kVolumeSocket}, {"light", &palette::kLightSocket},
                                 {"metric", &palette::kMetricSocket}, {"camera", &palette::kCameraSocket},
                                 {"solid", &palette::kSolidSocket},   {"image", &palette::kImageSocket},
                                 {"number", &palette::kNumberSocket}, {"vector", &palette::kVectorSocket},
                                 {"color", &palette::kColorSocket},   {"text", &palette::kTextSocket}};

struct Category {
  std::string_view name;
  const ImU32* color;
  const char* icon;
};
bool lightTheme = false;  // what the palette was last set to

constexpr Category kCategories[] = {
    {"Volume", &palette::kVolume, icon::kCloud},      {"Light", &palette::kLight, icon::kSun},
    {"Shadow", &palette::kShadowNode, icon::kAdjust}, {"Camera", &palette::kCamera, icon::kCamera},
    {"Solid", &palette::kSolid, icon::kCube},         {"Render", &palette::kRender, icon::kPicture},
    {"Output", &palette::kOutput, icon::kDesktop},    {"Image", &palette::kImage, icon::kPicture},
    {"Math", &palette::kMath, icon::kMath},           {"Time", &palette::kTime, icon::kClock},
};

}  // namespace

const ImWchar* iconRanges() { return kIconRange; }

ImU32 headerColor(ImU32 chosen) {
  // Dark ink needs a light ground: the chosen colour as a tint.
  return lightTheme ? mixed(chosen, palette::kHighlight, 0.62f) : chosen;
}

void setPalette(Appearance appearance) {
  lightTheme = appearance == Appearance::Light;
#define COLOR(name, dark, light) palette::name = palette::color(lightTheme ? light : dark);
#include "editor/toolkit/palette.inc"
#undef COLOR
}

float Theme::px(float design) const { return std::round(design * scale); }

void setAppearance(Theme& theme, Appearance appearance) {
  theme.appearance = appearance;
  setPalette(appearance);
  applyStyle(theme);
}

Theme makeTheme(float scale, Appearance appearance) {
  Theme theme;
  theme.scale = scale;
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  atlas.TexDesiredWidth = 2048;
  theme.body = addFont("Inter-Regular.otf", theme.px(16), kTextRange, true);
  theme.strong = addFont("Inter-SemiBold.otf", theme.px(16), kTextRange, true);
  theme.title = addFont("Inter-SemiBold.otf", theme.px(19), kTextRange, true);
  theme.small = addFont("Inter-Regular.otf", theme.px(14), kTextRange, true);
  theme.mono = addFont("JetBrainsMono-Regular.ttf", theme.px(15), kTextRange, true);

  for (const float zoom : {0.003f, 0.0042f, 0.006f, 0.0085f, 0.012f, 0.016f, 0.022f, 0.03f, 0.042f, 0.058f,
                           0.08f, 0.11f, 0.15f, 0.2f, 0.28f, 0.38f, 0.5f})
    theme.zoomLevels.push_back({zoom * scale, nullptr, nullptr});
  for (const float pixels : {10.f, 11.f, 12.f, 13.f, 14.f, 16.f, 18.f, 20.f, 24.f, 28.f}) {
    const float baked = std::round(pixels * scale);
    if (pixels == kCanvasText) theme.defaultZoom = static_cast<int>(theme.zoomLevels.size());
    theme.zoomLevels.push_back({baked / kCanvasText, addFont("Inter-Regular.otf", baked, kCanvasRange, true),
                                addFont("Inter-SemiBold.otf", baked, kCanvasRange, true)});
  }
  setAppearance(theme, appearance);
  return theme;
}

ImU32 socketColor(std::string_view type) {
  for (const SocketInk& s : kSocketInks)
    if (s.type == type) return *s.color;
  return palette::kTextDim;
}

ImU32 categoryColor(std::string_view category) {
  for (const Category& c : kCategories)
    if (c.name == category) return *c.color;
  return palette::kOther;
}

const char* categoryIcon(std::string_view category) {
  for (const Category& c : kCategories)
    if (c.name == category) return c.icon;
  return icon::kCube;
}

ImU32 faded(ImU32 color, float alpha) {
  const auto a =
      static_cast<ImU32>(static_cast<float>(color >> IM_COL32_A_SHIFT) * std::clamp(alpha, 0.0f, 1.0f));
  return (color & ~IM_COL32_A_MASK) | (a << IM_COL32_A_SHIFT);
}

ImU32 mixed(ImU32 a, ImU32 b, float t) {
  const ImVec4 x = ImGui::ColorConvertU32ToFloat4(a), y = ImGui::ColorConvertU32ToFloat4(b);
  return ImGui::ColorConvertFloat4ToU32(
      {x.x + (y.x - x.x) * t, x.y + (y.y - x.y) * t, x.z + (y.z - x.z) * t, x.w + (y.w - x.w) * t});
}

}  // namespace pileus::editor
