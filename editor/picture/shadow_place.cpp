#include "editor/picture/shadow_place.h"

#include "editor/app/editor.h"
#include "editor/time/playback.h"
#include "renderer/view/visible_point.h"

namespace pileus::editor {
namespace {

constexpr const char* kMergeKey = "place by shadow";

std::optional<dvec3> seenAt(const Editor& editor, const Projection& view, vec2 at) {
  const auto& picture = editor.preview.picture();
  if (!picture || !picture->scene || !view.contains(at)) return std::nullopt;
  return view::visiblePoint(*picture->scene, dvec2((at - view.min()) / (view.max() - view.min())));
}

}  // namespace

std::string lightToUse(const Editor& editor) {
  const nodes::Graph& graph = editor.document.graph();
  for (const std::string& name : editor.document.selection())
    if (const nodes::Node* node = nodes::findNode(graph, name); node && node->type.starts_with("light."))
      return name;
  const auto& lights = editor.viewport.tools.scene.lights;
  return lights.size() == 1 ? lights.front().node : "";
}

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

void placeByShadow(Editor& editor) {
  const std::string light = lightToUse(editor);
  if (light.empty()) return editor.messages.hint("Select a light first: its shadow is what you then place.");
  if (!gizmoTarget(editor.document.graph(), light, {}, editor.frame))
    return editor.messages.hint(light + " is bypassed and cannot be placed.");
  cancelShadowPlace(editor);
  holdFrame(editor, *nodes::findNode(editor.document.graph(), light));
  editor.document.select({light});
  editor.document.endMerge();
  editor.viewport.tools.place = {ShadowPlace::Stage::Caster, light, {}, editor.document.graph()};
}

bool clickShadowPlace(Editor& editor, const Projection& view, vec2 at) {
  ShadowPlace& place = editor.viewport.tools.place;
  if (place.stage == ShadowPlace::Stage::Off) return false;
  if (place.stage == ShadowPlace::Stage::Caster) {
    const auto point = seenAt(editor, view, at);
    if (point)
      place.caster = *point, place.stage = ShadowPlace::Stage::Shadow;
    else
      editor.messages.hint("Nothing is there: click a volume or a solid that casts the shadow.");
    return true;
  }
  editor.document.endMerge();
  place = {};
  return true;
}

void followShadowPlace(Editor& editor, const Projection& view, vec2 at) {
  const ShadowPlace& place = editor.viewport.tools.place;
  if (place.stage != ShadowPlace::Stage::Shadow) return;
  const auto start = gizmoTarget(place.before, place.light, {}, editor.frame);
  const auto receiver = seenAt(editor, view, at);
  if (!start || !receiver) return;
  tryEdit(editor,
          withTarget(place.before, *start, castingOnto(*start, place.caster, *receiver),
                     glm::length(place.caster - *receiver), editor.frame),
          "Place " + place.light + " by its shadow", kMergeKey);
  editor.preview.touch();
}

void cancelShadowPlace(Editor& editor) {
  ShadowPlace& place = editor.viewport.tools.place;
  if (place.stage == ShadowPlace::Stage::Shadow) editor.document.edit(place.before, "", kMergeKey);
  if (place.stage != ShadowPlace::Stage::Off) editor.document.endMerge();
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

void lookThroughLight(Editor& editor) {
  LightView& look = editor.viewport.tools.look;
  if (!look.light.empty()) return leaveLightView(editor);
  const std::string light = lightToUse(editor);
  const auto target = gizmoTarget(editor.document.graph(), light, {}, editor.frame);
  if (!target) return editor.messages.hint("Select a light first to look through it.");
  const Box3& bounds = editor.viewport.tools.scene.bounds;
  const dvec3 center = bounds.empty() ? dvec3(0) : bounds.center();
  look = {light, center, 1, target->sun ? 8.0 : 60.0};
  if (target->sun) {
    const ivec2 size = editor.document.root().settings.size;
    scene::Camera camera;
    camera.target = center, camera.eye = center + scene::sunDirection(target->azimuth, target->elevation),
    camera.fov = look.fov;
    camera = scene::frameBounds(bounds, double(size.x) / std::max(size.y, 1), camera);
    look.distance = glm::length(camera.eye - camera.target);
  } else if (target->aims) {
    look.target = target->aim;
  }
  editor.preview.touch();
}

void leaveLightView(Editor& editor) {
  editor.viewport.tools.look = {};
  editor.document.endMerge();
}

std::optional<scene::Camera> lightViewCamera(const Editor& editor) {
  const LightView& look = editor.viewport.tools.look;
  if (look.light.empty()) return std::nullopt;
  const auto target = gizmoTarget(editor.document.graph(), look.light, {}, editor.frame);
  if (!target) return std::nullopt;
  scene::Camera camera;
  camera.fov = target->hasCone ? std::clamp(target->cone, 1.0, 120.0) : look.fov;
  camera.target = target->aims ? target->aim : look.target;
  camera.eye = target->sun
                   ? look.target + look.distance * scene::sunDirection(target->azimuth, target->elevation)
                   : target->position;
  if (!(glm::length(camera.eye - camera.target) > 1e-9)) camera.eye += dvec3(0, 1e-3, 0);
  return camera;
}

void moveLightView(Editor& editor, const scene::Camera& camera, const std::string& mergeKey) {
  LightView& look = editor.viewport.tools.look;
  const auto start = gizmoTarget(editor.document.graph(), look.light, {}, editor.frame);
  if (!start) return;
  holdFrame(editor, *nodes::findNode(editor.document.graph(), look.light));
  const dvec3 towards = camera.eye - camera.target;
  GizmoTarget to = *start;
  look.target = camera.target;
  look.distance = glm::length(towards);
  if (start->sun) {
    // A pan or dolly only looks elsewhere.
    const dvec3 before = scene::sunDirection(start->azimuth, start->elevation);
    if (glm::length(glm::normalize(towards) - before) < 1e-7) return;
    const dvec2 angles = azimuthElevation(towards, start->azimuth);
    to.azimuth = angles.x, to.elevation = angles.y;
  } else {
    to.position = camera.eye;
    if (to.aims) to.aim = camera.target;
  }
  tryEdit(editor, withTarget(editor.document.graph(), *start, to, look.distance, editor.frame),
          "Move " + look.light, mergeKey);
}

void applyLightView(const Editor& editor, PreviewRequest& request) {
  const auto camera = lightViewCamera(editor);
  if (!camera) return;
  request.freeCamera = camera;
  std::erase_if(request.graph.links, [&](const nodes::Link& link) {
    const nodes::Node* node = nodes::findNode(request.graph, link.fromNode);
    return node && node->type.starts_with("camera.");
  });
  request.revision ^= std::uint64_t(1) << 63;  // another graph than the document's
}

}  // namespace pileus::editor
