#include "editor/viewport/overlays.h"

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
#include "editor/viewport/brick_overlay.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"

namespace pileus::editor {
namespace {

constexpr int kCirclePoints = 48;

struct Pen {
  const Theme& theme;
  const Projection& view;
  ImDrawList* draw;

  void line(const dvec3& a, const dvec3& b, ImU32 ink, float width = 1) const {
    if (const auto s = view.segment(a, b))
      draw->AddLine(im(s->first), im(s->second), ink, width * theme.scale);
  }
  /// Of [lo, hi] in the space that `m` places.
  void box(const dmat4& m, const dvec3& lo, const dvec3& hi, ImU32 ink, float width = 1) const {
    const Box3 b{lo, hi};
    for (int i = 0; i < 8; ++i)
      for (int bit = 1; bit < 8; bit *= 2)
        if (!(i & bit))
          line(dvec3(m * dvec4(b.corner(i), 1)), dvec3(m * dvec4(b.corner(i | bit), 1)), ink, width);
  }
  void circle(const dvec3& center, const dvec3& u, const dvec3& v, ImU32 ink) const {
    for (int i = 0; i < kCirclePoints; ++i) {
      const double a = 2 * kPi * i / kCirclePoints, b = 2 * kPi * (i + 1) / kCirclePoints;
      line(center + std::cos(a) * u + std::sin(a) * v, center + std::cos(b) * u + std::sin(b) * v, ink);
    }
  }
};

bool chosen(const Session& session, const std::vector<std::string>& chain) {
  return std::any_of(chain.begin(), chain.end(), [&](const std::string& n) { return selects(session, n); });
}

void drawVolumes(const Session& session, const Shown& shown, const Settings& settings,
                 const Viewport& viewport, const Pen& pen) {
  const Overlays& o = settings.view.overlays;
  for (const PlacedVolume& v : shown.scene.volumes) {
    const bool selected = chosen(session, v.chain);
    if (!o.bounds && !(selected && viewport.tools.mode != GizmoMode::Select)) continue;
    const ImU32 ink = selected ? faded(palette::kSelect, 0.8f) : faded(palette::kVolumeSocket, 0.55f);
    const dmat4& m = v.instance.worldFromLocal;
    if (v.instance.shape == volume::Shape::Ball) {
      for (int a = 0; a < 3; ++a) pen.circle(dvec3(m[3]), dvec3(m[a]), dvec3(m[(a + 1) % 3]), ink);
    } else {
      const Box3 box = volume::localBounds(v.instance);
      pen.box(m, box.min, box.max, ink);
    }
  }
}

void drawSolids(const Session& session, const Shown& shown, const Settings& settings,
                const Viewport& viewport, const Pen& pen) {
  for (const PlacedSolid& s : shown.scene.solids) {
    const bool selected = chosen(session, s.chain);
    if (!settings.view.overlays.solids && !(selected && viewport.tools.mode != GizmoMode::Select)) continue;
    const ImU32 ink = selected ? faded(palette::kSelect, 0.8f) : faded(palette::kSolidSocket, 0.7f);
    const double half = s.solid.shape == scene::SolidShape::Plane ? 0 : 0.5;
    pen.box(s.solid.worldFromLocal, {-0.5, -half, -0.5}, {0.5, half, 0.5}, ink);
  }
}

/// `handled`: the path of the node whose handles are shown.
void drawLight(Ui& ui, const Session& session, const Shown& shown, const Pen& pen, const PlacedLight& light,
               const std::string& handled) {
  const Theme& theme = ui.theme;
  const bool selected = selects(session, light.node), held = light.node == handled;
  const auto mark = lightMark(ui.theme, shown, light, pen.view);
  if (!mark || light.node == shown.look.light) return;
  const GizmoTarget& t = light.target;
  const ImU32 ink = selected ? palette::kSelect : palette::kLightSocket;
  if (t.sun && !held) {
    // Its rays come from there.
    const auto center = pen.view.screen(sunCenter(shown.scene, pen.view));
    if (center && glm::length(*center - *mark) > theme.px(24)) {
      const vec2 u = glm::normalize(*center - *mark), n(-u.y, u.x);
      const vec2 from = *mark + theme.px(13) * u, to = *mark + theme.px(34) * u;
      pen.draw->AddLine(im(from), im(to), faded(ink, 0.8f), 1.5f * theme.scale);
      for (const float side : {1.0f, -1.0f})
        pen.draw->AddLine(im(to), im(to - theme.px(6) * u + side * theme.px(4) * n), faded(ink, 0.8f),
                          1.5f * theme.scale);
    }
  } else if (t.aims && t.hasCone && !held) {
    const dvec3 along = t.aim - t.position;
    const double length = glm::length(along), half = 0.5 * glm::radians(t.cone);
    if (length > 0) {
      const dvec3 axis = along / length, u = across(axis), v = glm::cross(axis, u);
      const double reach = length * std::cos(half), r = length * std::sin(half);
      pen.circle(t.position + reach * axis, r * u, r * v, faded(ink, 0.5f));
      for (int k = 0; k < 4; ++k) {
        const double a = 0.5 * kPi * k;
        pen.line(t.position, t.position + reach * axis + r * (std::cos(a) * u + std::sin(a) * v),
                 faded(ink, 0.35f));
      }
    }
  }
  const std::string name = std::string("light/") + light.node;
  ui.trace.rect(name, im(*mark - theme.px(9)), im(*mark + theme.px(9)));
  if (t.sun && held) return;  // the gizmo draws its disc
  pen.draw->AddCircleFilled(im(*mark), theme.px(10.5f), palette::kHandleEdge);
  pen.draw->AddCircle(im(*mark), theme.px(9.5f), ink, 0, 1.5f * theme.scale);
  const char* sign = t.sun ? icon::kSun : t.hasCone ? icon::kEye : icon::kCircle;
  const float width = textWidth(theme.small, sign);
  drawText(pen.draw, theme.small, {mark->x - 0.5f * width, mark->y - 0.5f * theme.small->FontSize}, ink, sign,
           width + 4);
}

/// Lines of the ground a decade apart, by how far the ground in view is.
void drawGrid(Ui& ui, const Pen& pen) {
  const Projection& view = pen.view;
  const vec2 middle = 0.5f * (view.min() + view.max());
  const auto seen = onPlane(view.ray(middle), dvec3(0), {0, 1, 0});
  const double height = std::max(std::abs(view.eye().y), 1e-3);
  const double distance =
      seen ? std::clamp(glm::length(*seen - view.eye()), height, 20 * height) : 5 * height;
  const double step = std::pow(10.0, std::clamp(std::floor(std::log10(distance * 0.25)), -2.0, 5.0));
  dvec3 about = view.eye() + distance * view.forward();
  about = step * 10 * glm::round(about / (step * 10));
  constexpr int kLines = 20;
  const double reach = kLines * step;
  for (int i = -kLines; i <= kLines; ++i)
    for (const int axis : {0, 2}) {
      dvec3 from = about, to = about;
      from.y = to.y = 0;
      from[axis] = to[axis] = about[axis] + i * step;
      from[2 - axis] -= reach, to[2 - axis] += reach;
      const bool zero = std::abs(from[axis]) < 0.5 * step, strong = i % 10 == 0;
      // The line x = 0 is the Z axis, and the other way round.
      const ImU32 ink = zero ? faded(axis == 0 ? palette::kAxisZ : palette::kAxisX, 0.8f)
                             : faded(palette::kGhost, strong ? 0.5f : 0.22f);
      pen.line(from, to, ink);
    }
  if (ui.trace.on()) ui.trace.note("overlay grid", fmt::format("{:g} m", step));
}

void drawSafeFrame(const Pen& pen) {
  const vec2 lo = pen.view.min(), hi = pen.view.max(), size = hi - lo;
  for (const float part : {0.05f, 0.1f})
    pen.draw->AddRect(im(glm::round(lo + part * size)), im(glm::round(hi - part * size)),
                      faded(palette::kHandle, part < 0.07f ? 0.6f : 0.35f), 0, 0, pen.theme.scale);
  const vec2 c = glm::round(0.5f * (lo + hi));
  const float arm = pen.theme.px(9);
  pen.draw->AddLine({c.x - arm, c.y}, {c.x + arm, c.y}, faded(palette::kHandle, 0.6f), pen.theme.scale);
  pen.draw->AddLine({c.x, c.y - arm}, {c.x, c.y + arm}, faded(palette::kHandle, 0.6f), pen.theme.scale);
}

}  // namespace

void drawSceneOverlays(const ViewportRoom& room, const Projection& view) {
  const Overlays& o = room.settings.view.overlays;
  const Pen pen{room.ui.theme, view, ImGui::GetWindowDrawList()};
  if (o.grid) drawGrid(room.ui, pen);
  if (o.bricks) drawBricks(room.ui, room.shown, view);
  drawVolumes(room.session, room.shown, room.settings, room.viewport, pen);
  drawSolids(room.session, room.shown, room.settings, room.viewport, pen);
  const std::string handled = handledNode(room.session, room.viewport.tools.inside, room.clock.frame);
  if (o.lights)
    for (const PlacedLight& light : room.shown.scene.lights)
      drawLight(room.ui, room.session, room.shown, pen, light, handled);
  if (o.safeFrame) drawSafeFrame(pen);
}

}  // namespace pileus::editor
