#include "editor/picture/gizmo_math.h"

#include <algorithm>
#include <cmath>

namespace pileus::editor {

std::optional<double> alongLine(const Ray& ray, const dvec3& point, const dvec3& direction) {
  // Both points nearest to the other line: the difference stands on both.
  const dvec3 w = point - ray.origin;
  const double b = glm::dot(direction, ray.direction), d = glm::dot(direction, w),
               e = glm::dot(ray.direction, w);
  const double sine2 = 1 - b * b;
  if (sine2 < 1e-6) return std::nullopt;
  const double along = (b * e - d) / sine2;
  const double onRay = e + along * b;
  if (!(onRay > 0)) return std::nullopt;
  return along;
}

std::optional<dvec3> onPlane(const Ray& ray, const dvec3& point, const dvec3& normal) {
  const double slope = glm::dot(ray.direction, normal);
  if (std::abs(slope) < 1e-4) return std::nullopt;
  const double t = glm::dot(point - ray.origin, normal) / slope;
  if (!(t > 0)) return std::nullopt;
  return ray.origin + t * ray.direction;
}

std::optional<double> ringAngle(const Ray& ray, const dvec3& center, const dvec3& axis, const dvec3& zero) {
  std::optional<dvec3> p;
  if (std::abs(glm::dot(ray.direction, axis)) > 0.05) p = onPlane(ray, center, axis);
  // From the edge: the ring's line across the view.
  if (!p) {
    const dvec3 line = glm::cross(axis, ray.direction);
    if (glm::length(line) < 1e-6) return std::nullopt;
    const std::optional<double> along = alongLine(ray, center, glm::normalize(line));
    if (!along) return std::nullopt;
    // Dragging along the edge turns as rolling it would.
    const dvec3 towardsEye = glm::normalize(-ray.direction + glm::dot(ray.direction, axis) * axis);
    const double depth = glm::length(center - ray.origin);
    p = center + *along * glm::normalize(line) + 0.15 * depth * towardsEye;
  }
  const dvec3 d = *p - center;
  const double y = glm::dot(glm::cross(axis, zero), d), x = glm::dot(zero, d);
  if (x == 0 && y == 0) return std::nullopt;
  return std::atan2(y, x);
}

dvec3 onBall(const Ray& ray, const dvec3& center, double radius, bool front) {
  const dvec3 o = ray.origin - center;
  const double b = glm::dot(o, ray.direction), c = glm::dot(o, o) - radius * radius;
  const double q = b * b - c;
  const dvec3 p = o + (q > 0 ? -b + (front ? -std::sqrt(q) : std::sqrt(q)) : -b) * ray.direction;
  return glm::length(p) > 0 ? glm::normalize(p) : -ray.direction;
}

double nearestTurn(double angle, double to) { return angle - 2 * kPi * std::round((angle - to) / (2 * kPi)); }

double snapped(double value, double step) { return step > 0 ? step * std::round(value / step) : value; }
dvec3 snapped(const dvec3& v, double step) {
  return {snapped(v.x, step), snapped(v.y, step), snapped(v.z, step)};
}

dvec3 across(const dvec3& axis) {
  const dvec3 a = glm::abs(axis);
  const dvec3 least = a.x <= a.y && a.x <= a.z ? dvec3(1, 0, 0)
                      : a.y <= a.z             ? dvec3(0, 1, 0)
                                               : dvec3(0, 0, 1);
  return glm::normalize(glm::cross(axis, least));
}

glm::dmat3 turned(const dvec3& axis, double radians) {
  return glm::dmat3(glm::rotate(dmat4(1.0), radians, axis));
}

glm::dmat3 rotationOf(const dvec3& eulerDegrees) {
  return glm::dmat3(composeTransform(dvec3(0), eulerDegrees, dvec3(1)));
}

dvec3 eulerDegrees(const glm::dmat3& m, const dvec3& like) {
  const dvec3 start = glm::radians(like);
  const double sine = std::clamp(-m[0][2], -1.0, 1.0);
  dvec3 best(0);
  if (std::abs(sine) > 1 - 1e-9) {
    // Y is a quarter turn: X and Z turn about the same line, and Z stays as it was.
    const double s = sine > 0 ? 1 : -1;
    best = {0, s * 0.5 * kPi, start.z};
    best.x = nearestTurn(std::atan2(s * m[1][0], s * m[2][0]) + s * start.z, start.x);
  } else {
    double distance = std::numeric_limits<double>::infinity();
    for (const bool flip : {false, true}) {
      const double y = flip ? kPi - std::asin(sine) : std::asin(sine), sign = flip ? -1 : 1;
      const dvec3 angles(nearestTurn(std::atan2(sign * m[1][2], sign * m[2][2]), start.x),
                         nearestTurn(y, start.y),
                         nearestTurn(std::atan2(sign * m[0][1], sign * m[0][0]), start.z));
      const double d = glm::length(angles - start);
      if (d < distance) best = angles, distance = d;
    }
  }
  return glm::degrees(best);
}

dvec2 azimuthElevation(const dvec3& towards, double azimuth) {
  const dvec3 d = glm::normalize(towards);
  const double elevation = glm::degrees(std::asin(std::clamp(d.y, -1.0, 1.0)));
  if (std::hypot(d.x, d.z) < 1e-9) return {azimuth, elevation};
  const double turn = nearestTurn(std::atan2(d.x, d.z), glm::radians(azimuth));
  return {glm::degrees(turn), elevation};
}

double roundStep(double least) {
  if (!(least > 0)) return 1;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double m : {1.0, 2.0, 5.0})
    if (m * decade >= least * (1 - 1e-9)) return m * decade;
  return 10 * decade;
}

double tidy(double value, double scale) {
  const double digits = 5 - std::floor(std::log10(std::max(std::abs(scale), 1e-6)));
  // A power of ten above 1 divides exactly, so that what is rounded prints short.
  const double out = digits >= 0 ? std::round(value * std::pow(10.0, digits)) / std::pow(10.0, digits)
                                 : std::round(value / std::pow(10.0, -digits)) * std::pow(10.0, -digits);
  return out == 0 ? 0 : out;
}

dvec3 tidy(const dvec3& v, double scale) { return {tidy(v.x, scale), tidy(v.y, scale), tidy(v.z, scale)}; }

}  // namespace pileus::editor
