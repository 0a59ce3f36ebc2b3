#include "editor/viewport/viewport.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/lab/ray_scope.h"
#include "editor/picture/shown_camera.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/compare_bar.h"
#include "editor/viewport/compare_view.h"
#include "editor/viewport/corner_widgets.h"
#include "editor/viewport/picture_overlays.h"
#include "editor/viewport/region_view.h"
#include "editor/viewport/viewport_bar.h"
#include "renderer/view/picture.h"

namespace pileus::editor {
namespace {

/// The largest rectangle of the document's aspect inside the panel.
void fit(const Editor& editor, vec2& min, vec2& max) {
  const vec2 size = vec2(glm::max(editor.document.graph().settings.size, ivec2(1)));
  const vec2 room = glm::max(max - min, vec2(1));
  const float scale = std::min(room.x / size.x, room.y / size.y);
  const vec2 drawn = glm::max(glm::floor(size * scale), vec2(1));
  min = glm::floor(min + 0.5f * (room - drawn));
  max = min + drawn;
}

void updateColors(Editor& editor) {
  Viewport& viewport = editor.viewport;
  const std::string& wanted = editor.document.graph().settings.ocio;
  if (viewport.colorsOf == wanted) return;
  viewport.colorsOf = wanted;
  viewport.colorError.clear();
  for (Viewport::Drawn& drawn : viewport.drawn) drawn.picture.reset();
  std::filesystem::path path = wanted;
  if (!wanted.empty() && path.is_relative() && !editor.document.path().empty())
    path = editor.document.path().parent_path() / path;
  Result<std::shared_ptr<const image::ColorConfig>> config = image::ColorConfig::load(path.string());
  if (!config) {
    viewport.colorError = config.error().message;
    config = wanted.empty() ? image::ColorConfig::shipped() : image::ColorConfig::load("");
    if (!config) config = image::ColorConfig::shipped();
    editor.messages.error(
        config ? fmt::format("{}; shown with {} instead", viewport.colorError, (*config)->description())
               : viewport.colorError);
  }
  viewport.colors = config ? *config : nullptr;
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
void drawProgress(Editor& editor, vec2 lo, vec2 hi) {
  const Preview& preview = editor.preview;
  if (preview.settled() || shownView(editor).empty()) return;
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
  const Theme& theme = editor.theme;
  // In compare mode the upper corners hold the names of the sides.
  const float below = editor.compare.on ? theme.px(28) : 0;
  drawChip(theme, lo + vec2(theme.space(2), theme.space(2) + below), text, palette::kText);
  editor.trace.note("chip", text);
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

void drawNotice(Editor& editor, vec2 lo, vec2 hi) {
  const Theme& theme = editor.theme;
  const Preview& preview = editor.preview;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (!preview.error().empty()) {
    draw->AddRectFilled(im(lo), im(hi), palette::kVeil);
    drawCentered(theme, lo, hi, icon::kError, palette::kError, "No new picture", preview.error());
    editor.trace.note("viewport error", preview.error());
  } else if (shownView(editor).empty()) {
    drawCentered(theme, lo, hi, icon::kPicture, palette::kTextDim, "Nothing to show yet",
                 "Add a View node and link an image to it to see it here.");
  } else if (!preview.picture() && preview.settled()) {
    drawCentered(theme, lo, hi, icon::kPicture, palette::kTextDim, "No image is linked",
                 "Link a Render node's image to " + shownView(editor) + ".");
  }
}

/// What the shown layer is, and that the colours are not those of the file where they cannot be.
void drawPictureNotes(Editor& editor, vec2 lo, vec2 hi) {
  const Theme& theme = editor.theme;
  const Viewport& viewport = editor.viewport;
  const auto& picture = editor.preview.picture();
  vec2 at(lo.x + theme.space(2), hi.y - theme.space(2) - theme.small->FontSize - theme.px(8));
  if (picture && picture->layer.kind == view::PictureLayer::Kind::Depth && viewport.mode.scan.result()) {
    const vec2 range = viewport.mode.scan.result()->depth;
    const std::string text = range.y > range.x
                                 ? fmt::format("Depth {:.4g} (white) to {:.4g} m (dark)", range.x, range.y)
                                 : "Depth: nothing there";
    drawChip(theme, at, text, palette::kText);
    editor.trace.note("viewport depth", text);
    at.y -= theme.small->FontSize + theme.px(12);
  }
  if (viewport.colorError.empty() || !viewport.colors) return;
  const std::string text = fmt::format("{}  Colours as {}", icon::kWarning, viewport.colors->description());
  drawChip(theme, at, text, palette::kWarning);
  editor.trace.note("viewport colours", viewport.colorError);
  if (ImGui::IsMouseHoveringRect(im(at), {at.x + textWidth(theme.small, text), at.y + theme.px(22)}))
    tooltip(theme, viewport.colorError);
}

/// `right`: of the panel. What stands at the right edge stands beside the picture where there is room.
void drawOverlays(Editor& editor, vec2 lo, vec2 hi, float right, bool hovered) {
  const bool plain = !editor.compare.on;
  if (plain) drawRegionView(editor, lo, hi, hovered);
  drawInspectorMarks(editor, hovered);
  const auto [first, last] = shownCorners(editor.viewport);
  if (editor.viewport.mode.falseColor && !(plain && !editor.viewport.texture))
    drawBandLegend(editor, first, last, right);
  if (editor.settings.showHistogram) drawHistogram(editor, first, {right, last.y});
  drawPictureNotes(editor, lo, hi);
  if (editor.settings.showHud) drawHud(editor, lo, hi, lo.y + editor.theme.px(editor.compare.on ? 68 : 40));
}

}  // namespace

unsigned displayTexture(Editor& editor, const std::shared_ptr<const view::Picture>& picture, ivec2 size,
                        std::size_t slot) {
  Viewport& viewport = editor.viewport;
  Viewport::Drawn& drawn = viewport.drawn.at(slot);
  if (!picture || !viewport.colors) {
    drawn.picture.reset();
    return 0;
  }
  view::DisplaySettings settings = displaySettings(editor);
  if (picture->layer.kind == view::PictureLayer::Kind::Depth) {
    const view::ScanResult* scan = viewport.mode.scan.result();
    settings.range = scan && scan->depth.y > scan->depth.x ? scan->depth : vec2(0, 1);
  }
  if (drawn.picture == picture && drawn.fraction == picture->fraction && drawn.samples == picture->samples &&
      drawn.size == size && drawn.settings == settings && drawn.texture)
    return drawn.texture;
  const auto draw = [&](const view::DisplaySettings& s) {
    if (slot == 0) viewport.displayTimer.begin();
    const Result<unsigned> result = viewport.display.draw(picture->color, picture->size, size,
                                                          *viewport.colors, s, static_cast<int>(slot));
    if (slot == 0) viewport.displayTimer.end();
    return result;
  };
  Result<unsigned> texture = draw(settings);
  if (!texture && viewport.colorError != texture.error().message) {
    // A display, view or look this configuration does not have: say so, and show its default.
    viewport.colorError = texture.error().message;
    const std::string display = viewport.colors->defaultDisplay();
    editor.messages.warn(fmt::format("{}; shown as {}, {} instead", viewport.colorError, display,
                                     viewport.colors->defaultView(display)));
  }
  if (!texture) {
    view::DisplaySettings plain = settings;
    plain.display.clear(), plain.view.clear(), plain.look.clear();
    texture = draw(plain);
  } else if (slot == 0) {
    viewport.colorError.clear();
  }
  drawn = {picture, picture->fraction, picture->samples, size, settings, texture ? *texture : 0};
  return drawn.texture;
}

bool displayTakesPointer(const Editor& editor) {
  const Viewport& v = editor.viewport;
  return v.mode.region.drawing || v.mode.region.from || v.inspector.draggingArea || v.snapshots.line.held ||
         editor.compare.draggingWipe ||
         (editor.settings.showInspector && ImGui::GetIO().KeyCtrl && v.drag == Viewport::Drag::None);
}

bool displayWantsFrame(const Editor& editor) {
  return editor.viewport.mode.scan.busy() ||
         (editor.settings.showInspector && editor.viewport.inspector.busy());
}

std::optional<vec2> pictureUv(const Viewport& viewport, vec2 screen) {
  for (const Viewport::Rect& r : viewport.shown) {
    const vec2 uv = (screen - r.min) / glm::max(r.max - r.min, vec2(1));
    if (glm::all(glm::greaterThanEqual(uv, vec2(0))) && glm::all(glm::lessThan(uv, vec2(1)))) return uv;
  }
  return std::nullopt;
}

void drawViewport(Editor& editor, ImVec2 panelMin, ImVec2 panelMax, bool hovered) {
  const Theme& theme = editor.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  Viewport& viewport = editor.viewport;
  updateColors(editor);
  followPicture(editor);
  draw->AddRectFilled(panelMin, panelMax, palette::kSurround);
  const float bar = theme.px(36);
  drawViewportBar(editor, panelMin, {panelMax.x, panelMin.y + bar});

  // What is rendered does not depend on the compare bar: coming and going, it would begin the picture anew.
  vec2 lo = vec(panelMin) + vec2(0, bar), hi = vec(panelMax);
  fit(editor, lo, hi);
  const vec2 wanted = (hi - lo) * static_cast<float>(editor.settings.viewportResolution);
  viewport.renderSize = glm::clamp(ivec2(glm::round(wanted)), ivec2(8),
                                   glm::max(editor.document.graph().settings.size, ivec2(8)));
  float top = panelMin.y + bar, bottom = panelMax.y;
  if (editor.compare.on) {
    drawCompareBar(editor, {panelMin.x, top}, {panelMax.x, top + bar});
    top += bar;
    bottom -= theme.px(34) + inspectorHeight(editor) + snapshotStripHeight(editor);
    drawCompareFigures(editor, {panelMin.x, bottom}, {panelMax.x, bottom + theme.px(34)});
    lo = {panelMin.x, top}, hi = {panelMax.x, bottom};
    fit(editor, lo, hi);
  }
  // Strips below the picture make it smaller on the screen, and like the compare bar never what is rendered.
  const float strips = inspectorHeight(editor) + snapshotStripHeight(editor),
              figures = editor.compare.on ? theme.px(34) : 0;
  if (strips > 0 && !editor.compare.on) {
    bottom -= strips;
    lo = {panelMin.x, top}, hi = {panelMax.x, bottom};
    fit(editor, lo, hi);
  }
  const auto& picture = editor.preview.picture();
  if (editor.settings.showHistogram || viewport.mode.layer.kind == view::PictureLayer::Kind::Depth)
    viewport.mode.scan.follow(picture, 1000 * ImGui::GetTime());
  viewport.texture = displayTexture(editor, picture, ivec2(hi - lo), 0);
  if (const double ms = viewport.displayTimer.takeMs(); ms > 0) viewport.displayMs = ms;
  viewport.shown = {{lo, hi}};
  const bool onPicture = hovered && ImGui::GetIO().MousePos.y > top && ImGui::GetIO().MousePos.y < bottom;
  if (!editor.compare.on || !viewport.texture) draw->AddRectFilled(im(lo), im(hi), palette::kPictureEmpty);
  if (viewport.texture) {
    if (editor.compare.on)
      drawComparison(editor, lo, hi, {panelMin.x, top}, {panelMax.x, bottom}, onPicture);
    else if (viewport.snapshots.wiping)
      drawSnapshotWipe(editor, lo, hi, onPicture);
    else
      draw->AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(viewport.texture)), im(lo),
                     im(hi));
    editor.trace.note("picture",
                      fmt::format("{}x{} samples {}", picture->size.x, picture->size.y, picture->samples));
  }
  drawPickedRay(editor);
  drawOverlays(editor, lo, hi, panelMax.x, onPicture);
  drawNotice(editor, lo, hi);
  drawProgress(editor, lo, hi);
  float y = bottom + figures;
  if (const float height = snapshotStripHeight(editor); height > 0) {
    drawSnapshotStrip(editor, {panelMin.x, y}, {panelMax.x, y + height});
    y += height;
  }
  if (const float height = inspectorHeight(editor); height > 0)
    drawInspectorStrip(editor, {panelMin.x, y}, {panelMax.x, y + height});
  const bool free = onPicture && !displayTakesPointer(editor);
  drawViewportTools(editor, free);
  routeViewportPointer(editor, lo, hi, free);
  editor.trace.rect("viewport", im(lo), im(hi));
}

}  // namespace pileus::editor
