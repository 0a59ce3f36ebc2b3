#include "editor/lab/ray_scope.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/lab/scope_charts.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/segments.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
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
                     : kind == scene::LightKind::Spot  ? "Spot"
                                                       : "Environment",
                     number + 1);
}

/// Looks again where the picture, the point or the light is another one.
void follow(const Shown& shown, RayScope& scope) {
  const auto& picture = shown.preview.picture();
  if (!shown.ray.point || !picture || !picture->scene) {
    if (!picture) scope.probe.reset();
    return;
  }
  // A draft has maps of its own: what is shown stays until the final ones are there.
  if (shown.preview.draft() && scope.probe) return;
  const std::vector<std::size_t> lights = shadowedLights(*picture->scene);
  scope.light = lights.empty() ? 0 : std::min(scope.light, lights.size() - 1);
  if (scope.scene == picture->scene && scope.probedPoint == shown.ray.point &&
      scope.probedLight == scope.light)
    return;
  const bool known = scope.probe && scope.scene == picture->scene && scope.probedLight == scope.light;
  scope.scene = picture->scene, scope.probedPoint = shown.ray.point, scope.probedLight = scope.light;
  scope.error.clear();
  if (lights.empty()) {
    scope.probe.reset();
    scope.error = "No light of this picture has a shadow.";
    return;
  }
  Result<truth::RayProbe> probe =
      truth::probeRay(shown.renderer.gpu(), picture->scene->lights[lights[scope.light]], *shown.ray.point,
                      256, known ? scope.probe->map : nullptr);
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

void drawHead(Ui& ui, Shown& shown, Settings& settings, RayScope& scope, vec2 lo, vec2 hi) {
  const Theme& theme = ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(im(lo), im(hi), palette::kPanel);
  const std::string title = std::string(icon::kCrosshairs) + "  Ray scope";
  const float side = hi.y - lo.y;
  drawText(draw, theme.strong, {lo.x + theme.space(3), lo.y + 0.5f * (side - theme.strong->FontSize)},
           palette::kText, title, hi.x - lo.x);
  float x = lo.x + theme.space(3) + textWidth(theme.strong, title) + theme.space(4);
  ImGui::SetCursorScreenPos({x, lo.y + theme.px(5)});
  if (segment(ui, "scope/pick", "Pick ray", "A click in the picture picks (S)", shown.ray.picking, true,
              true))
    togglePicking(ui.messages, shown, settings);
  const auto& picture = shown.preview.picture();
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
    ui.trace.item("scope/light");
  }
  ImGui::SetCursorScreenPos({hi.x - side, lo.y});
  if (ImGui::InvisibleButton("scope close", {side, side})) toggleScope(shown, settings);
  ui.trace.item("scope/close");
  const bool hovered = ImGui::IsItemHovered();
  drawText(draw, theme.small,
           {hi.x - 0.5f * (side + textWidth(theme.small, icon::kTimes)),
            lo.y + 0.5f * (side - theme.small->FontSize)},
           hovered ? palette::kText : palette::kTextDim, icon::kTimes, side);
}

void drawHint(Ui& ui, vec2 lo, vec2 hi, const std::string& text) {
  const Theme& theme = ui.theme;
  const float width = std::min(hi.x - lo.x - theme.space(8), theme.px(280));
  const ImVec2 size = theme.body->CalcTextSizeA(theme.body->FontSize, FLT_MAX, width, text.c_str());
  ImGui::GetWindowDrawList()->AddText(
      theme.body, theme.body->FontSize,
      {std::round(0.5f * (lo.x + hi.x - size.x)), std::round(lo.y + 0.35f * (hi.y - lo.y) - 0.5f * size.y)},
      palette::kTextDim, text.c_str(), nullptr, width);
  ui.trace.note("scope hint", text);
}

/// The representation, and the figures of the point and of the ray.
void drawSummary(Ui& ui, const RayScope& scope, ChartSpace& space) {
  const Theme& theme = ui.theme;
  const truth::RayProbe& p = *scope.probe;
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
  ui.trace.note("scope what", what);
  ui.trace.note("scope point", point);
  ui.trace.note("scope ray", ray);
  space.y += theme.space(2);
}

float flagsHeight(const Theme& theme, const RayScope& scope, float width) {
  float height = 0;
  for (const truth::RayFlag& f : scope.flags)
    height +=
        theme.small->CalcTextSizeA(theme.small->FontSize, FLT_MAX, width - theme.px(20), f.text.c_str()).y +
        theme.px(4);
  return height;
}

void drawFlags(Ui& ui, const RayScope& scope, const ChartSpace& space) {
  const Theme& theme = ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  float y = space.y;
  std::string all;
  for (const truth::RayFlag& f : scope.flags) {
    const bool warning = f.weight == truth::RayFlag::Weight::Warning;
    drawText(draw, theme.small, {space.left, y}, warning ? palette::kWarning : palette::kTextFaint,
             warning ? icon::kWarning : icon::kInfo, theme.px(18));
    const float width = space.right - space.left - theme.px(20);
    draw->AddText(theme.small, theme.small->FontSize, {space.left + theme.px(20), y},
                  warning ? palette::kText : palette::kTextDim, f.text.c_str(), nullptr, width);
    y += theme.small->CalcTextSizeA(theme.small->FontSize, FLT_MAX, width, f.text.c_str()).y + theme.px(4);
    all += (all.empty() ? "" : " ") + f.text;
  }
  ui.trace.note("scope flags", all);
}

}  // namespace

void drawRayScope(Ui& ui, Shown& shown, Settings& settings, RayScope& scope, ImVec2 min, ImVec2 max) {
  const Theme& theme = ui.theme;
  ImGui::GetWindowDrawList()->AddRectFilled(min, max, palette::kPanel);
  const float head = theme.px(36);
  follow(shown, scope);
  drawHead(ui, shown, settings, scope, vec(min), {max.x, min.y + head});
  const vec2 lo(min.x, min.y + head), hi = vec(max);
  ui.trace.rect("scope", min, max);
  if (!scope.error.empty()) return drawHint(ui, lo, hi, scope.error);
  if (!scope.probe)
    return drawHint(ui, lo, hi,
                    shown.ray.point ? "Waiting for the picture."
                                    : "Choose Pick ray (S) and click into the picture: the light ray through "
                                      "what is seen there is drawn here.");
  if (scope.overU.u.empty()) followMuted(scope, true);
  const std::vector<char> before = scope.muted;

  ChartSpace space{lo.x + theme.space(3), hi.x - theme.space(3), lo.y + theme.space(1), 1};
  drawSummary(ui, scope, space);
  const float flags = flagsHeight(ui.theme, scope, space.right - space.left);
  const bool metric = scope.probe->map->metric && scope.probe->map->metric->block,
             series = !scope.probe->taps.taps.empty();
  const float shares = 2 + 1.4f + (metric ? 0.8f : 0) + (series ? 1.1f : 0);
  space.unit = std::clamp((hi.y - theme.space(3) - flags - space.y - chartOverhead(ui.theme, scope)) / shares,
                          theme.px(28), theme.px(150));
  drawTransmittance(ui, scope, space);
  drawExtinction(ui, scope, space);
  drawCoefficients(ui, scope, space);
  drawFlags(ui, scope, space);
  if (scope.muted != before) followMuted(scope, true);
}

void toggleScope(Shown& shown, Settings& settings) {
  settings.showScope = !settings.showScope;
  if (!settings.showScope) shown.ray.picking = false;
}

}  // namespace pileus::editor
