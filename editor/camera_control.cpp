#include "editor/camera_control.h"

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

}  // namespace pileus::editor
