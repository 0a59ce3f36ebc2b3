#include "editor/graph_view/canvas_overlays.h"

#include "editor/app/editor.h"
#include "editor/document/files.h"
#include "editor/graph_view/node_footer.h"
#include "editor/graph_view/node_status.h"
#include "editor/graph_view/scopes.h"
#include "editor/toolkit/icons.h"

namespace pileus::editor {
namespace {

struct Crumb {
  std::string text;
  vec2 lo{0}, hi{0};
};

/// "Document > Group > Inner" at the upper left; empty in the document itself.
std::vector<Crumb> crumbs(const Editor& editor, const CanvasView& view) {
  std::vector<Crumb> all;
  const std::vector<std::string>& scope = editor.document.scope();
  if (scope.empty()) return all;
  const Theme& theme = editor.theme;
  vec2 pen = view.min + vec2(theme.px(10), theme.px(8));
  const auto add = [&](const std::string& text) {
    const vec2 size(textWidth(theme.body, text) + theme.px(16), theme.body->FontSize + theme.px(8));
    all.push_back({text, pen, pen + size});
    pen.x += size.x + theme.px(14);
  };
  add(documentName(editor));
  for (const std::string& group : scope) add(group);
  return all;
}

bool inside(vec2 p, vec2 lo, vec2 hi) { return p.x >= lo.x && p.y >= lo.y && p.x < hi.x && p.y < hi.y; }

bool updateCrumbs(Editor& editor, const CanvasView& view, vec2 pointer) {
  const std::vector<Crumb> all = crumbs(editor, view);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!inside(pointer, all[i].lo, all[i].hi)) continue;
    editor.canvas.overlays.crumb = static_cast<int>(i);
    if (ImGui::IsMouseClicked(0) && i + 1 < all.size()) {
      std::vector<std::string> scope = editor.document.scope();
      scope.resize(i);
      goToScope(editor, scope);
    }
    return true;
  }
  return false;
}

bool updateFollowers(Editor& editor, const CanvasView& view, const Layout& layout, vec2 pointer) {
  if (!view.level.text) return false;
  for (auto place = layout.nodes.rbegin(); place != layout.nodes.rend(); ++place) {
    if (inside(pointer, view.screen(place->min), view.screen(place->max))) return false;
    if (statusOf(editor, place->name).state != nodes::NodeState::Skipped ||
        !footerRect(view, *place, FooterKind::Follower).contains(pointer))
      continue;
    editor.canvas.overlays.follower = place->name;
    if (!ImGui::IsMouseClicked(0)) return true;
    const std::string source = sourceOfError(editor, layout, place->name);
    if (source.empty()) return true;
    editor.canvas.selectedLink.reset();
    editor.document.select({source});
    editor.canvas.frameSelection = true;
    return true;
  }
  return false;
}

}  // namespace

bool updateOverlays(Editor& editor, const CanvasView& view, const Layout& layout, bool hovered) {
  CanvasOverlays& overlays = editor.canvas.overlays;
  overlays = {};
  const vec2 pointer = vec(ImGui::GetIO().MousePos);
  overlays.covered = updateMinimap(editor, view, layout, hovered);
  if (!overlays.covered && hovered && !editor.canvas.interaction.busy())
    overlays.covered = updateCrumbs(editor, view, pointer) || updateFollowers(editor, view, layout, pointer);
  if (!overlays.follower.empty() || (overlays.crumb >= 0)) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  return overlays.covered;
}

void drawOverlays(Editor& editor, const CanvasView& view, const Layout& layout) {
  const Theme& theme = editor.theme;
  const std::vector<Crumb> all = crumbs(editor, view);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Crumb& c = all[i];
    const bool last = i + 1 == all.size(), over = editor.canvas.overlays.crumb == static_cast<int>(i);
    view.draw->AddRectFilled(
        im(c.lo), im(c.hi), over && !last ? palette::kButtonHover : faded(palette::kBar, 0.92f), theme.px(5));
    drawText(view.draw, theme.body, c.lo + vec2(theme.px(8), theme.px(4)),
             last ? palette::kTextStrong : palette::kTextDim, c.text, 1e4f);
    if (!last)
      drawText(view.draw, theme.small, {c.hi.x + theme.px(2), c.lo.y + theme.px(5)}, palette::kTextFaint,
               icon::kChevronRight, 1e3f);
    if (editor.trace.on()) {
      editor.trace.rect("crumb/" + std::to_string(i), im(c.lo), im(c.hi));
      editor.trace.note("crumb/" + std::to_string(i), c.text);
    }
  }
  drawMinimap(editor, view, layout);
}

}  // namespace pileus::editor
