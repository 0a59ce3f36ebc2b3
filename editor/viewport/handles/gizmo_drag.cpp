// What dragging a handle makes of its target.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/viewport/handles/gizmo.h"
#include "renderer/scene/light.h"

namespace pileus::editor {
namespace {

using Part = GizmoHandle::Part;
constexpr const char* kMinus = "\xe2\x88\x92";
constexpr const char* kDegree = "\xc2\xb0";
constexpr const char* kTimes = "\xc3\x97";

std::string figure(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", std::abs(value), digits);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? kMinus : "") + text;
}
std::string signedFigure(double value, int digits) { return (value >= 0 ? "+" : "") + figure(value, digits); }
/// Decimals that show steps of `step`.
int decimals(double step) {
  return static_cast<int>(std::clamp(-std::floor(std::log10(std::max(step, 1e-9))), 0.0, 6.0));
}

std::optional<GizmoDragged> moved(const GizmoDrag& drag, dvec3 by, bool snap, double grid,
                                  dvec3 GizmoTarget::*what) {
  GizmoDragged out{drag.start.target, {}};
  dvec3& value = out.target.*what;
  const dvec3 before = value;
  if (snap && drag.start.local) {
    // Along axes of its own the grid is that of the move.
    dvec3 along = glm::transpose(drag.start.axes) * by;
    by = drag.start.axes * snapped(along, grid);
  }
  value = before + by;
  if (snap && !drag.start.local)
    for (int a = 0; a < 3; ++a)
      if (std::abs(by[a]) > 1e-9 * grid) value[a] = snapped(value[a], grid);
  const int digits = decimals(grid * 0.1);
  if (drag.handle.part == Part::Axis) {
    out.readout =
        fmt::format("{} {} m", "XYZ"[drag.handle.axis],
                    signedFigure(glm::dot(value - before, drag.start.axes[drag.handle.axis]), digits));
  } else {
    out.readout = fmt::format("{}  {}  {} m", figure(value.x, digits), figure(value.y, digits),
                              figure(value.z, digits));
  }
  return out;
}

std::optional<dvec3> translation(const GizmoDrag& drag, const Ray& to) {
  const GizmoFrame& f = drag.start;
  const auto between = [](std::optional<dvec3> a, std::optional<dvec3> b) {
    return a && b ? std::optional(*b - *a) : std::nullopt;
  };
  if (drag.handle.part == Part::Axis) {
    const dvec3 axis = f.axes[drag.handle.axis];
    const auto a = alongLine(drag.from, f.center, axis), b = alongLine(to, f.center, axis);
    return a && b ? std::optional((*b - *a) * axis) : std::nullopt;
  }
  const dvec3 normal = drag.handle.part == Part::Plane ? f.axes[drag.handle.axis] : f.forward;
  const dvec3 point = drag.handle.part == Part::Aim ? f.target.aim : f.center;
  return between(onPlane(drag.from, point, normal), onPlane(to, point, normal));
}

std::optional<GizmoDragged> turnedBy(const GizmoDrag& drag, const Ray& to, bool snap) {
  const GizmoFrame& f = drag.start;
  const dvec3 axis = drag.handle.part == Part::ViewRing ? -f.forward : f.axes[drag.handle.axis];
  const dvec3 zero = across(axis);
  const auto a = ringAngle(drag.from, f.center, axis, zero), b = ringAngle(to, f.center, axis, zero);
  if (!a || !b) return std::nullopt;
  double angle = nearestTurn(*b - *a, 0);
  if (snap) angle = snapped(angle, glm::radians(15.0));
  GizmoDragged out{f.target, signedFigure(glm::degrees(angle), 1) + kDegree};
  if (out.target.turns)
    out.target.rotate = eulerDegrees(turned(axis, angle) * rotationOf(f.target.rotate), f.target.rotate);
  else if (out.target.aims)
    out.target.aim = f.target.position + turned(axis, angle) * (f.target.aim - f.target.position);
  return out;
}

std::optional<GizmoDragged> scaled(const GizmoDrag& drag, const Ray& to, bool snap) {
  const GizmoFrame& f = drag.start;
  double factor = 1;
  dvec3 which(1);
  if (drag.handle.part == Part::ScaleAxis) {
    const dvec3 axis = f.axes[drag.handle.axis];
    const auto a = alongLine(drag.from, f.center, axis), b = alongLine(to, f.center, axis);
    if (!a || !b) return std::nullopt;
    factor = *b / std::max(*a, 0.1 * f.size);
    which = dvec3(0);
    which[drag.handle.axis] = 1;
  } else {
    const auto a = onPlane(drag.from, f.center, f.forward), b = onPlane(to, f.center, f.forward);
    if (!a || !b) return std::nullopt;
    // To the right and up makes it larger: an arm's length doubles it.
    factor = std::exp2(glm::dot(*b - *a, f.right + f.up) / f.size);
    if (drag.handle.part == Part::ScalePlane) which[drag.handle.axis] = 0;
  }
  factor = std::clamp(factor, 0.01, 1000.0);
  if (snap) factor = std::max(snapped(factor, 0.1), 0.1);
  GizmoDragged out{f.target, fmt::format("{} {:.2f}", kTimes, factor)};
  if (f.target.uniform) which = dvec3(1);
  out.target.scale = f.target.scale * glm::mix(dvec3(1), dvec3(factor), which);
  return out;
}

std::optional<GizmoDragged> sunMoved(const GizmoDrag& drag, const Ray& to, bool snap) {
  const GizmoFrame& f = drag.start;
  GizmoDragged out{f.target, {}};
  const dvec3 towards = scene::sunDirection(f.target.azimuth, f.target.elevation);
  if (drag.handle.part == Part::SunDisc) {
    const bool front = glm::dot(towards, f.center - drag.from.origin) < 0;
    // Where it was held stays under the pointer.
    const dvec3 held = onBall(drag.from, f.center, f.size, front), now = onBall(to, f.center, f.size, front);
    const dvec3 axis = glm::cross(held, now);
    const double sine = glm::length(axis);
    const dvec3 direction =
        sine > 1e-9 ? turned(axis / sine, std::atan2(sine, glm::dot(held, now))) * towards : towards;
    const dvec2 angles = azimuthElevation(direction, f.target.azimuth);
    out.target.azimuth = angles.x, out.target.elevation = angles.y;
  } else {
    const double azimuth = glm::radians(f.target.azimuth);
    const bool level = drag.handle.part == Part::SunAzimuth;
    // About +Y from +Z towards +X; about the horizontal axis from the horizon up.
    const dvec3 zero = level ? dvec3(0, 0, 1) : dvec3(std::sin(azimuth), 0, std::cos(azimuth));
    const dvec3 axis = level ? dvec3(0, 1, 0) : glm::cross(zero, dvec3(0, 1, 0));
    const auto a = ringAngle(drag.from, f.center, axis, zero), b = ringAngle(to, f.center, axis, zero);
    if (!a || !b) return std::nullopt;
    const double by = glm::degrees(nearestTurn(*b - *a, 0));
    if (level)
      out.target.azimuth += by;
    else
      out.target.elevation = std::clamp(out.target.elevation + by, -90.0, 90.0);
  }
  if (snap && drag.handle.part != Part::SunElevation) out.target.azimuth = snapped(out.target.azimuth, 15);
  if (snap && drag.handle.part != Part::SunAzimuth) out.target.elevation = snapped(out.target.elevation, 15);
  out.readout = fmt::format("Azimuth {}{}  Elevation {}{}", figure(out.target.azimuth, 1), kDegree,
                            figure(out.target.elevation, 1), kDegree);
  return out;
}

std::optional<GizmoDragged> coneOpened(const GizmoDrag& drag, const Ray& to, bool snap) {
  const GizmoFrame& f = drag.start;
  const dvec3 axis = glm::normalize(f.target.aim - f.target.position);
  const dvec3 side = glm::cross(axis, f.forward);
  if (glm::length(side) < 1e-6) return std::nullopt;
  const dvec3 u = glm::normalize(side);
  const auto angleAt = [&](const Ray& ray) -> std::optional<double> {
    const auto p = onPlane(ray, f.target.position, glm::cross(axis, u));
    if (!p) return std::nullopt;
    return std::atan2(std::abs(glm::dot(*p - f.target.position, u)), glm::dot(*p - f.target.position, axis));
  };
  const auto a = angleAt(drag.from), b = angleAt(to);
  if (!a || !b) return std::nullopt;
  GizmoDragged out{f.target, {}};
  out.target.cone = std::clamp(f.target.cone + 2 * glm::degrees(*b - *a), 0.1, 170.0);
  if (snap) out.target.cone = std::max(snapped(out.target.cone, 5), 5.0);
  out.readout = fmt::format("Cone {}{}", figure(out.target.cone, 1), kDegree);
  return out;
}

}  // namespace

std::optional<GizmoDragged> dragGizmo(const GizmoDrag& drag, const Ray& to, bool snap, double grid) {
  switch (drag.handle.part) {
    case Part::Axis:
    case Part::Plane:
    case Part::Free:
    case Part::Aim: {
      const auto by = translation(drag, to);
      if (!by) return std::nullopt;
      return moved(drag, *by, snap, grid,
                   drag.handle.part == Part::Aim ? &GizmoTarget::aim : &GizmoTarget::position);
    }
    case Part::Ring:
    case Part::ViewRing:
      return turnedBy(drag, to, snap);
    case Part::ScaleAxis:
    case Part::ScalePlane:
    case Part::ScaleAll:
      return scaled(drag, to, snap);
    case Part::Cone:
      return coneOpened(drag, to, snap);
    case Part::SunDisc:
    case Part::SunAzimuth:
    case Part::SunElevation:
      return sunMoved(drag, to, snap);
  }
  return std::nullopt;
}

}  // namespace pileus::editor
