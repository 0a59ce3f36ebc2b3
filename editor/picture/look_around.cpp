#include "editor/picture/look_around.h"

#include <algorithm>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/time/clock.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {

bool cameraLocked(const Session& session, const Clock& clock, const Shown& shown) {
  const nodes::Node* node =
      nodes::findNodeAt(session.document.root(), linkedCamera(session, shownView(session, shown)));
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const nodes::ParamSpec* spec = type ? type->param("lock") : nullptr;
  if (!spec) return false;
  const nodes::ParamValue value = nodes::paramValue(*node, *spec, clock.frame);
  return std::get_if<bool>(&value) && std::get<bool>(value);
}

void toggleCameraLock(Messages& messages, Session& session, const Clock& clock, Shown& shown) {
  const std::string name = linkedCamera(session, shownView(session, shown));
  const bool locked = cameraLocked(session, clock, shown);
  if (tryEditRoot(session, messages,
                  nodes::setParamAt(session.document.root(), name, "lock", !locked, clock.frame),
                  (locked ? "Unlock " : "Lock ") + name) &&
      locked)
    backToCamera(shown);
}

std::optional<scene::Camera> aroundCamera(const Session& session, const Shown& shown) {
  const LookAround& around = shown.around;
  if (around.camera.empty() || around.camera != linkedCamera(session, shownView(session, shown)))
    return std::nullopt;
  return around.view;
}

void backToCamera(Shown& shown) {
  shown.around = {};
  shown.preview.touch();
}

void cameraToView(Messages& messages, Session& session, Clock& clock, Shown& shown) {
  const auto view = aroundCamera(session, shown);
  if (!view) return;
  const std::string name = std::exchange(shown.around, {}).camera;
  moveCamera(messages, session, clock, shown, name, *view, "Move " + name + " here", {});
}

void applyLookAround(const Session& session, const Shown& shown, PreviewRequest& request) {
  const auto view = aroundCamera(session, shown);
  if (!view) return;
  request.freeCamera = view;
  const std::string user = cameraUser(session, request.view);
  if (auto graph = nodes::unlinked(request.graph, user, cameraInput(session, user)))
    request.graph = std::move(*graph);
  request.revision ^= std::uint64_t(1) << 62;  // another graph than the document's
}

}  // namespace pileus::editor
