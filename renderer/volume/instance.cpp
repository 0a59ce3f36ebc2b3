#include "renderer/volume/instance.h"

namespace pileus::volume {
namespace {

bool inside(const Box3& box, const dvec3& p) {
  return glm::all(glm::greaterThanEqual(p, box.min)) && glm::all(glm::lessThanEqual(p, box.max));
}

/// At a local position, before any table.
double rawDensity(const Instance& i, const dvec3& p) {
  switch (i.shape) {
    case Shape::Grid:
      return i.grid ? sampleTrilinear(*i.grid, p) : 0.0;
    case Shape::Box:
      return glm::all(glm::lessThanEqual(glm::abs(p), dvec3(0.5))) ? i.density : 0.0;
    case Shape::Ball:
      return glm::dot(p, p) <= 1.0 ? i.density : 0.0;
  }
  return 0;
}

}  // namespace

Box3 localBounds(const Instance& i) {
  switch (i.shape) {
    case Shape::Grid:
      return i.grid && !i.grid->empty() ? i.grid->indexBounds : Box3{};
    case Shape::Box:
      return {dvec3(-0.5), dvec3(0.5)};
    case Shape::Ball:
      return {dvec3(-1.0), dvec3(1.0)};
  }
  return {};
}

Box3 worldBounds(const Instance& i) { return transformed(localBounds(i), i.worldFromLocal); }

Box3 worldBounds(const InstanceList& instances) {
  Box3 box;
  for (const Instance& i : instances) box.extend(worldBounds(i));
  return box;
}

double detailSize(const Instance& i) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    smallest = std::min(smallest, glm::length(dvec3(i.worldFromLocal[axis])));
  if (i.shape == Shape::Grid) return smallest;
  return smallest * (i.shape == Shape::Ball ? 2.0 : 1.0) / 64.0;
}

double largestDensity(const Instance& i) {
  if (i.shape != Shape::Grid) return i.density;
  if (!i.grid) return 0;
  const double most = double(i.grid->maximum);
  return i.remap ? i.remap->largest(std::min(0.0, double(i.grid->minimum)), most) : most;
}

bool emits(const Instance& i) {
  if (!i.emission) return false;
  if (i.shape != Shape::Grid) return i.emission->density(i.density) > 0;
  return i.grid && i.emission->largest(std::min(0.0, double(i.grid->minimum)), double(i.grid->maximum)) > 0;
}

bool occupied(const Instance& i, const Brick& brick) {
  const RemapPtr& table = i.emission ? i.emission : i.remap;
  return double(brick.maximum) > (table ? table->emptyUpTo : 0.0);
}

double majorant(const Instance& i) {
  return i.emission ? 0.0 : std::max(0.0, largestDensity(i) * i.medium.largestExtinction());
}

Key contentKey(const InstanceList& instances) {
  Hasher h;
  h.add(instances.size());
  for (const Instance& i : instances) {
    h.add(i.shape).add(i.density).add(i.medium.extinction);
    for (const scene::PhaseLobe& l : {i.medium.phase.first, i.medium.phase.second}) h.add(l.g).add(l.alpha);
    h.add(i.medium.phase.blend);
    for (int c = 0; c < 3; ++c) h.add(i.medium.albedo[c]).add(i.medium.extinctionColor[c]);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) h.add(i.worldFromLocal[c][r]);
    if (i.grid) h.add(i.grid->content);
    if (i.remap) h.add(i.remap->content);
    if (i.emission) h.add(true).add(i.emission->content);
  }
  return h.key();
}

double sigmaAt(const Instance& i, const dvec3& world) {
  if (i.emission) return 0;
  const dvec3 p = dvec3(glm::inverse(i.worldFromLocal) * dvec4(world, 1.0));
  double density = rawDensity(i, p);
  if (i.remap) density = inside(localBounds(i), p) ? i.remap->density(density) : 0.0;
  return std::max(0.0, density * i.medium.meanExtinction());
}

dvec3 emissionAt(const Instance& i, const dvec3& world) {
  if (!i.emission) return dvec3(0);
  const dvec3 p = dvec3(glm::inverse(i.worldFromLocal) * dvec4(world, 1.0));
  const bool within = i.shape == Shape::Ball ? glm::dot(p, p) <= 1.0 : inside(localBounds(i), p);
  return within ? dvec3(i.emission->at(rawDensity(i, p))) : dvec3(0);
}

}  // namespace pileus::volume
