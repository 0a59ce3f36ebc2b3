#include "editor/viewport/compare_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"
#include "editor/viewport/wipe_line.h"

namespace pileus::editor {
namespace {

ImTextureID textureId(unsigned texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

/// The two textures of a comparison; 0: not there yet.
struct Sides {
  unsigned picture = 0, truth = 0;
};

unsigned drawn(Shown& shown, const truth::ComparePass& pass, truth::CompareDisplay::Show show, double scale,
               int slot) {
  Result<unsigned> texture = shown.compare.display.draw(shown.renderer.shaders(), pass, show, scale, slot);
  if (texture) return *texture;
  if (shown.compare.error.empty()) shown.compare.error = texture.error().message;
  return 0;
}

Sides sidesOf(Ui& ui, const Session& session, const Clock& clock, Shown& shown, ivec2 size) {
  const CompareMode& mode = shown.compare;
  const truth::ComparePass* pass = mode.shownTruth();
  if (mode.of == CompareOf::Radiance)
    return {shown.displayed.texture,
            pass ? displayTexture(ui.messages, session, clock, shown, pass->truth(), size, 1) : 0};
  if (!pass) return {};
  using Show = truth::CompareDisplay::Show;
  return {drawn(shown, *pass, Show::MappedTransmittance, 1, 0),
          drawn(shown, *pass, Show::TrueTransmittance, 1, 1)};
}

/// "interval K=4, 8 cosines": what the picture's lights have in common.
std::string pictureLabel(const CompareMode& mode) {
  std::string label;
  int shadows = 0;
  if (mode.scene)
    for (const auto& light : mode.scene->lights) {
      if (!light.shadow) continue;
      const std::string name = shadow::describe(light.shadow->spec);
      ++shadows;
      if (label.empty())
        label = name;
      else if (label != name)
        label = "?";
    }
  return label == "?" ? fmt::format("{} shadows", shadows) : label.empty() ? "Picture" : label;
}

std::string truthLabel(const CompareMode& mode) {
  const truth::ComparePass* pass = mode.shownTruth();
  const bool judge = mode.of == CompareOf::Radiance && mode.against == truth::TruthKind::Judge;
  const std::string name = judge ? "Judge" : "Ray marched";
  if (!pass) return name + ", soon";
  if (pass == mode.draft.get()) return name + ", draft";
  if (pass == mode.coarse.get()) return name + ", small";
  const int done = pass->truth()->samples, all = pass->truthSamples();
  return mode.of == CompareOf::Radiance && done < all ? fmt::format("{}, {} of {} samples", name, done, all)
                                                      : name;
}

void label(Ui& ui, vec2 lo, vec2 hi, const std::string& text, bool right, const char* trace) {
  const Theme& theme = ui.theme;
  const vec2 pad(theme.space(2), theme.px(4));
  const float room = hi.x - lo.x - 2 * theme.space(2) - 2 * pad.x;
  if (room < theme.px(40)) return;
  const vec2 size(std::min(textWidth(theme.small, text), room), theme.small->FontSize);
  const vec2 at(right ? hi.x - theme.space(2) - 2 * pad.x - size.x : lo.x + theme.space(2),
                lo.y + theme.space(2));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(at), im(at + size + 2.0f * pad), palette::kChip, theme.px(4));
  drawText(draw, theme.small, at + pad, palette::kText, text, size.x + 1);
  ui.trace.note(trace, text);
}

/// A picture, or where there is none yet what stands for it, between two lines of its rectangle.
void drawPart(vec2 lo, vec2 hi, unsigned texture, unsigned instead, float from, float to) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const vec2 a(glm::mix(lo.x, hi.x, from), lo.y), b(glm::mix(lo.x, hi.x, to), hi.y);
  if (to <= from) return;
  if (texture || instead)
    draw->AddImage(textureId(texture ? texture : instead), im(a), im(b), {from, 0}, {to, 1});
  if (!texture) draw->AddRectFilled(im(a), im(b), palette::kVeil);
}

void drawWipe(const ViewportRoom& room, vec2 lo, vec2 hi, bool hovered) {
  WipeLine line{room.shown.compare.wipe, room.shown.compare.draggingWipe};
  moveWipeLine(room.ui.theme, room.viewport, line, lo, hi, hovered);
  room.shown.compare.wipe = line.at;
  room.shown.compare.draggingWipe = line.held;
  const auto at = static_cast<float>(room.shown.compare.wipe);
  const Sides sides = sidesOf(room.ui, room.session, room.clock, room.shown, ivec2(hi - lo));
  drawPart(lo, hi, sides.picture, room.shown.displayed.texture, 0, at);
  drawPart(lo, hi, sides.truth, sides.picture, at, 1);
  drawWipeLine(room.ui, line, lo, hi, "compare/line");
  const float x = std::round(glm::mix(lo.x, hi.x, at));
  label(room.ui, lo, {x, hi.y}, pictureLabel(room.shown.compare), false, "compare left");
  label(room.ui, {x, lo.y}, hi, truthLabel(room.shown.compare), true, "compare right");
  room.shown.places = {{lo, hi}};
}

void drawHalves(Ui& ui, const Session& session, const Clock& clock, Shown& shown, vec2 lo, vec2 hi,
                float aspect) {
  const vec2 room(0.5f * (hi.x - lo.x - ui.theme.px(4)), hi.y - lo.y);
  const vec2 size = glm::max(
      glm::floor(vec2(std::min(room.x, room.y * aspect), std::min(room.y, room.x / aspect))), vec2(1));
  const float middle = std::round(0.5f * (lo.x + hi.x)), top = std::floor(lo.y + 0.5f * (room.y - size.y));
  const vec2 a(middle - ui.theme.px(2) - size.x, top), b(middle + ui.theme.px(2), top);
  const Sides sides = sidesOf(ui, session, clock, shown, ivec2(size));
  drawPart(a, a + size, sides.picture, shown.displayed.texture, 0, 1);
  drawPart(b, b + size, sides.truth, sides.picture, 0, 1);
  label(ui, a, a + size, pictureLabel(shown.compare), false, "compare left");
  label(ui, b, b + size, truthLabel(shown.compare), true, "compare right");
  shown.places = {{a, a + size}, {b, b + size}};
}

std::string tick(double value) {
  return value == 0 ? "0" : fmt::format("{}{:.3g}", value < 0 ? "\xe2\x88\x92" : "+", std::abs(value));
}

/// The colours with their values, at the right end of the strip; its width.
float drawLegend(Ui& ui, vec2 lo, vec2 hi, double scale) {
  const Theme& theme = ui.theme;
  const float width = theme.px(150), bar = theme.px(8), text = theme.small->FontSize;
  const std::string_view dark = "too dark", leak = "light leaks";
  const float darkWidth = textWidth(theme.small, dark), leakWidth = textWidth(theme.small, leak),
              gap = theme.space(6);
  const float whole = darkWidth + width + leakWidth + 2 * gap;
  if (whole > hi.x - lo.x) return 0;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const vec2 at(hi.x - leakWidth - gap - width,
                std::round(0.5f * (lo.y + hi.y) - 0.5f * (bar + text + theme.px(3))));
  const float middle = std::round(at.y + 0.5f * (bar + text + theme.px(3) - text));
  drawText(draw, theme.small, {at.x - gap - darkWidth, middle}, palette::kTextDim, dark, darkWidth + 1);
  drawText(draw, theme.small, {hi.x - leakWidth, middle}, palette::kTextDim, leak, leakWidth + 1);
  constexpr int kSteps = 75;
  for (int i = 0; i < kSteps; ++i) {
    const vec3 c = 255.0f * truth::falseColour(2.0 * (i + 0.5) / kSteps - 1);
    draw->AddRectFilled({at.x + width * static_cast<float>(i) / kSteps, at.y},
                        {at.x + width * static_cast<float>(i + 1) / kSteps, at.y + bar},
                        IM_COL32(static_cast<int>(c.r), static_cast<int>(c.g), static_cast<int>(c.b), 255));
  }
  for (int i = -2; i <= 2; ++i) {
    const float x =
        std::clamp(at.x + width * (0.5f + 0.25f * static_cast<float>(i)), at.x + 0.5f, at.x + width - 0.5f);
    draw->AddLine({x, at.y + bar}, {x, at.y + bar + theme.px(3)}, palette::kTextDim);
    if (i % 2 != 0) continue;
    const std::string value = tick(0.5 * i * scale);
    const float w = textWidth(theme.small, value);
    drawText(draw, theme.small, {x - 0.5f * w, at.y + bar + theme.px(3)}, palette::kTextDim, value, w + 1);
  }
  ui.trace.note("compare legend", tick(scale));
  return whole + theme.space(5);
}

void drawError(Ui& ui, Shown& shown, vec2 lo, vec2 hi) {
  CompareMode& mode = shown.compare;
  using Show = truth::CompareDisplay::Show;
  const bool radiance = mode.of == CompareOf::Radiance;
  const double scale = radiance ? mode.radianceScale : mode.shadowScale;
  const truth::ComparePass* pass = mode.shown();
  const unsigned texture = pass ? drawn(shown, *pass,
                                        radiance     ? Show::RadianceError
                                        : mode.worst ? Show::WorstError
                                                     : Show::ShadowError,
                                        scale, 0)
                                : 0;
  drawPart(lo, hi, texture, shown.displayed.texture, 0, 1);
  label(ui, lo, hi, pictureLabel(mode), false, "compare left");
  const std::string what = radiance     ? "Radiance"
                           : mode.worst ? "\xce\x94T, worst on the ray"
                                        : "\xce\x94T, mean of what is seen";
  label(ui, lo, hi,
        !pass                       ? what + ", soon"
        : pass == mode.draft.get()  ? what + ", draft"
        : pass == mode.coarse.get() ? what + ", small"
                                    : what,
        true, "compare right");
  shown.places = {{lo, hi}};
}

std::string figure(double value) {
  if (value == 0) return "0";
  return value < 1e-3 || value >= 1e4 ? fmt::format("{:.1e}", value)
         : value < 1                  ? fmt::format("{:.4f}", value)
                                      : fmt::format("{:.3g}", value);
}

}  // namespace

void drawComparison(const ViewportRoom& room, vec2 lo, vec2 hi, vec2 roomMin, vec2 roomMax, bool hovered) {
  const CompareMode& mode = room.shown.compare;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (mode.layout != CompareLayout::Wipe) room.shown.compare.draggingWipe = false;
  if (mode.layout == CompareLayout::SideBySide)
    drawHalves(room.ui, room.session, room.clock, room.shown, roomMin, roomMax,
               (hi.x - lo.x) / std::max(hi.y - lo.y, 1.0f));
  else
    draw->AddRectFilled(im(lo), im(hi), palette::kPictureEmpty);
  if (mode.layout == CompareLayout::Wipe) drawWipe(room, lo, hi, hovered);
  if (mode.layout == CompareLayout::Error) drawError(room.ui, room.shown, lo, hi);
  if (!mode.error.empty())
    label(room.ui, {lo.x, 0.5f * (lo.y + hi.y) - room.ui.theme.px(14)}, hi, mode.error, false,
          "compare error");
  if (compareWantsFrame(room.shown))
    draw->AddRectFilled(
        {roomMin.x, roomMax.y - room.ui.theme.px(2)},
        {glm::mix(roomMin.x, roomMax.x, static_cast<float>(compareFraction(mode))), roomMax.y},
        palette::kSelect);
}

void drawCompareFigures(Ui& ui, const Shown& shown, vec2 lo, vec2 hi) {
  const Theme& theme = ui.theme;
  const CompareMode& mode = shown.compare;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(lo), im(hi), palette::kPanel);
  vec2 from(lo.x + theme.space(3), lo.y), to(hi.x - theme.space(3), hi.y);
  if (mode.layout == CompareLayout::Error)
    to.x -= drawLegend(ui, from, to, mode.of == CompareOf::Radiance ? mode.radianceScale : mode.shadowScale);
  const truth::ComparePass* pass = mode.measured();
  if (!pass) return;
  const truth::CompareFigures& f = pass->figures();
  const float y = std::round(0.5f * (lo.y + hi.y - theme.small->FontSize));
  const auto put = [&](const std::string& text, ImU32 ink, float after) {
    const float w = textWidth(theme.small, text);
    if (from.x + w <= to.x) drawText(draw, theme.small, {from.x, y}, ink, text, w + 1);
    from.x += w + after;
  };
  const auto figures = [&](const std::string& head, const truth::ErrorFigures& e, bool known) {
    put(head, palette::kText, theme.space(2));
    for (const auto& [name, value] :
         {std::pair("mean", e.mean), std::pair("95 %", e.p95), std::pair("max", e.maximum)}) {
      const std::string text = known ? figure(value) : "\xe2\x80\xa6";
      // A name without its figure says nothing.
      if (from.x + textWidth(theme.small, name) + theme.px(5) + textWidth(theme.small, text) > to.x)
        from.x = to.x + 1;
      put(name, palette::kTextFaint, theme.px(5));
      put(text, palette::kText, theme.space(2));
    }
    from.x += theme.space(4);
  };
  const auto shadow = [&] { figures("|\xce\x94T|", f.shadow, f.samples > 0); };
  const auto radiance = [&] {
    figures("Radiance", f.radiance, true);
    from.x -= theme.space(4);
    put(pass->kind() == truth::TruthKind::Judge ? "scaled relMSE" : "relMSE", palette::kTextFaint,
        theme.px(5));
    put(figure(f.relMse), palette::kText, theme.space(6));
  };
  // What is looked at comes first: the strip may be too short for both.
  mode.of == CompareOf::Shadow ? shadow() : radiance();
  mode.of == CompareOf::Shadow ? radiance() : shadow();
  if (pass != mode.fine.get()) put("small picture so far", palette::kTextFaint, 0);
  ui.trace.note("compare shadow mean", fmt::format("{:.9g}", f.shadow.mean));
  ui.trace.note("compare shadow p95", fmt::format("{:.9g}", f.shadow.p95));
  ui.trace.note("compare shadow max", fmt::format("{:.9g}", f.shadow.maximum));
  ui.trace.note("compare radiance mean", fmt::format("{:.9g}", f.radiance.mean));
  ui.trace.note("compare relmse", fmt::format("{:.9g}", f.relMse));
  ui.trace.rect("compare/figures", im(lo), im(hi));
}

}  // namespace pileus::editor
