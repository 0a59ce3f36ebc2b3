#include "editor/viewport/handles/shadow_place.h"

#include "editor/document/session.h"
#include "editor/picture/light_view.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/toolkit/ui.h"
#include "editor/viewport/viewport.h"
#include "editor/viewport/viewport_room.h"
#include "nodes/graph/graph_groups.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {
namespace {

constexpr const char* kMergeKey = "place by shadow";

std::optional<dvec3> seenAt(const Shown& shown, const Projection& view, vec2 at) {
  const auto& picture = shown.preview.picture();
  if (!picture || !picture->scene || !view.contains(at)) return std::nullopt;
  return view::visiblePoint(*picture->scene, dvec2((at - view.min()) / (view.max() - view.min())));
}

}  // namespace

GizmoTarget castingOnto(const GizmoTarget& light, const dvec3& caster, const dvec3& receiver) {
  GizmoTarget out = light;
  const dvec3 towards = caster - receiver;
  if (!(glm::length(towards) > 0)) return out;
  if (light.sun) {
    const dvec2 angles = azimuthElevation(towards, light.azimuth);
    out.azimuth = angles.x, out.elevation = angles.y;
    return out;
  }
  // On the line through both, as far from the caster as it was.
  out.position = caster + glm::normalize(towards) * std::max(glm::length(light.position - caster), 1e-3);
  if (out.aims) out.aim = caster;
  return out;
}

void placeByShadow(const ViewportRoom& room) {
  const std::string light = lightToUse(room.session, room.shown);
  if (light.empty()) return room.ui.messages.hint("Select a light first: its shadow is what you then place.");
  if (!gizmoTarget(room.session.document.root(), light, {}, room.clock.frame))
    return room.ui.messages.hint(light + " is bypassed and cannot be placed.");
  cancelShadowPlace(room.session, room.viewport);
  holdFrame(room.clock, *nodes::findNodeAt(room.session.document.root(), light));
  if (const std::string name = shownInScope(room.session, light); !name.empty())
    room.session.document.select({name});
  room.session.document.endMerge();
  room.viewport.tools.place = {ShadowPlace::Stage::Caster, light, {}, room.session.document.root()};
}

bool clickShadowPlace(Ui& ui, Session& session, const Shown& shown, Viewport& viewport,
                      const Projection& view, vec2 at) {
  ShadowPlace& place = viewport.tools.place;
  if (place.stage == ShadowPlace::Stage::Off) return false;
  if (place.stage == ShadowPlace::Stage::Caster) {
    const auto point = seenAt(shown, view, at);
    if (point)
      place.caster = *point, place.stage = ShadowPlace::Stage::Shadow;
    else
      ui.messages.hint("Nothing is there: click a volume or a solid that casts the shadow.");
    return true;
  }
  session.document.endMerge();
  place = {};
  return true;
}

void followShadowPlace(const ViewportRoom& room, const Projection& view, vec2 at) {
  const ShadowPlace& place = room.viewport.tools.place;
  if (place.stage != ShadowPlace::Stage::Shadow) return;
  const auto start = gizmoTarget(place.before, place.light, {}, room.clock.frame);
  const auto receiver = seenAt(room.shown, view, at);
  if (!start || !receiver) return;
  tryEditRoot(room.session, room.ui.messages,
              withTarget(place.before, *start, castingOnto(*start, place.caster, *receiver),
                         glm::length(place.caster - *receiver), room.clock.frame),
              "Place " + place.light + " by its shadow", kMergeKey);
  room.shown.preview.touch();
}

void cancelShadowPlace(Session& session, Viewport& viewport) {
  ShadowPlace& place = viewport.tools.place;
  if (place.stage == ShadowPlace::Stage::Shadow) session.document.editRoot(place.before, "", kMergeKey);
  if (place.stage != ShadowPlace::Stage::Off) session.document.endMerge();
  place = {};
}

std::string shadowPlaceHint(const ViewportTools& tools) {
  switch (tools.place.stage) {
    case ShadowPlace::Stage::Caster:
      return "Click what casts the shadow of " + tools.place.light + ".  Esc leaves";
    case ShadowPlace::Stage::Shadow:
      return "Point at where the shadow of " + tools.place.light +
             " should fall, click to keep it.  Esc takes it back";
    case ShadowPlace::Stage::Off:
      break;
  }
  return {};
}

}  // namespace pileus::editor
