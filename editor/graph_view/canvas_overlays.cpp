#include "editor/graph_view/canvas_overlays.h"

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/graph_room.h"
#include "editor/graph_view/node_footer.h"
#include "editor/graph_view/node_status.h"
#include "editor/graph_view/scopes.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

struct Crumb {
  std::string text;
  vec2 lo{0}, hi{0};
};

/// "Document > Group > Inner" at the upper left; empty in the document itself.
std::vector<Crumb> crumbs(const Theme& theme, const Session& session, const CanvasView& view) {
  std::vector<Crumb> all;
  const std::vector<std::string>& scope = session.document.scope();
  if (scope.empty()) return all;
  vec2 pen = view.min + vec2(theme.px(10), theme.px(8));
  const auto add = [&](const std::string& text) {
    const vec2 size(textWidth(theme.body, text) + theme.px(16), theme.body->FontSize + theme.px(8));
    all.push_back({text, pen, pen + size});
    pen.x += size.x + theme.px(14);
  };
  add(documentName(session));
  for (const std::string& group : scope) add(group);
  return all;
}

bool inside(vec2 p, vec2 lo, vec2 hi) { return p.x >= lo.x && p.y >= lo.y && p.x < hi.x && p.y < hi.y; }

bool updateCrumbs(const Theme& theme, Session& session, Canvas& canvas, const CanvasView& view,
                  vec2 pointer) {
  const std::vector<Crumb> all = crumbs(theme, session, view);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!inside(pointer, all[i].lo, all[i].hi)) continue;
    canvas.overlays.crumb = static_cast<int>(i);
    if (ImGui::IsMouseClicked(0) && i + 1 < all.size()) {
      std::vector<std::string> scope = session.document.scope();
      scope.resize(i);
      goToScope(session, canvas, scope);
    }
    return true;
  }
  return false;
}

bool updateFollowers(Session& session, const Shown& shown, Canvas& canvas, const CanvasView& view,
                     const Layout& layout, vec2 pointer) {
  if (!view.level.text) return false;
  for (auto place = layout.nodes.rbegin(); place != layout.nodes.rend(); ++place) {
    if (inside(pointer, view.screen(place->min), view.screen(place->max))) return false;
    const nodes::NodeStatus& status = statusOf(session, shown, place->name);
    if (footerKind(status) != FooterKind::Follower || !footerRect(view, *place, status).contains(pointer))
      continue;
    canvas.overlays.follower = place->name;
    if (!ImGui::IsMouseClicked(0)) return true;
    const std::string source = sourceOfError(session, shown, canvas, layout, place->name);
    if (source.empty()) return true;
    session.selectedLink.reset();
    session.document.select({source});
    canvas.frameSelection = true;
    return true;
  }
  return false;
}

}  // namespace

bool updateOverlays(const GraphRoom& room, const CanvasView& view, const Layout& layout, bool hovered) {
  CanvasOverlays& overlays = room.canvas.overlays;
  overlays = {};
  const vec2 pointer = vec(ImGui::GetIO().MousePos);
  overlays.covered =
      updateMinimap(room.ui.theme, room.session, room.settings, room.canvas, view, layout, hovered);
  if (!overlays.covered && hovered && !room.canvas.interaction.busy())
    overlays.covered = updateCrumbs(room.ui.theme, room.session, room.canvas, view, pointer) ||
                       updateFollowers(room.session, room.shown, room.canvas, view, layout, pointer);
  if (!overlays.follower.empty() || (overlays.crumb >= 0)) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  return overlays.covered;
}

void drawOverlays(Ui& ui, const Session& session, const Settings& settings, const Canvas& canvas,
                  const CanvasView& view, const Layout& layout) {
  const Theme& theme = ui.theme;
  const std::vector<Crumb> all = crumbs(ui.theme, session, view);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Crumb& c = all[i];
    const bool last = i + 1 == all.size(), over = canvas.overlays.crumb == static_cast<int>(i);
    view.draw->AddRectFilled(
        im(c.lo), im(c.hi), over && !last ? palette::kButtonHover : faded(palette::kBar, 0.92f), theme.px(5));
    drawText(view.draw, theme.body, c.lo + vec2(theme.px(8), theme.px(4)),
             last ? palette::kTextStrong : palette::kTextDim, c.text, 1e4f);
    if (!last)
      drawText(view.draw, theme.small, {c.hi.x + theme.px(2), c.lo.y + theme.px(5)}, palette::kTextFaint,
               icon::kChevronRight, 1e3f);
    if (ui.trace.on()) {
      ui.trace.rect("crumb/" + std::to_string(i), im(c.lo), im(c.hi));
      ui.trace.note("crumb/" + std::to_string(i), c.text);
    }
  }
  drawMinimap(ui, session, settings, canvas, view, layout);
}

}  // namespace pileus::editor
