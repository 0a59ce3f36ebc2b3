#pragma once
// What a ray under the pointer says about lines, planes, rings and balls: the mathematics of dragging.
#include <optional>

#include "editor/picture/projection.h"

namespace pileus::editor {

/// The point of the line nearest to the ray, as a distance along `direction` (unit) from `point`. Nothing
/// where the ray runs along the line, or the point is behind its origin.
std::optional<double> alongLine(const Ray& ray, const dvec3& point, const dvec3& direction);
/// Where the ray meets the plane; nothing from behind, or where it grazes the plane.
std::optional<dvec3> onPlane(const Ray& ray, const dvec3& point, const dvec3& normal);
/// Radians about `axis` (unit, right-handed) from `zero`, which lies across it, to where the ray meets the
/// ring's plane; where the ring is seen from its edge, by the point nearest to it.
std::optional<double> ringAngle(const Ray& ray, const dvec3& center, const dvec3& axis, const dvec3& zero);
/// The unit direction from the centre to where the ray first meets the ball (`front`) or leaves it; beside
/// the ball, to the nearest point of its outline.
dvec3 onBall(const Ray& ray, const dvec3& center, double radius, bool front);
/// `angle` moved by whole turns to the one nearest to `to`; radians.
double nearestTurn(double angle, double to);
double snapped(double value, double step);
dvec3 snapped(const dvec3& value, double step);
/// A unit vector across `axis`.
dvec3 across(const dvec3& axis);

/// Degrees about X, then Y, then Z (composeTransform), of the equal ones those nearest to `like`.
dvec3 eulerDegrees(const glm::dmat3& rotation, const dvec3& like);
glm::dmat3 rotationOf(const dvec3& eulerDegrees);
glm::dmat3 turned(const dvec3& axis, double radians);
/// Azimuth (from +Z towards +X) and elevation in degrees of a direction; straight up or down keeps `azimuth`.
dvec2 azimuthElevation(const dvec3& towards, double azimuth);

/// 1, 2 or 5 times a power of ten, at least `least`.
double roundStep(double least);
/// Six significant digits of `scale`: far below a pixel, and files stay readable.
double tidy(double value, double scale);
dvec3 tidy(const dvec3& value, double scale);

}  // namespace pileus::editor
