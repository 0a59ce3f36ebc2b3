#include "editor/picture/node_placement.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

/// The parameters of a type that a gizmo drags; null: none.
struct Handles {
  const char* type;
  const char *position = nullptr, *rotate = nullptr, *scale = nullptr, *radius = nullptr, *aim = nullptr,
             *cone = nullptr;
};

constexpr Handles kTypes[] = {
    {.type = "volume.transform", .position = "translate", .rotate = "rotate", .scale = "scale"},
    {.type = "volume.box", .position = "center", .scale = "size"},
    {.type = "volume.cloud", .position = "center", .scale = "size"},
    {.type = "volume.sphere", .position = "center", .radius = "radius"},
    {.type = "solid.box", .position = "center", .rotate = "rotate", .scale = "size"},
    {.type = "solid.plane", .position = "center", .rotate = "rotate", .scale = "size"},
    {.type = "light.point", .position = "position"},
    {.type = "light.spot", .position = "position", .aim = "target", .cone = "cone"},
    {.type = "camera.perspective", .position = "eye", .aim = "target"},
    {.type = "light.sun"},
    {.type = "light.sky"},
};

const Handles* handlesOf(const std::string& type) {
  const auto it =
      std::find_if(std::begin(kTypes), std::end(kTypes), [&](const Handles& h) { return type == h.type; });
  return it == std::end(kTypes) ? nullptr : it;
}

template <class T>
bool readParam(const nodes::Node& node, const nodes::NodeType& type, const char* id, double frame, T& out) {
  const nodes::ParamSpec* spec = id ? type.param(id) : nullptr;
  if (!spec) return false;
  const nodes::ParamValue value = nodes::paramValue(node, *spec, frame);
  const T* v = std::get_if<T>(&value);
  if (v) out = *v;
  return v != nullptr;
}

/// A size may not vanish or be mirrored by dragging.
dvec3 awayFromZero(const dvec3& v) {
  dvec3 out = v;
  for (int a = 0; a < 3; ++a)
    if (std::abs(out[a]) < 1e-6) out[a] = out[a] < 0 ? -1e-6 : 1e-6;
  return out;
}

}  // namespace

dmat4 GizmoTarget::placement() const {
  const dmat4 linear = composeTransform(dvec3(0), rotate, scale);
  return glm::translate(dmat4(1.0), position - dvec3(linear * dvec4(pivot, 1))) * linear;
}

std::optional<GizmoTarget> gizmoTarget(const nodes::Graph& graph, const std::string& name, const dvec3& pivot,
                                       double frame) {
  const nodes::Node* node = nodes::findNodeAt(graph, name);
  const Handles* handles = node ? handlesOf(node->type) : nullptr;
  const nodes::NodeType* type = handles ? nodes::findNodeType(node->type) : nullptr;
  if (!type || node->bypass) return std::nullopt;
  const auto read = [&](const char* id, auto& out) { return readParam(*node, *type, id, frame, out); };
  GizmoTarget t;
  t.node = name;
  t.moves = read(handles->position, t.position);
  t.turns = read(handles->rotate, t.rotate);
  t.scales = read(handles->scale, t.scale);
  if (double radius = 0; read(handles->radius, radius)) {
    t.scales = t.uniform = true;
    t.scale = dvec3(radius);
  }
  t.aims = read(handles->aim, t.aim);
  t.hasCone = read(handles->cone, t.cone);
  const bool hasSun = node->type == "light.sun" || node->type == "light.sky";
  t.sun = hasSun && read("azimuth", t.azimuth) && read("elevation", t.elevation);
  t.flat = node->type == "solid.plane";
  if (node->type == "volume.transform" && t.moves) {
    t.pivot = pivot;
    t.position += dvec3(composeTransform(dvec3(0), t.rotate, t.scale) * dvec4(pivot, 1));
  }
  if (!t.any()) return std::nullopt;
  return t;
}

Result<nodes::Graph> withTarget(const nodes::Graph& graph, const GizmoTarget& before,
                                const GizmoTarget& after, double scale, double frame) {
  const nodes::Node* node = nodes::findNodeAt(graph, after.node);
  const Handles* handles = node ? handlesOf(node->type) : nullptr;
  if (!handles) return fail(Code::Arguments, "{} is gone", after.node);
  Result<nodes::Graph> out = graph;
  const auto set = [&](const char* id, const nodes::ParamValue& value) {
    if (out && id) out = nodes::setParamAt(*out, after.node, id, value, frame);
  };
  GizmoTarget to = after;
  for (int a = 0; a < 3; ++a)
    if (to.scale[a] != before.scale[a]) to.scale[a] = tidy(awayFromZero(to.scale)[a], to.scale[a]);
  if (to.rotate != before.rotate) to.rotate = tidy(to.rotate, 100);
  if (to.rotate != before.rotate) set(handles->rotate, to.rotate);
  if (to.scale != before.scale)
    to.uniform ? set(handles->radius, std::abs(to.scale.x)) : set(handles->scale, to.scale);
  const dvec3 offset(composeTransform(dvec3(0), to.rotate, to.scale) * dvec4(to.pivot, 1));
  const bool pivoted = to.pivot != dvec3(0) && (to.rotate != before.rotate || to.scale != before.scale);
  if (to.position != before.position || pivoted) {
    // Where the pivot is stays; the parameter is where the origin goes.
    dvec3 value = tidy(to.position - offset, scale);
    if (to.pivot == dvec3(0))
      for (int a = 0; a < 3; ++a)
        if (to.position[a] == before.position[a]) value[a] = before.position[a];
    set(handles->position, value);
  }
  if (to.aim != before.aim) set(handles->aim, tidy(to.aim, scale));
  if (to.cone != before.cone) set(handles->cone, std::clamp(tidy(to.cone, 100), 0.1, 170.0));
  if (to.azimuth != before.azimuth) set("azimuth", tidy(to.azimuth, 100));
  if (to.elevation != before.elevation) set("elevation", std::clamp(tidy(to.elevation, 100), -90.0, 90.0));
  return out;
}

FittedNode fittedToScene(const nodes::Graph& graph, const std::string& name, const Box3& bounds) {
  const nodes::Node* node = nodes::findNode(graph, name);
  const std::optional<GizmoTarget> target = gizmoTarget(graph, name, dvec3(0), 0);
  if (!node || !target || bounds.empty()) return {graph, {}};
  const dvec3 size = bounds.size();
  const double edge = std::max({size.x, size.y, size.z});
  // The defaults stand well in a scene of some metres.
  if (!std::isfinite(edge) || edge <= 0 || (edge > 0.5 && edge < 8)) return {graph, {}};
  const auto rounded = [](double v) {  // to 1, 2 or 5 times a power of ten
    const double decade = std::pow(10, std::floor(std::log10(v)));
    return decade * (v / decade < 1.5 ? 1 : v / decade < 3.5 ? 2 : v / decade < 7.5 ? 5 : 10);
  };
  GizmoTarget to = *target;
  const dvec3 middle = bounds.center();
  std::string note;
  if (node->type == "solid.plane") {
    to.scale = dvec3(rounded(4 * edge), to.scale.y, rounded(4 * edge));
    to.position = {middle.x, bounds.min.y, middle.z};
    note = fmt::format("{}: {:g} m wide, under the volumes", name, to.scale.x);
  } else if (node->type == "volume.box" || node->type == "solid.box") {
    to.scale *= rounded(0.3 * edge) / std::max({to.scale.x, to.scale.y, to.scale.z});
    to.position = middle;
    note = fmt::format("{}: {:g} m wide, for a scene of {:.3g} m", name, to.scale.x, edge);
  } else if (node->type == "volume.sphere") {
    to.scale = dvec3(rounded(0.15 * edge));
    to.position = middle;
    note = fmt::format("{}: radius {:g} m, for a scene of {:.3g} m", name, to.scale.x, edge);
  } else if (node->type == "light.point" || node->type == "light.spot") {
    to.position = {middle.x + 0.4 * edge, bounds.max.y + 0.4 * edge, middle.z + 0.4 * edge};
    if (to.aims) to.aim = middle;
    note = fmt::format("{}: above the volumes, in a scene of {:.3g} m", name, edge);
  } else {
    return {graph, {}};
  }
  Result<nodes::Graph> fitted = withTarget(graph, *target, to, 0.1 * edge, 0);
  if (!fitted) return {graph, {}};
  return {std::move(*fitted), std::move(note)};
}

}  // namespace pileus::editor
