#include "editor/picture/camera_control.h"

#include <algorithm>
#include <cmath>

namespace pileus::editor {

scene::Camera orbited(const scene::Camera& camera, dvec2 drag) {
  const dvec3 offset = camera.eye - camera.target;
  const double distance = glm::length(offset);
  if (!(distance > 0)) return camera;
  const dvec3 up = glm::length(camera.up) > 0 ? glm::normalize(camera.up) : dvec3(0, 1, 0);
  // An orthonormal frame about `up`; the seed axis is the world axis least along it.
  const dvec3 seed = std::abs(up.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
  const dvec3 east = glm::normalize(glm::cross(up, seed)), north = glm::cross(east, up);
  const dvec3 d = offset / distance;
  double elevation = std::asin(std::clamp(glm::dot(d, up), -1.0, 1.0));
  double azimuth = std::atan2(glm::dot(d, east), glm::dot(d, north));
  constexpr double kPole = 0.5 * kPi - 1e-3;
  azimuth -= drag.x;
  elevation = std::clamp(elevation + drag.y, -kPole, kPole);
  scene::Camera out = camera;
  out.eye = camera.target +
            distance * (std::sin(elevation) * up +
                        std::cos(elevation) * (std::cos(azimuth) * north + std::sin(azimuth) * east));
  return out;
}

scene::Camera orbitedAbout(const scene::Camera& camera, const dvec3& pivot, dvec2 drag) {
  const scene::Camera turned = orbited(camera, drag);
  // Where the pivot is seen from: its place in the camera's own axes, which turn with the eye.
  const dvec3 seen = glm::transpose(scene::basis(camera)) * (pivot - camera.eye);
  const dvec3 shift = pivot - (turned.eye + scene::basis(turned) * seen);
  scene::Camera out = turned;
  out.eye += shift;
  out.target += shift;
  return out;
}

scene::Camera panned(const scene::Camera& camera, dvec2 drag) {
  const glm::dmat3 axes = scene::basis(camera);
  const double height =
      2 * glm::length(camera.eye - camera.target) * std::tan(0.5 * glm::radians(camera.fov));
  const dvec3 move = height * (-drag.x * axes[0] + drag.y * axes[1]);
  scene::Camera out = camera;
  out.eye += move;
  out.target += move;
  return out;
}

scene::Camera dollied(const scene::Camera& camera, double factor) {
  scene::Camera out = camera;
  const dvec3 offset = camera.eye - camera.target;
  const double distance = glm::length(offset);
  if (distance > 0) out.eye = camera.target + offset / distance * std::clamp(distance * factor, 1e-4, 1e7);
  return out;
}

scene::Camera dolliedTo(const scene::Camera& camera, const dvec3& point, double factor) {
  const double distance = glm::length(camera.eye - camera.target);
  if (!(distance > 0)) return camera;
  const double f = std::clamp(distance * factor, 1e-4, 1e7) / distance;
  scene::Camera out = camera;
  out.eye = point + f * (camera.eye - point);
  out.target = point + f * (camera.target - point);
  return out;
}

scene::Camera seenFrom(const scene::Camera& camera, const dvec3& towardsEye) {
  scene::Camera out = camera;
  const dvec3 up = glm::length(camera.up) > 0 ? glm::normalize(camera.up) : dvec3(0, 1, 0);
  const double distance = glm::length(camera.eye - camera.target);
  dvec3 d = towardsEye;
  if (std::abs(glm::dot(d, up)) > 0.9999) {
    // From above, the picture's top is away from where the camera stood.
    dvec3 level = camera.eye - camera.target;
    level -= glm::dot(level, up) * up;
    level = glm::length(level) > 1e-6 * distance ? glm::normalize(level) : dvec3(0, 0, 1);
    d = glm::normalize(d + 1e-3 * level);
  }
  out.eye = out.target + distance * d;
  return out;
}

}  // namespace pileus::editor
