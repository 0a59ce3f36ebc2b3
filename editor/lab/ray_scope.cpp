#include "editor/lab/ray_scope.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/lab/scope_charts.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/segments.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {
namespace {

std::vector<std::size_t> shadowedLights(const view::RenderScene& scene) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (scene.lights[i].shadow) out.push_back(i);
  return out;
}

std::string lightName(const view::RenderScene& scene, std::size_t light, std::size_t number) {
  const scene::LightKind kind = scene.lights[light].light.kind;
  return fmt::format("{} {}",
                     kind == scene::LightKind::Sun     ? "Sun"
                     : kind == scene::LightKind::Point ? "Point"
                                                       : "Spot",
                     number + 1);
}

/// Looks again where the picture, the point or the light is another one.
void follow(Editor& editor) {
  RayScope& scope = editor.scope;
  const auto& picture = editor.preview.picture();
  if (!scope.point || !picture || !picture->scene) {
    if (!picture) scope.probe.reset();
    return;
  }
  // A draft has maps of its own: what is shown stays until the final ones are there.
  if (editor.preview.draft() && scope.probe) return;
  const std::vector<std::size_t> lights = shadowedLights(*picture->scene);
  scope.light = lights.empty() ? 0 : std::min(scope.light, lights.size() - 1);
  if (scope.scene == picture->scene && scope.probedPoint == scope.point && scope.probedLight == scope.light)
    return;
  scope.scene = picture->scene, scope.probedPoint = scope.point, scope.probedLight = scope.light;
  scope.error.clear();
  if (lights.empty()) {
    scope.probe.reset();
    scope.error = "No light of this picture has a shadow.";
    return;
  }
  Result<truth::RayProbe> probe =
      truth::probeRay(editor.renderer->gpu(), picture->scene->lights[lights[scope.light]], *scope.point);
  scope.probe.reset();
  if (!probe) {
    scope.error = probe.error().message;
    return;
  }
  const std::size_t count = probe->taps.taps.empty() ? 0 : probe->taps.taps.front().coefficients.size();
  if (scope.muted.size() != count) scope.muted.assign(count, 0);
  scope.flags = truth::rayFlags(*probe);
  scope.probe = std::move(*probe);
  scope.overU = {};
}

/// Curves without the muted coefficients.
void followMuted(RayScope& scope, bool changed) {
  const bool any = std::any_of(scope.muted.begin(), scope.muted.end(), [](char m) { return m != 0; });
  if (!changed && !scope.overU.u.empty() && any != scope.mutedT.empty()) return;
  scope.mutedT = any ? truth::mutedTransmittance(*scope.probe, scope.muted) : std::vector<double>{};
  scope.overU = truth::extinctionOverU(*scope.probe, scope.muted);
}

void drawHead(Editor& editor, vec2 lo, vec2 hi) {
  const Theme& theme = editor.theme;
  RayScope& scope = editor.scope;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(lo), im(hi), palette::kPanel);
  const std::string title = std::string(icon::kCrosshairs) + "  Ray scope";
  const float side = hi.y - lo.y;
  drawText(draw, theme.strong, {lo.x + theme.space(3), lo.y + 0.5f * (side - theme.strong->FontSize)},
           palette::kText, title, hi.x - lo.x);
  float x = lo.x + theme.space(3) + textWidth(theme.strong, title) + theme.space(4);
  ImGui::SetCursorScreenPos({x, lo.y + theme.px(5)});
  if (segment(editor, "scope/pick", "Pick ray", "A click in the picture picks (S)", scope.picking, true,
              true))
    togglePicking(editor);
  const auto& picture = editor.preview.picture();
  const std::vector<std::size_t> lights =
      picture && picture->scene ? shadowedLights(*picture->scene) : std::vector<std::size_t>{};
  if (lights.size() > 1) {
    ImGui::SameLine(0, theme.space(2));
    const std::size_t chosen = std::min(scope.light, lights.size() - 1);
    if (beginCombo(theme, "##scope light", lightName(*picture->scene, lights[chosen], chosen),
                   theme.px(110))) {
      for (std::size_t i = 0; i < lights.size(); ++i)
        if (ImGui::Selectable(lightName(*picture->scene, lights[i], i).c_str(), i == chosen)) scope.light = i;
      ImGui::EndCombo();
    }
    editor.trace.item("scope/light");
  }
  ImGui::SetCursorScreenPos({hi.x - side, lo.y});
  if (ImGui::InvisibleButton("scope close", {side, side})) toggleScope(editor);
  editor.trace.item("scope/close");
  const bool hovered = ImGui::IsItemHovered();
  drawText(draw, theme.small,
           {hi.x - 0.5f * (side + textWidth(theme.small, icon::kTimes)),
            lo.y + 0.5f * (side - theme.small->FontSize)},
           hovered ? palette::kText : palette::kTextDim, icon::kTimes, side);
}

void drawHint(Editor& editor, vec2 lo, vec2 hi, const std::string& text) {
  const Theme& theme = editor.theme;
  const float width = std::min(hi.x - lo.x - theme.space(8), theme.px(280));
  const ImVec2 size = theme.body->CalcTextSizeA(theme.body->FontSize, FLT_MAX, width, text.c_str());
  ImGui::GetWindowDrawList()->AddText(
      theme.body, theme.body->FontSize,
      {std::round(0.5f * (lo.x + hi.x - size.x)), std::round(lo.y + 0.35f * (hi.y - lo.y) - 0.5f * size.y)},
      palette::kTextDim, text.c_str(), nullptr, width);
  editor.trace.note("scope hint", text);
}

/// The representation, and the figures of the point and of the ray.
void drawSummary(Editor& editor, ChartSpace& space) {
  const Theme& theme = editor.theme;
  const truth::RayProbe& p = *editor.scope.probe;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const auto line = [&](ImFont* font, ImU32 ink, const std::string& text) {
    drawText(draw, font, {space.left, space.y}, ink, text, space.right - space.left);
    space.y += font->FontSize + theme.px(4);
  };
  const std::string what =
      p.map->kind == shadow::ShadowMap::Kind::RayMarch ? "Ray marched" : shadow::describe(p.map->spec);
  line(theme.strong, palette::kText, what);
  const double exact = interpolated(p.x, p.exact, p.pointX);
  std::string point = fmt::format("Picked at {:.4g} m: T {:.4f}", p.metres(p.pointX), exact),
              ray = "Exact along the whole ray.";
  if (!p.mapped.empty()) {
    const double mapped = interpolated(p.x, p.mapped, p.pointX);
    point += fmt::format(", the map {:.4f} ({:+.4f})", mapped, mapped - exact);
    ray = fmt::format("|\xce\x94T| of the ray: mean {:.4f}, max {:.4f} at {:.4g} m", p.meanError, p.maxError,
                      p.metres(p.maxErrorX));
  }
  line(theme.small, palette::kTextDim, point);
  line(theme.small, palette::kTextDim, ray);
  editor.trace.note("scope what", what);
  editor.trace.note("scope point", point);
  editor.trace.note("scope ray", ray);
  space.y += theme.space(2);
}

float flagsHeight(const Editor& editor, float width) {
  const Theme& theme = editor.theme;
  float height = 0;
  for (const truth::RayFlag& f : editor.scope.flags)
    height +=
        theme.small->CalcTextSizeA(theme.small->FontSize, FLT_MAX, width - theme.px(20), f.text.c_str()).y +
        theme.px(4);
  return height;
}

void drawFlags(Editor& editor, const ChartSpace& space) {
  const Theme& theme = editor.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  float y = space.y;
  std::string all;
  for (const truth::RayFlag& f : editor.scope.flags) {
    const bool warning = f.weight == truth::RayFlag::Weight::Warning;
    drawText(draw, theme.small, {space.left, y}, warning ? palette::kWarning : palette::kTextFaint,
             warning ? icon::kWarning : icon::kInfo, theme.px(18));
    const float width = space.right - space.left - theme.px(20);
    draw->AddText(theme.small, theme.small->FontSize, {space.left + theme.px(20), y},
                  warning ? palette::kText : palette::kTextDim, f.text.c_str(), nullptr, width);
    y += theme.small->CalcTextSizeA(theme.small->FontSize, FLT_MAX, width, f.text.c_str()).y + theme.px(4);
    all += (all.empty() ? "" : " ") + f.text;
  }
  editor.trace.note("scope flags", all);
}

}  // namespace

void pickRay(Editor& editor, dvec2 uv) {
  const auto& picture = editor.preview.picture();
  if (!picture || !picture->scene) return editor.messages.hint("There is no picture to pick from.");
  const auto point = view::visiblePoint(*picture->scene, uv);
  if (!point) return editor.messages.hint("Nothing is seen there: pick a volume or a solid.");
  editor.scope.point = *point;
  editor.settings.showScope = true;
}

void drawPickedRay(Editor& editor) {
  const RayScope& scope = editor.scope;
  const auto& picture = editor.preview.picture();
  if (!editor.settings.showScope || !scope.point || !picture || !picture->scene) return;
  const auto uv = view::pictureUv(picture->scene->options, *scope.point);
  if (!uv || glm::any(glm::lessThan(*uv, dvec2(0))) || glm::any(glm::greaterThan(*uv, dvec2(1)))) return;
  const Theme& theme = editor.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (const Viewport::Rect& r : editor.viewport.shown) {
    const vec2 at = glm::mix(r.min, r.max, vec2(*uv));
    const float radius = theme.px(6), arm = theme.px(5);
    for (const auto& [color, width] :
         {std::pair(palette::kHandleEdge, 3.5f), std::pair(palette::kSelect, 1.5f)}) {
      draw->AddCircle(im(at), radius, color, 0, width * theme.scale);
      for (const vec2 d : {vec2(1, 0), vec2(-1, 0), vec2(0, 1), vec2(0, -1)})
        draw->AddLine(im(at + radius * d), im(at + (radius + arm) * d), color, width * theme.scale);
    }
    editor.trace.rect("scope/mark", im(at - radius), im(at + radius));
  }
}

void drawRayScope(Editor& editor, ImVec2 min, ImVec2 max) {
  const Theme& theme = editor.theme;
  RayScope& scope = editor.scope;
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, palette::kPanel);
  const float head = theme.px(36);
  follow(editor);
  drawHead(editor, vec(min), {max.x, min.y + head});
  const vec2 lo(min.x, min.y + head), hi = vec(max);
  editor.trace.rect("scope", min, max);
  if (!scope.error.empty()) return drawHint(editor, lo, hi, scope.error);
  if (!scope.probe)
    return drawHint(editor, lo, hi,
                    scope.point ? "Waiting for the picture."
                                : "Choose Pick ray (S) and click into the picture: the light ray through "
                                  "what is seen there is drawn here.");
  if (scope.overU.u.empty()) followMuted(scope, true);
  const std::vector<char> before = scope.muted;

  ChartSpace space{lo.x + theme.space(3), hi.x - theme.space(3), lo.y + theme.space(1), 1};
  drawSummary(editor, space);
  const float flags = flagsHeight(editor, space.right - space.left);
  const bool metric = scope.probe->map->metric && scope.probe->map->metric->block,
             series = !scope.probe->taps.taps.empty();
  const float shares = 2 + 1.4f + (metric ? 0.8f : 0) + (series ? 1.1f : 0);
  space.unit = std::clamp((hi.y - theme.space(3) - flags - space.y - chartOverhead(editor)) / shares,
                          theme.px(28), theme.px(150));
  drawTransmittance(editor, space);
  drawExtinction(editor, space);
  drawCoefficients(editor, space);
  drawFlags(editor, space);
  if (scope.muted != before) followMuted(scope, true);
}

void togglePicking(Editor& editor) {
  editor.scope.picking = !editor.scope.picking;
  if (editor.scope.picking) {
    editor.settings.showScope = true;
    editor.messages.note("Click into the picture to look at a light ray");
  }
}

void toggleScope(Editor& editor) {
  editor.settings.showScope = !editor.settings.showScope;
  if (!editor.settings.showScope) editor.scope.picking = false;
}

}  // namespace pileus::editor
