#include "renderer/scene/camera.h"

#include <algorithm>

namespace pileus::scene {

glm::dmat3 basis(const Camera& camera) {
  dvec3 back = camera.eye - camera.target;
  back = glm::length(back) > 1e-12 ? glm::normalize(back) : dvec3(0, 0, 1);
  dvec3 right = glm::cross(camera.up, back);
  if (glm::length(right) < 1e-9)
    right = glm::cross(std::abs(back.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(0, 0, -1), back);
  right = glm::normalize(right);
  return {right, glm::cross(back, right), back};
}

dvec3 rayDirection(const Camera& camera, double aspect, dvec2 uv) {
  const double h = std::tan(glm::radians(camera.fov) / 2);
  const dvec3 d((2 * uv.x - 1) * h * aspect, (1 - 2 * uv.y) * h, -1.0);
  return glm::normalize(basis(camera) * d);
}

Camera frameBounds(const Box3& bounds, double aspect, double fov) {
  Camera camera;
  camera.fov = fov;
  camera.target = dvec3(0);
  camera.eye = dvec3(0.45, 0.28, 1.0);
  return frameBounds(bounds, aspect, camera);
}

Camera frameBounds(const Box3& bounds, double aspect, const Camera& camera) {
  const Box3 box = bounds.empty() ? Box3{dvec3(-0.5), dvec3(0.5)} : bounds;
  const glm::dmat3 axes = basis(camera);
  const double th = std::tan(glm::radians(camera.fov) / 2), tw = th * aspect;
  double distance = 1e-6;
  for (int i = 0; i < 8; ++i) {
    const dvec3 p = glm::transpose(axes) * (box.corner(i) - box.center());  // right, up, towards the eye
    distance = std::max({distance, p.z + std::abs(p.x) / tw, p.z + std::abs(p.y) / th});
  }
  Camera out = camera;
  out.target = box.center();
  out.eye = out.target + axes[2] * distance * 1.05;
  return out;
}

}  // namespace pileus::scene
