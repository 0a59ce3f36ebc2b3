#include "renderer/shadow/light_frustum.h"

namespace pileus::shadow {

LightFrustum fitSun(const scene::Light& sun, const volume::InstanceList& media, int resolution) {
  const dvec3 along = -glm::normalize(sun.towards);
  const dvec3 helper = std::abs(along.y) < 0.99 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 right = glm::normalize(glm::cross(along, helper)), down = glm::cross(along, right);
  Box3 box;  // in (right, down, along)
  for (const volume::Instance& i : media) {
    const Box3 local = volume::localBounds(i);
    if (local.empty()) continue;
    for (int c = 0; c < 8; ++c) {
      const dvec3 p(i.worldFromLocal * dvec4(local.corner(c), 1.0));
      box.extend(dvec3(glm::dot(p, right), glm::dot(p, down), glm::dot(p, along)));
    }
  }
  if (box.empty()) box = {dvec3(-0.5), dvec3(0.5)};
  dvec3 size = glm::max(box.size(), dvec3(1e-6 * (1.0 + glm::length(box.center()))));
  // Across: one texel of border on each side, the lower corner on a multiple of the texel size. Along: a hair of room, so that no face
  // lies exactly on the near or far plane.
  const double texels = std::max(resolution - 3, 1);
  for (int a = 0; a < 2; ++a) {
    const double texel = size[a] / texels;
    box.min[a] = (std::floor(box.min[a] / texel) - 1.0) * texel;
    size[a] = texel * resolution;
  }
  box.min.z -= 1e-4 * size.z;
  size.z *= 1.0002;
  LightFrustum out;
  out.worldFromLight[0] = dvec4(right * size.x, 0.0);
  out.worldFromLight[1] = dvec4(down * size.y, 0.0);
  out.worldFromLight[2] = dvec4(along * size.z, 0.0);
  out.worldFromLight[3] = dvec4(right * box.min.x + down * box.min.y + along * box.min.z, 1.0);
  return out;
}

}  // namespace pileus::shadow
