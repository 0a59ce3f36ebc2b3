#include "editor/viewport/ray_mark.h"

#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {

void drawPickedRay(Ui& ui, const Shown& shown, const Settings& settings) {
  const RayPick& ray = shown.ray;
  const auto& picture = shown.preview.picture();
  if (!settings.showScope || !ray.point || !picture || !picture->scene) return;
  const auto uv = view::pictureUv(picture->scene->options, *ray.point);
  if (!uv || glm::any(glm::lessThan(*uv, dvec2(0))) || glm::any(glm::greaterThan(*uv, dvec2(1)))) return;
  const Theme& theme = ui.theme;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (const ScreenRect& r : shown.places) {
    const vec2 at = glm::mix(r.min, r.max, vec2(*uv));
    const float radius = theme.px(6), arm = theme.px(5);
    for (const auto& [color, width] :
         {std::pair(palette::kHandleEdge, 3.5f), std::pair(palette::kSelect, 1.5f)}) {
      draw->AddCircle(im(at), radius, color, 0, width * theme.scale);
      for (const vec2 d : {vec2(1, 0), vec2(-1, 0), vec2(0, 1), vec2(0, -1)})
        draw->AddLine(im(at + radius * d), im(at + (radius + arm) * d), color, width * theme.scale);
    }
    ui.trace.rect("scope/mark", im(at - radius), im(at + radius));
  }
}

}  // namespace pileus::editor
