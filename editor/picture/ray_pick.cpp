#include "editor/picture/ray_pick.h"

#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {

void pickRay(Messages& messages, Shown& shown, Settings& settings, dvec2 uv) {
  const auto& picture = shown.preview.picture();
  if (!picture || !picture->scene) return messages.hint("There is no picture to pick from.");
  const auto point = view::visiblePoint(*picture->scene, uv);
  if (!point) return messages.hint("Nothing is seen there: pick a volume or a solid.");
  shown.ray.point = *point;
  settings.showScope = true;
}

void togglePicking(Messages& messages, Shown& shown, Settings& settings) {
  shown.ray.picking = !shown.ray.picking;
  if (shown.ray.picking) {
    settings.showScope = true;
    messages.note("Click into the picture to look at a light ray");
  }
}

}  // namespace pileus::editor
