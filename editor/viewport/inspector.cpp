#include "editor/viewport/inspector.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_bar.h"
#include "editor/viewport/viewport_room.h"

namespace pileus::editor {
namespace {

constexpr float kRow = 22;  // design pixels

/// A picture that is inspected and what it is called.
struct Side {
  std::shared_ptr<const view::Picture> picture;
  std::string name;
};

std::array<Side, 2> sidesOf(const Shown& shown) {
  std::array<Side, 2> sides{Side{shown.preview.picture(), {}}, Side{}};
  const Snapshots& s = shown.snapshots;
  if (s.wiping) {
    const auto side = [&](int i) {
      return i == Snapshots::kPicture
                 ? Side{shown.preview.picture(), "Picture"}
                 : Side{s.all[static_cast<std::size_t>(i)].picture, s.all[static_cast<std::size_t>(i)].name};
    };
    return {side(s.left), side(s.right)};
  }
  if (!shown.compare.on) return sides;
  sides[0].name = "Picture";
  if (const truth::ComparePass* pass = shown.compare.shown()) sides[1] = {pass->truth(), "Truth"};
  return sides;
}

int rowsOf(const Shown& shown, const Viewport& viewport) {
  const int sides = shown.compare.on || shown.snapshots.wiping ? 2 : 1;
  return sides * (viewport.inspector.area() ? 3 : 1);
}

/// Writes cells of fixed widths from the left, so that figures stay in place while they change.
struct Row {
  const Theme& theme;
  vec2 at;
  float right;
  bool room(float width) const { return at.x + width <= right; }
  void text(std::string_view text, ImU32 ink, float after) {
    const float w = textWidth(theme.small, text);
    if (room(w)) drawText(ImGui::GetWindowDrawList(), theme.small, at, ink, text, w + 1);
    at.x += w + after;
  }
  void figure(std::string_view text, ImU32 ink, int characters) {
    const float cell =
        theme.mono->CalcTextSizeA(theme.mono->FontSize, FLT_MAX, 0, "0").x * static_cast<float>(characters);
    const float w = textWidth(theme.mono, text);
    if (room(cell))
      drawText(
          ImGui::GetWindowDrawList(), theme.mono,
          {at.x + std::max(cell - w, 0.0f), at.y - 0.5f * (theme.mono->FontSize - theme.small->FontSize)},
          ink, text, std::max(cell, w) + 1);
    at.x += std::max(cell, w) + theme.space(3);
  }
};

ImU32 inkOf(float value) { return std::isfinite(value) ? palette::kText : palette::kError; }

/// What the display makes of a value, 0..1.
std::optional<vec3> displayed(const Session& session, const Clock& clock, const Shown& shown,
                              const vec4& value) {
  const view::DisplaySettings s = displaySettings(session, clock, shown);
  if (!shown.displayed.colors || !std::isfinite(value.r) || !std::isfinite(value.g) ||
      !std::isfinite(value.b))
    return std::nullopt;
  vec4 p(vec3(value) * static_cast<float>(std::exp2(s.exposure)), 1);
  if (!s.raw && !shown.displayed.colors->applyCpu(s.display, s.view, &p.x, 1, s.look) &&
      !shown.displayed.colors->applyCpu("", "", &p.x, 1))
    return std::nullopt;
  for (int c = 0; c < 3; ++c)
    p[c] = std::clamp(std::pow(std::max(p[c], 0.0f), static_cast<float>(1 / std::max(s.gamma, 1e-3))), 0.0f,
                      1.0f);
  return vec3(p);
}

void channels(Row& row, const vec4& value) {
  static constexpr const char* kNames[] = {"R", "G", "B", "A"};
  const ImU32 inks[] = {palette::kAxisX, palette::kAxisY, palette::kAxisZ, palette::kTextDim};
  for (int c = 0; c < 4; ++c) {
    row.text(kNames[c], inks[c], row.theme.px(2));
    row.figure(figureText(value[c]), inkOf(value[c]), 8);
  }
}

void drawLight(const Session& session, const Clock& clock, const Shown& shown, Row& row, const vec4& value) {
  channels(row, value);
  row.text(shown.displayed.colors ? shown.displayed.colors->workingSpace() : "", palette::kTextFaint,
           row.theme.space(4));
  const float y = glm::dot(vec3(value), view::kLuminance);
  row.text("Y", palette::kTextDim, row.theme.px(2));
  row.figure(figureText(y), inkOf(y), 8);
  row.figure(stopsText(y), palette::kText, 12);
  const auto seen = displayed(session, clock, shown, value);
  if (!seen || !row.room(row.theme.px(120))) return;
  const vec3 c = *seen * 255.0f;
  ImGui::GetWindowDrawList()->AddRectFilled(
      {row.at.x, row.at.y + row.theme.px(1)}, {row.at.x + row.theme.px(14), row.at.y + row.theme.px(15)},
      IM_COL32(static_cast<int>(c.r), static_cast<int>(c.g), static_cast<int>(c.b), 255), row.theme.px(3));
  row.at.x += row.theme.px(20);
  row.text("shown", palette::kTextFaint, row.theme.px(4));
  row.figure(fmt::format("{:.3f} {:.3f} {:.3f}", seen->r, seen->g, seen->b), palette::kText, 17);
}

void drawValue(const Session& session, const Clock& clock, const Shown& shown, Row& row,
               const view::Picture& picture, const vec4& value) {
  if (picture.layer.kind != view::PictureLayer::Kind::Depth)
    return drawLight(session, clock, shown, row, value);
  row.text("Depth", palette::kTextDim, row.theme.px(4));
  row.figure(value.a > 0 || !std::isfinite(value.r) ? figureText(value.r) + " m" : "nothing", inkOf(value.r),
             12);
  row.text("A", palette::kTextDim, row.theme.px(2));
  row.figure(figureText(value.a), inkOf(value.a), 8);
}

std::string placeText(const PixelProbe& probe) {
  const ivec2 at = probe.pixel(), size = probe.size();
  if (size == ivec2(1)) return fmt::format("{:>4},{:>4}", at.x, at.y);
  return fmt::format("{} \xc3\x97 {} at {}, {}", size.x, size.y, at.x, at.y);
}

void drawSide(const ViewportRoom& room, const Side& side, const PixelProbe& probe, vec2& at, float right,
              bool second) {
  const Theme& theme = room.ui.theme;
  const TexelFigures& f = probe.figures();
  const bool area = room.viewport.inspector.area();
  const auto line = [&](std::string_view head, const vec4& value, bool place) {
    Row row{theme, {at.x, at.y + theme.px(0.5f * kRow) - 0.5f * theme.small->FontSize}, right};
    if (!side.name.empty()) {
      const float column = theme.px(64);
      drawText(ImGui::GetWindowDrawList(), theme.small, row.at, second ? palette::kSelect : palette::kAccent,
               side.name, column - theme.space(1));
      row.at.x += column;
    }
    if (!head.empty()) {
      drawText(ImGui::GetWindowDrawList(), theme.small, row.at, palette::kTextDim, head, theme.px(40));
      row.at.x += theme.px(40);
    }
    if (place && !area) row.figure(placeText(probe), palette::kTextDim, 9);
    if (side.picture) drawValue(room.session, room.clock, room.shown, row, *side.picture, value);
    if (place && area) {
      row.text(placeText(probe), palette::kTextFaint, theme.space(3));
      if (f.nan) row.text(fmt::format("{} nan", f.nan), palette::kError, theme.space(2));
      if (f.inf) row.text(fmt::format("{} inf", f.inf), palette::kError, 0);
    }
    at.y += theme.px(kRow);
  };
  if (!side.picture || !probe.known()) {
    line("", vec4(0), false);
    return;
  }
  if (!area) return line("", f.first, true);
  line("min", f.min, false);
  line("mean", f.mean, true);
  line("max", f.max, false);
}

void traceValue(Ui& ui, const Viewport& viewport, const PixelProbe& probe, const char* name) {
  const TexelFigures& f = probe.figures();
  const vec4 v = viewport.inspector.area() ? f.mean : f.first;
  ui.trace.note(name, fmt::format("{} {} {} {} {} {}", probe.pixel().x, probe.pixel().y, v.r, v.g, v.b, v.a));
}

}  // namespace

void toggleInspector(Settings& settings, Viewport& viewport) {
  settings.showInspector = !settings.showInspector;
  if (!settings.showInspector)
    viewport.inspector.areaFrom.reset(), viewport.inspector.areaTo.reset(), viewport.inspector.pinned.reset();
}

float inspectorHeight(const Theme& theme, const Shown& shown, const Settings& settings,
                      const Viewport& viewport) {
  if (!settings.showInspector) return 0;
  return theme.px(kRow) * static_cast<float>(rowsOf(shown, viewport)) + theme.px(6);
}

void drawInspectorMarks(const Theme& theme, const Shown& shown, const Settings& settings, Viewport& viewport,
                        bool hovered) {
  Inspector& in = viewport.inspector;
  const ImGuiIO& io = ImGui::GetIO();
  if (!settings.showInspector) return;
  const std::optional<vec2> under =
      hovered || in.draggingArea ? pictureUv(shown, vec(io.MousePos)) : std::nullopt;
  in.pointer = under ? std::optional(dvec2(*under)) : std::nullopt;
  const float reach = theme.px(4);
  if (hovered && under && ImGui::IsMouseClicked(0)) {
    if (io.KeyCtrl)
      in.areaFrom = in.areaTo = dvec2(*under), in.draggingArea = true, in.pinned.reset();
    else
      in.pressed = !io.KeyAlt && !io.KeyShift && !shown.ray.picking && !shown.mode.region.drawing;
  }
  if (in.draggingArea && under) in.areaTo = dvec2(*under);
  if (!ImGui::IsMouseDown(0)) {
    const bool click = io.MouseDragMaxDistanceSqr[0] < reach * reach;
    if (in.draggingArea && click) in.areaFrom.reset(), in.areaTo.reset();  // Ctrl+click takes the area away
    if (in.pressed && click && under && hovered) {
      in.areaFrom.reset(), in.areaTo.reset();
      const dvec2 size = shown.places.empty() ? dvec2(1) : dvec2(shown.places[0].max - shown.places[0].min);
      const bool again =
          in.pinned && glm::length((*in.pinned - dvec2(*under)) * size) < static_cast<double>(theme.px(7));
      in.pinned = again ? std::nullopt : std::optional(dvec2(*under));
    }
    in.draggingArea = in.pressed = false;
  }
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (const ScreenRect& r : shown.places) {
    const auto at = [&](dvec2 uv) { return r.min + vec2(uv) * (r.max - r.min); };
    if (in.pinned) {
      const vec2 p = glm::round(at(*in.pinned));
      const float arm = theme.px(7), gap = theme.px(2);
      for (const vec2 d : {vec2(1, 0), vec2(-1, 0), vec2(0, 1), vec2(0, -1)}) {
        draw->AddLine(im(p + d * gap), im(p + d * arm), palette::kHandleEdge, 3);
        draw->AddLine(im(p + d * gap), im(p + d * arm), palette::kHandle, 1);
      }
    }
    if (!in.area()) continue;
    const vec2 a = at(glm::min(*in.areaFrom, *in.areaTo)), b = at(glm::max(*in.areaFrom, *in.areaTo));
    draw->AddRect({a.x - 1, a.y - 1}, {b.x + 1, b.y + 1}, palette::kHandleEdge);
    draw->AddRect(im(a), im(b), palette::kHandle);
  }
}

void drawInspectorStrip(const ViewportRoom& room, vec2 lo, vec2 hi) {
  const Theme& theme = room.ui.theme;
  Inspector& in = room.viewport.inspector;
  ImGui::GetWindowDrawList()->AddRectFilled(im(lo), im(hi), palette::kPanel);
  const auto sides = sidesOf(room.shown);
  const std::optional<dvec2> from = in.area() ? in.areaFrom : in.pinned ? in.pinned : in.pointer;
  const dvec2 to = in.area() ? *in.areaTo : from.value_or(dvec2(0));
  const bool fixed = in.area() || in.pinned;
  vec2 at(lo.x + theme.space(3), lo.y + theme.px(3));
  float right = hi.x - theme.space(3);
  if (fixed) {
    const float side = theme.px(18);
    right -= side + theme.space(1);
    ImGui::SetCursorScreenPos({right + theme.space(1), std::round(lo.y + 0.5f * (hi.y - lo.y - side))});
    const ImVec2 cross = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("##unpin", {side, side}))
      in.pinned.reset(), in.areaFrom.reset(), in.areaTo.reset();
    room.ui.trace.item("inspector/unpin");
    const bool hovered = ImGui::IsItemHovered();
    drawText(ImGui::GetWindowDrawList(), theme.small,
             {cross.x + 0.5f * (side - textWidth(theme.small, icon::kTimes)),
              cross.y + 0.5f * (side - theme.small->FontSize)},
             hovered ? palette::kText : palette::kTextDim, icon::kTimes, side);
    if (hovered) tooltip(theme, "Follow the pointer again");
  }
  if (!from) {
    const std::string_view hint = "Point at the picture. Click pins a pixel, Ctrl+drag measures an area.";
    drawText(ImGui::GetWindowDrawList(), theme.small,
             {at.x, at.y + theme.px(0.5f * kRow) - 0.5f * theme.small->FontSize}, palette::kTextFaint, hint,
             right - at.x);
    return;
  }
  const bool two = room.shown.compare.on || room.shown.snapshots.wiping;
  for (std::size_t i = 0; i < (two ? 2u : 1u); ++i) {
    in.probes[i].follow(sides[i].picture, *from, to);
    drawSide(room, sides[i], in.probes[i], at, right, i == 1);
    if (in.probes[i].known())
      traceValue(room.ui, room.viewport, in.probes[i], i == 0 ? "inspector" : "inspector other");
  }
  room.ui.trace.rect("inspector", im(lo), im(hi));
}

}  // namespace pileus::editor
