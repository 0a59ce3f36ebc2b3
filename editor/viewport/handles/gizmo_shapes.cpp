// What a gizmo looks like, and which of its handles is at a point.
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "editor/viewport/handles/gizmo.h"
#include "renderer/scene/light.h"

namespace pileus::editor {
namespace {

using Part = GizmoHandle::Part;
using Ink = GizmoShape::Ink;
using Tip = GizmoShape::Tip;

constexpr int kRingPoints = 64;

Ink axisInk(int axis) { return axis == 0 ? Ink::X : axis == 1 ? Ink::Y : Ink::Z; }

struct Builder {
  const GizmoFrame& frame;
  const Projection& view;
  float pixel;
  std::vector<GizmoShape> out{};

  void line(std::optional<GizmoHandle> handle, const dvec3& a, const dvec3& b, Ink ink, Tip tip,
            bool faint = false) {
    const auto s = view.segment(a, b);
    if (!s) return;
    // A tip that is behind the camera is not drawn at the near plane.
    out.push_back(
        {handle, {s->first, s->second}, false, false, faint, ink, view.screen(b) ? tip : Tip::None});
  }
  void dot(std::optional<GizmoHandle> handle, const dvec3& at, Ink ink, Tip tip, bool faint = false) {
    if (const auto p = view.screen(at)) out.push_back({handle, {*p, *p}, false, false, faint, ink, tip});
  }
  void quad(GizmoHandle handle, const std::array<dvec3, 4>& corners, Ink ink) {
    GizmoShape shape{handle, {}, true, true, false, ink, Tip::None};
    for (const dvec3& c : corners) {
      const auto p = view.screen(c);
      if (!p) return;
      shape.line.push_back(*p);
    }
    out.push_back(std::move(shape));
  }
  /// The points of a circle from `from` to `to` (turns) that `keep` accepts, as runs.
  template <class Keep>
  void arc(std::optional<GizmoHandle> handle, const dvec3& center, const dvec3& u, const dvec3& v,
           double from, double to, Ink ink, bool faint, const Keep& keep) {
    GizmoShape shape{handle, {}, false, false, faint, ink, Tip::None};
    const auto finish = [&] {
      if (shape.line.size() > 1) out.push_back(shape);
      shape.line.clear();
    };
    for (int i = 0; i <= kRingPoints; ++i) {
      const double t = 2 * kPi * (from + (to - from) * i / kRingPoints);
      const dvec3 d = std::cos(t) * u + std::sin(t) * v;
      const auto p = view.screen(center + d);
      if (p && keep(d))
        shape.line.push_back(*p);
      else
        finish();
    }
    finish();
  }

  void moveHandles(const dvec3& center) {
    const double s = frame.size;
    for (int a = 0; a < 3; ++a) {
      const dvec3 u = frame.axes[(a + 1) % 3], v = frame.axes[(a + 2) % 3], n = frame.axes[a];
      if (std::abs(glm::dot(n, facing(center))) < 0.2) continue;
      quad({Part::Plane, a},
           {center + 0.3 * s * (u + v), center + 0.5 * s * u + 0.3 * s * v, center + 0.5 * s * (u + v),
            center + 0.3 * s * u + 0.5 * s * v},
           axisInk(a));
    }
    for (int a = 0; a < 3; ++a)
      if (std::abs(glm::dot(frame.axes[a], facing(center))) < 0.985)
        line(GizmoHandle{Part::Axis, a}, center + 0.12 * s * frame.axes[a], center + s * frame.axes[a],
             axisInk(a), Tip::Arrow);
    dot(GizmoHandle{Part::Free, 0}, center, Ink::Neutral, Tip::Box);
  }

  void turnHandles(const dvec3& center) {
    const double s = frame.size;
    const dvec3 toEye = -facing(center);
    arc(GizmoHandle{Part::ViewRing, 0}, center, 1.18 * s * frame.right, 1.18 * s * frame.up, 0, 1,
        Ink::Neutral, true, [](const dvec3&) { return true; });
    for (int a = 0; a < 3; ++a)
      arc(GizmoHandle{Part::Ring, a}, center, s * frame.axes[(a + 1) % 3], s * frame.axes[(a + 2) % 3], 0, 1,
          axisInk(a), false, [&](const dvec3& d) { return glm::dot(d, toEye) > -0.02 * s; });
  }

  void scaleHandles(const dvec3& center) {
    const double s = frame.size;
    if (!frame.target.uniform) {
      for (int a = 0; a < 3; ++a) {
        if (frame.target.flat && a != 1) continue;
        const dvec3 u = frame.axes[(a + 1) % 3], v = frame.axes[(a + 2) % 3], n = frame.axes[a];
        if (std::abs(glm::dot(n, facing(center))) < 0.2) continue;
        quad({Part::ScalePlane, a},
             {center + 0.3 * s * (u + v), center + 0.5 * s * u + 0.3 * s * v, center + 0.5 * s * (u + v),
              center + 0.3 * s * u + 0.5 * s * v},
             axisInk(a));
      }
      for (int a = 0; a < 3; ++a)
        if (!(frame.target.flat && a == 1) && std::abs(glm::dot(frame.axes[a], facing(center))) < 0.985)
          line(GizmoHandle{Part::ScaleAxis, a}, center + 0.12 * s * frame.axes[a], center + s * frame.axes[a],
               axisInk(a), Tip::Box);
    } else {
      arc(GizmoHandle{Part::ScaleAll, 0}, center, s * frame.right, s * frame.up, 0, 1, Ink::Neutral, false,
          [](const dvec3&) { return true; });
    }
    dot(GizmoHandle{Part::ScaleAll, 0}, center, Ink::Neutral, Tip::Box);
  }

  void sunHandles() {
    const double s = frame.size, azimuth = glm::radians(frame.target.azimuth);
    const dvec3 c = frame.center, toEye = -facing(c);
    const dvec3 towards = scene::sunDirection(frame.target.azimuth, frame.target.elevation);
    const dvec3 level(std::sin(azimuth), 0, std::cos(azimuth));
    const auto all = [](const dvec3&) { return true; };
    arc(std::nullopt, c, s * frame.right, s * frame.up, 0, 1, Ink::Neutral, true, all);
    arc(GizmoHandle{Part::SunAzimuth, 0}, c, s * dvec3(0, 0, 1), s * dvec3(1, 0, 0), 0, 1, Ink::Y, true,
        [&](const dvec3& d) { return glm::dot(d, toEye) <= 0; });
    arc(GizmoHandle{Part::SunAzimuth, 0}, c, s * dvec3(0, 0, 1), s * dvec3(1, 0, 0), 0, 1, Ink::Y, false,
        [&](const dvec3& d) { return glm::dot(d, toEye) >= 0; });
    arc(GizmoHandle{Part::SunElevation, 0}, c, s * level, s * dvec3(0, 1, 0), -0.25, 0.25, Ink::X,
        glm::dot(level, toEye) < 0, all);
    line(std::nullopt, c + s * towards, c + 0.12 * s * towards, Ink::Light, Tip::Arrow,
         glm::dot(towards, toEye) < 0);
    dot(GizmoHandle{Part::SunDisc, 0}, c + s * towards, Ink::Light, Tip::Sun, glm::dot(towards, toEye) < 0);
  }

  void aimHandles() {
    const GizmoTarget& t = frame.target;
    line(std::nullopt, t.position, t.aim, Ink::Light, Tip::None, true);
    if (t.hasCone && glm::length(t.aim - t.position) > 1e-9) {
      const dvec3 along = t.aim - t.position, axis = glm::normalize(along);
      const dvec3 side = glm::cross(axis, frame.forward);
      const dvec3 u = glm::length(side) > 1e-6 ? glm::normalize(side) : across(axis), v = glm::cross(axis, u);
      const double half = 0.5 * glm::radians(t.cone), reach = glm::length(along), r = reach * std::sin(half);
      const dvec3 middle = t.position + reach * std::cos(half) * axis;
      arc(std::nullopt, middle, r * u, r * v, 0, 1, Ink::Light, false, [](const dvec3&) { return true; });
      for (const double side2 : {1.0, -1.0}) {
        line(std::nullopt, t.position, middle + side2 * r * u, Ink::Light, Tip::None, true);
        dot(GizmoHandle{Part::Cone, 0}, middle + side2 * r * u, Ink::Light, Tip::Dot);
      }
    }
    dot(GizmoHandle{Part::Aim, 0}, t.aim, Ink::Light, Tip::Box);
  }

  /// From the eye to a point, unit.
  dvec3 facing(const dvec3& point) const {
    const dvec3 d = point - view.eye();
    return glm::length(d) > 0 ? glm::normalize(d) : frame.forward;
  }
};

float distanceToSegment(vec2 p, vec2 a, vec2 b) {
  const vec2 d = b - a;
  const float length2 = glm::dot(d, d);
  const float t = length2 > 0 ? std::clamp(glm::dot(p - a, d) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::length(p - a - t * d);
}

bool inside(const std::vector<vec2>& polygon, vec2 p) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const vec2 a = polygon[i], b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

/// Small things in the middle come before long lines, lines before areas and rings.
int rankOf(Part part) {
  switch (part) {
    case Part::Free:
    case Part::Aim:
    case Part::Cone:
    case Part::SunDisc:
      return 0;
    case Part::ScaleAll:
    case Part::Axis:
    case Part::ScaleAxis:
      return 1;
    case Part::Plane:
    case Part::ScalePlane:
    case Part::Ring:
    case Part::SunAzimuth:
    case Part::SunElevation:
      return 2;
    case Part::ViewRing:
      return 3;
  }
  return 3;
}

}  // namespace

std::optional<GizmoFrame> gizmoFrame(const GizmoTarget& target, GizmoMode mode, bool local,
                                     const Projection& view, float armPixels, const dvec3& sunCenter) {
  GizmoFrame f;
  f.target = target;
  f.mode = mode;
  f.center = target.sun ? sunCenter : target.moves ? target.position : target.aim;
  f.right = view.right(), f.up = view.up(), f.forward = view.forward();
  // Sizes are along the target's own axes, whatever is chosen.
  f.local = local || mode == GizmoMode::Scale;
  if (f.local && target.turns) f.axes = rotationOf(target.rotate);
  double metres = view.metresPerPixel(f.center);
  if (!(metres > 0) && target.aims) metres = view.metresPerPixel(target.aim);
  if (!(metres > 0)) return std::nullopt;
  f.size = metres * static_cast<double>(armPixels);
  const bool handles = target.sun || target.aims || (mode == GizmoMode::Move && target.moves) ||
                       (mode == GizmoMode::Rotate && target.turns) ||
                       (mode == GizmoMode::Scale && target.scales);
  return handles ? std::optional(f) : std::nullopt;
}

std::vector<GizmoShape> gizmoShapes(const GizmoFrame& frame, const Projection& view, float pixel) {
  Builder b{frame, view, pixel};
  const GizmoTarget& t = frame.target;
  if (t.sun) {
    b.sunHandles();
    return std::move(b.out);
  }
  if (t.aims) b.aimHandles();
  if (!t.moves) return std::move(b.out);
  if (frame.mode == GizmoMode::Move) b.moveHandles(frame.center);
  if (frame.mode == GizmoMode::Rotate && (t.turns || t.aims)) b.turnHandles(frame.center);
  if (frame.mode == GizmoMode::Scale && t.scales) b.scaleHandles(frame.center);
  return std::move(b.out);
}

std::optional<GizmoHandle> gizmoAt(const std::vector<GizmoShape>& shapes, vec2 at, float reach) {
  std::optional<GizmoHandle> best;
  int bestRank = 100;
  float bestDistance = 0;
  for (const GizmoShape& s : shapes) {
    if (!s.handle) continue;
    float distance = s.filled && inside(s.line, at) ? 0 : FLT_MAX;
    for (std::size_t i = 1; i < s.line.size() + (s.closed ? 1 : 0); ++i)
      distance = std::min(distance, distanceToSegment(at, s.line[i - 1], s.line[i % s.line.size()]));
    if (s.tip != GizmoShape::Tip::None)
      distance = std::min(distance, std::max(glm::length(at - s.line.back()) - 0.4f * reach, 0.0f));
    const int rank = rankOf(s.handle->part);
    if (distance > reach || rank > bestRank || (rank == bestRank && best && distance >= bestDistance))
      continue;
    best = s.handle, bestRank = rank, bestDistance = distance;
  }
  return best;
}

}  // namespace pileus::editor
