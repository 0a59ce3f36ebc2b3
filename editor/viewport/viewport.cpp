#include "editor/viewport/viewport.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/displayed.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/compare_bar.h"
#include "editor/viewport/compare_view.h"
#include "editor/viewport/corner_widgets.h"
#include "editor/viewport/picture_overlays.h"
#include "editor/viewport/ray_mark.h"
#include "editor/viewport/region_view.h"
#include "editor/viewport/snapshot_strip.h"
#include "editor/viewport/viewport_bar.h"
#include "editor/viewport/viewport_room.h"
#include "renderer/view/picture.h"

namespace pileus::editor {
namespace {

/// The largest rectangle of the document's aspect inside the panel.
void fit(const Session& session, vec2& min, vec2& max) {
  const vec2 size = vec2(glm::max(session.document.graph().settings.size, ivec2(1)));
  const vec2 room = glm::max(max - min, vec2(1));
  const float scale = std::min(room.x / size.x, room.y / size.y);
  const vec2 drawn = glm::max(glm::floor(size * scale), vec2(1));
  min = glm::floor(min + 0.5f * (room - drawn));
  max = min + drawn;
}

void drawChip(const Theme& theme, vec2 at, const std::string& text, ImU32 ink) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const vec2 pad = {theme.space(2), theme.px(4)};
  const vec2 size = {textWidth(theme.small, text), theme.small->FontSize};
  draw->AddRectFilled(im(at), im(at + size + 2.0f * pad), palette::kChip, theme.px(4));
  drawText(draw, theme.small, at + pad, ink, text, size.x + 1);
}

/// What the picture is: a draft, how far the final one is, what it waits for; and a thin bar along its lower
/// edge.
void drawProgress(Ui& ui, const Session& session, const Shown& shown, vec2 lo, vec2 hi) {
  const Preview& preview = shown.preview;
  if (preview.settled() || shownView(session, shown).empty()) return;
  std::string text = preview.waitingFor();
  const auto percent = static_cast<int>(100 * std::clamp(preview.fraction(), 0.0, 1.0));
  if (preview.paused())
    text = fmt::format("Paused at {} %, Esc continues", percent);
  else if (!text.empty())
    text = fmt::format("{} {} %", text, percent);
  else if (!preview.refining())
    text = "Draft";
  else if (preview.draft() && preview.picture())
    text = fmt::format("Draft, final {} %", percent);
  else
    text = fmt::format("{} %", percent);
  const Theme& theme = ui.theme;
  // In compare mode the upper corners hold the names of the sides, and below them begin the tools.
  const float below = shown.compare.on ? theme.px(28) : 0,
              beside = shown.compare.on ? toolStripWidth(theme, lo, hi) : 0;
  drawChip(theme, lo + vec2(theme.space(2) + beside, theme.space(2) + below), text, palette::kText);
  ui.trace.note("chip", text);
  const float height = theme.px(2);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(
      {lo.x, hi.y - height},
      {lo.x + (hi.x - lo.x) * static_cast<float>(std::clamp(preview.fraction(), 0.0, 1.0)), hi.y},
      palette::kAccent);
}

void drawCentered(const Theme& theme, vec2 lo, vec2 hi, const char* mark, ImU32 ink, const std::string& title,
                  const std::string& text) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float width = std::min(hi.x - lo.x - theme.space(8), theme.px(560));
  if (width < theme.px(80)) return;
  const ImVec2 size = theme.body->CalcTextSizeA(theme.body->FontSize, FLT_MAX, width, text.c_str());
  const std::string head = std::string(mark) + "  " + title;
  const float height = theme.title->FontSize + theme.space(2) + size.y;
  const vec2 middle = 0.5f * (lo + hi);
  drawText(draw, theme.title, {middle.x - 0.5f * textWidth(theme.title, head), middle.y - 0.5f * height}, ink,
           head, width);
  draw->AddText(theme.body, theme.body->FontSize,
                {std::round(middle.x - 0.5f * size.x),
                 std::round(middle.y - 0.5f * height + theme.title->FontSize + theme.space(2))},
                palette::kText, text.c_str(), nullptr, width);
}

void drawNotice(Ui& ui, const Session& session, const Shown& shown, vec2 lo, vec2 hi) {
  const Theme& theme = ui.theme;
  const Preview& preview = shown.preview;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (!preview.error().empty()) {
    draw->AddRectFilled(im(lo), im(hi), palette::kVeil);
    drawCentered(theme, lo, hi, icon::kError, palette::kError, "No new picture", preview.error());
    ui.trace.note("viewport error", preview.error());
  } else if (shownView(session, shown).empty()) {
    drawCentered(theme, lo, hi, icon::kPicture, palette::kTextDim, "Nothing to show yet",
                 "Add a View node and link an image to it to see it here.");
  } else if (!preview.picture() && preview.settled()) {
    drawCentered(theme, lo, hi, icon::kPicture, palette::kTextDim, "No image is linked",
                 "Link a Render node's image to " + shownView(session, shown) + ".");
  }
}

/// What the shown layer is, and that the colours are not those of the file where they cannot be.
void drawPictureNotes(Ui& ui, const Shown& shown, vec2 lo, vec2 hi) {
  const Theme& theme = ui.theme;
  const auto& picture = shown.preview.picture();
  vec2 at(lo.x + theme.space(2), hi.y - theme.space(2) - theme.small->FontSize - theme.px(8));
  if (picture && picture->layer.kind == view::PictureLayer::Kind::Depth && shown.mode.scan.result()) {
    const vec2 range = shown.mode.scan.result()->depth;
    const std::string text = range.y > range.x
                                 ? fmt::format("Depth {:.4g} (white) to {:.4g} m (dark)", range.x, range.y)
                                 : "Depth: nothing there";
    drawChip(theme, at, text, palette::kText);
    ui.trace.note("viewport depth", text);
    at.y -= theme.small->FontSize + theme.px(12);
  }
  if (shown.displayed.colorError.empty() || !shown.displayed.colors) return;
  const std::string text =
      fmt::format("{}  Colours as {}", icon::kWarning, shown.displayed.colors->description());
  drawChip(theme, at, text, palette::kWarning);
  ui.trace.note("viewport colours", shown.displayed.colorError);
  if (ImGui::IsMouseHoveringRect(im(at), {at.x + textWidth(theme.small, text), at.y + theme.px(22)}))
    tooltip(theme, shown.displayed.colorError);
}

/// `right`: of the panel. What stands at the right edge stands beside the picture where there is room.
void drawOverlays(const ViewportRoom& room, vec2 lo, vec2 hi, float right, bool hovered) {
  const bool plain = !room.shown.compare.on;
  if (plain) drawRegionView(room.ui, room.shown, lo, hi, hovered);
  drawInspectorMarks(room.ui.theme, room.shown, room.settings, room.viewport, hovered);
  const auto [first, last] = shownCorners(room.shown);
  if (room.shown.mode.falseColor && !(plain && !room.shown.displayed.texture))
    drawBandLegend(room.ui, room.shown, room.settings, first, last, right);
  if (room.settings.showHistogram) drawHistogram(room.ui, room.shown, first, {right, last.y});
  drawPictureNotes(room.ui, room.shown, lo, hi);
  if (room.settings.showHud) drawHud(room, lo, hi, lo.y + room.ui.theme.px(room.shown.compare.on ? 68 : 40));
}

}  // namespace

bool displayTakesPointer(const Shown& shown, const Settings& settings, const Viewport& viewport) {
  const Viewport& v = viewport;
  return shown.mode.region.drawing || shown.mode.region.from || v.inspector.draggingArea ||
         shown.snapshots.line.held || shown.compare.draggingWipe ||
         (settings.showInspector && ImGui::GetIO().KeyCtrl && v.drag == Viewport::Drag::None);
}

bool displayWantsFrame(const Shown& shown, const Settings& settings, const Viewport& viewport) {
  return shown.mode.scan.busy() || (settings.showInspector && viewport.inspector.busy());
}

std::optional<vec2> pictureUv(const Shown& shown, vec2 screen) {
  for (const ScreenRect& r : shown.places) {
    const vec2 uv = (screen - r.min) / glm::max(r.max - r.min, vec2(1));
    if (glm::all(glm::greaterThanEqual(uv, vec2(0))) && glm::all(glm::lessThan(uv, vec2(1)))) return uv;
  }
  return std::nullopt;
}

void drawViewport(const ViewportRoom& room, ImVec2 panelMin, ImVec2 panelMax, bool hovered) {
  const Theme& theme = room.ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  updateColors(room.ui.messages, room.session, room.shown);
  followPicture(room.shown);
  draw->AddRectFilled(panelMin, panelMax, palette::kSurround);
  const float bar = theme.px(36);
  drawViewportBar(room, panelMin, {panelMax.x, panelMin.y + bar});

  // What is rendered does not depend on the compare bar: coming and going, it would begin the picture anew.
  vec2 lo = vec(panelMin) + vec2(0, bar), hi = vec(panelMax);
  fit(room.session, lo, hi);
  const vec2 wanted = (hi - lo) * static_cast<float>(room.settings.viewportResolution);
  room.shown.renderSize = glm::clamp(ivec2(glm::round(wanted)), ivec2(8),
                                     glm::max(room.session.document.graph().settings.size, ivec2(8)));
  float top = panelMin.y + bar, bottom = panelMax.y;
  if (room.shown.compare.on) {
    drawCompareBar(room.ui, room.shown, {panelMin.x, top}, {panelMax.x, top + bar});
    top += bar;
    bottom -= theme.px(34) + inspectorHeight(room.ui.theme, room.shown, room.settings, room.viewport) +
              snapshotStripHeight(room.ui.theme, room.shown);
    drawCompareFigures(room.ui, room.shown, {panelMin.x, bottom}, {panelMax.x, bottom + theme.px(34)});
    lo = {panelMin.x, top}, hi = {panelMax.x, bottom};
    fit(room.session, lo, hi);
  }
  // Strips below the picture make it smaller on the screen, and like the compare bar never what is rendered.
  const float strips = inspectorHeight(room.ui.theme, room.shown, room.settings, room.viewport) +
                       snapshotStripHeight(room.ui.theme, room.shown),
              figures = room.shown.compare.on ? theme.px(34) : 0;
  if (strips > 0 && !room.shown.compare.on) {
    bottom -= strips;
    lo = {panelMin.x, top}, hi = {panelMax.x, bottom};
    fit(room.session, lo, hi);
  }
  const auto& picture = room.shown.preview.picture();
  if (room.settings.showHistogram || room.shown.mode.layer.kind == view::PictureLayer::Kind::Depth)
    room.shown.mode.scan.follow(picture, 1000 * ImGui::GetTime());
  room.shown.displayed.texture =
      displayTexture(room.ui.messages, room.session, room.clock, room.shown, picture, ivec2(hi - lo), 0);
  if (const double ms = room.shown.displayed.timer.takeMs(); ms > 0) room.shown.displayed.ms = ms;
  room.shown.places = {{lo, hi}};
  const bool onPicture = hovered && ImGui::GetIO().MousePos.y > top && ImGui::GetIO().MousePos.y < bottom;
  if (!room.shown.compare.on || !room.shown.displayed.texture)
    draw->AddRectFilled(im(lo), im(hi), palette::kPictureEmpty);
  if (room.shown.displayed.texture) {
    if (room.shown.compare.on)
      drawComparison(room, lo, hi, {panelMin.x, top}, {panelMax.x, bottom}, onPicture);
    else if (room.shown.snapshots.wiping)
      drawSnapshotWipe(room, lo, hi, onPicture);
    else
      draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(room.shown.displayed.texture)),
                     im(lo), im(hi));
    room.ui.trace.note("picture",
                       fmt::format("{}x{} samples {}", picture->size.x, picture->size.y, picture->samples));
  }
  drawPickedRay(room.ui, room.shown, room.settings);
  drawOverlays(room, lo, hi, panelMax.x, onPicture);
  drawNotice(room.ui, room.session, room.shown, lo, hi);
  drawProgress(room.ui, room.session, room.shown, lo, hi);
  float y = bottom + figures;
  if (const float height = snapshotStripHeight(room.ui.theme, room.shown); height > 0) {
    drawSnapshotStrip(room.ui, room.session, room.clock, room.shown, {panelMin.x, y},
                      {panelMax.x, y + height});
    y += height;
  }
  if (const float height = inspectorHeight(room.ui.theme, room.shown, room.settings, room.viewport);
      height > 0)
    drawInspectorStrip(room, {panelMin.x, y}, {panelMax.x, y + height});
  const bool free = onPicture && !displayTakesPointer(room.shown, room.settings, room.viewport);
  drawViewportTools(room, free);
  routeViewportPointer(room, lo, hi, free);
  room.ui.trace.rect("viewport", im(lo), im(hi));
}

}  // namespace pileus::editor
