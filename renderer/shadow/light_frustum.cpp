#include "renderer/shadow/light_frustum.h"

#include <array>
#include <vector>

#include "renderer/volume/autofit.h"

namespace pileus::shadow {
namespace {

double faceScale(const LightFrustum& f, int resolution) {
  return f.kind == scene::LightKind::Point ? 1 - 2.0 / resolution : 1;
}

/// About the bulk of the media: what is fitted to a stray voxel too would have no texels left for the rest. A
/// stray outside is lit without a shadow.
LightFrustum fitSun(const scene::Light& sun, const volume::InstanceList& media, int resolution) {
  const dvec3 along = -glm::normalize(sun.towards);
  const dvec3 helper = std::abs(along.y) < 0.99 ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
  const dvec3 right = glm::normalize(glm::cross(along, helper)), down = glm::cross(along, right);
  Box3 box;  // in (right, down, along)
  for (const volume::Instance& i : media) {
    const Box3 local = volume::bulkBounds(i);
    if (local.empty() || i.emission) continue;
    for (int c = 0; c < 8; ++c) {
      const dvec3 p(i.worldFromLocal * dvec4(local.corner(c), 1.0));
      box.extend(dvec3(glm::dot(p, right), glm::dot(p, down), glm::dot(p, along)));
    }
  }
  if (box.empty()) box = {dvec3(-0.5), dvec3(0.5)};
  // Of any size, but with one: no thinner than a millionth of its largest edge.
  dvec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z, 1e-12 * glm::length(box.center()), 1e-30});
  size = glm::max(size, dvec3(1e-6 * largest));
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

/// What of a box lies within a pyramid about +z with its tip at the origin.
struct Seen {
  double nearest = std::numeric_limits<double>::infinity();  ///< along z; none: infinite
  double farthest = 0;                                       ///< from the tip
};

using Polygon = std::vector<dvec3>;

/// The part of a convex polygon with dot(normal, p) >= 0 (Sutherland and Hodgman 1974).
Polygon clipped(const Polygon& polygon, const dvec3& normal) {
  Polygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = glm::dot(normal, a), db = glm::dot(normal, b);
    if (da >= 0) out.push_back(a);
    if ((da < 0) != (db < 0)) out.push_back(a + (b - a) * (da / (da - db)));
  }
  return out;
}

/// `corners` as Box3::corner() counts them, in the pyramid's space. Whatever of the box is in the pyramid is
/// spanned by what is left of its faces, and by the tip, if that is inside.
Seen within(const std::array<dvec3, 8>& corners, double tanHalf) {
  const dvec3 sides[] = {{-1, 0, tanHalf}, {1, 0, tanHalf}, {0, -1, tanHalf}, {0, 1, tanHalf}};
  constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  Seen seen;
  for (const auto& face : kFaces) {
    Polygon polygon;
    for (const int c : face) polygon.push_back(corners[std::size_t(c)]);
    for (const dvec3& side : sides) polygon = clipped(polygon, side);
    for (const dvec3& p : polygon) {
      seen.nearest = std::min(seen.nearest, p.z);
      seen.farthest = std::max(seen.farthest, glm::length(p));
    }
  }
  return seen;
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
  // A spot's light rays meet only what lies in the pyramid of its map.
  const bool spot = light.kind == scene::LightKind::Spot;
  const dmat4 lightFromWorld = glm::inverse(out.worldFromLight);
  double near = std::numeric_limits<double>::infinity(), far = 0;
  for (const volume::Instance& i : media) {
    const Box3 box = volume::worldBulkBounds(i);
    if (box.empty() || i.emission) continue;
    std::array<dvec3, 8> corners;
    for (int c = 0; c < 8; ++c) corners[std::size_t(c)] = dvec3(lightFromWorld * dvec4(box.corner(c), 1.0));
    double nearest = distanceTo(box, light.position), farthest = 0;
    if (spot) {
      const Seen seen = within(corners, out.tanHalf);
      if (!(seen.farthest > 0)) continue;
      if (nearest > 0) nearest = std::max(nearest, seen.nearest);
      farthest = seen.farthest;
    } else {
      for (const dvec3& corner : corners) farthest = std::max(farthest, glm::length(corner));
    }
    near = std::min(near, nearest), far = std::max(far, farthest);
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

std::optional<ThinMedium> thinnestMedium(const scene::Light& light, const volume::InstanceList& media,
                                         const LightFrustum& f, int resolution) {
  std::optional<ThinMedium> worst;
  for (const volume::Instance& i : media) {
    const Box3 local = volume::bulkBounds(i);
    if (i.shape != volume::Shape::Grid || local.empty() || i.emission) continue;
    const dvec3 middle(i.worldFromLocal * dvec4(local.center(), 1));
    const dvec3 towards = f.perspective() ? light.position - middle : light.towards;
    const double away = glm::length(towards);
    if (!(away > 0) || !(std::abs(glm::determinant(glm::dmat3(i.worldFromLocal))) > 0)) continue;
    const dvec3 d(glm::inverse(i.worldFromLocal) * dvec4(towards / away, 0));
    const auto chord = intersectBox(local.center(), d, local.min, local.max);
    if (!chord) continue;
    const ThinMedium here{chord->y - chord->x,
                          f.perspective() ? 2 * f.tanHalf * away / resolution : f.texelSize(resolution)};
    if (here.thickness >= here.texel) continue;
    if (!worst || here.texel * worst->thickness > worst->texel * here.thickness) worst = here;
  }
  return worst;
}

}  // namespace pileus::shadow
