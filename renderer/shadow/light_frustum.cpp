#include "renderer/shadow/light_frustum.h"

namespace pileus::shadow {
namespace {

double faceScale(const LightFrustum& f, int resolution) {
  return f.kind == scene::LightKind::Point ? 1 - 2.0 / resolution : 1;
}

LightFrustum fitSun(const scene::Light& sun, const volume::InstanceList& media, int resolution) {
  const dvec3 along = -glm::normalize(sun.towards);
  const dvec3 helper = std::abs(along.y) < 0.99 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 right = glm::normalize(glm::cross(along, helper)), down = glm::cross(along, right);
  Box3 box;  // in (right, down, along)
  for (const volume::Instance& i : media) {
    const Box3 local = volume::localBounds(i);
    if (local.empty() || i.emission) continue;
    for (int c = 0; c < 8; ++c) {
      const dvec3 p(i.worldFromLocal * dvec4(local.corner(c), 1.0));
      box.extend(dvec3(glm::dot(p, right), glm::dot(p, down), glm::dot(p, along)));
    }
  }
  if (box.empty()) box = {dvec3(-0.5), dvec3(0.5)};
  dvec3 size = glm::max(box.size(), dvec3(1e-6 * (1.0 + glm::length(box.center()))));
  // Across: one texel of border on each side, the lower corner on a multiple of the texel size. Along: a hair
  // of room, so that no face lies exactly on the near or far plane.
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

/// Nearest point of a box's surface or inside: 0 there.
double distanceTo(const Box3& box, const dvec3& p) {
  return glm::length(glm::max(glm::max(box.min - p, p - box.max), dvec3(0)));
}

LightFrustum fitLocal(const scene::Light& light, const volume::InstanceList& media) {
  LightFrustum out;
  out.kind = light.kind;
  dvec3 along(0, 0, 1), right(1, 0, 0), down(0, 1, 0);
  if (light.kind == scene::LightKind::Spot) {
    along = -glm::normalize(light.towards);
    right = glm::normalize(glm::cross(along, std::abs(along.y) < 0.99 ? dvec3(0, 1, 0) : dvec3(0, 0, 1)));
    down = glm::cross(along, right);
    // One texel of border is too little to matter here; a whole percent keeps the cone's edge off the map's.
    out.tanHalf = 1.01 * std::tan(glm::radians(std::min(light.cone, 179.0)) / 2);
  }
  out.worldFromLight = dmat4(dvec4(right, 0), dvec4(down, 0), dvec4(along, 0), dvec4(light.position, 1));
  double near = std::numeric_limits<double>::infinity(), far = 0;
  for (const volume::Instance& i : media) {
    const Box3 box = volume::worldBounds(i);
    if (box.empty() || i.emission) continue;
    near = std::min(near, distanceTo(box, light.position));
    for (int c = 0; c < 8; ++c) far = std::max(far, glm::length(box.corner(c) - light.position));
  }
  if (far <= 0) near = 0, far = 1;
  out.nearDistance = 0.999 * near;
  out.farDistance = 1.001 * far;
  return out;
}

}  // namespace

LightFrustum fitLight(const scene::Light& light, const volume::InstanceList& media, int resolution) {
  return light.kind == scene::LightKind::Sun ? fitSun(light, media, resolution) : fitLocal(light, media);
}

MapPoint mapCoordinates(const LightFrustum& f, const dvec3& world, int resolution) {
  const dvec3 q(glm::inverse(f.worldFromLight) * dvec4(world, 1));
  if (!f.perspective()) return {q, 0};
  const dvec3 a = glm::abs(q);
  const int axis = f.kind == scene::LightKind::Spot ? 2 : a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  const dvec2 across(q[(axis + 1) % 3], q[(axis + 2) % 3]);
  const bool point = f.kind == scene::LightKind::Point;
  const double depth = point ? std::abs(q[axis]) : q.z, x = (glm::length(q) - f.nearDistance) / f.depth();
  const int face = point ? 2 * axis + (q[axis] < 0 ? 1 : 0) : 0;
  if (!(depth > 0)) return {dvec3(-1, -1, x), face};
  return {dvec3(0.5 + 0.5 * faceScale(f, resolution) * across / (depth * f.tanHalf), x), face};
}

MapSegment mapSegment(const LightFrustum& f, int face, dvec2 uv, int resolution) {
  if (!f.perspective())
    return {dvec3(f.worldFromLight * dvec4(uv, 0, 1)), dvec3(f.worldFromLight * dvec4(uv, 1, 1))};
  const dvec2 across = (2.0 * uv - 1.0) / faceScale(f, resolution) * f.tanHalf;
  dvec3 q(across, 1);
  if (f.kind == scene::LightKind::Point) {
    const int axis = face >> 1;
    q[axis] = face & 1 ? -1 : 1;
    q[(axis + 1) % 3] = across.x;
    q[(axis + 2) % 3] = across.y;
  }
  const dvec3 d = glm::normalize(dvec3(f.worldFromLight * dvec4(q, 0))), origin(f.worldFromLight[3]);
  return {origin + f.nearDistance * d, origin + f.farDistance * d};
}

}  // namespace pileus::shadow
