#pragma once
// A small grid of smooth blobs with much empty space around: densities 0 .. 1.
#include <algorithm>
#include <cmath>

#include "renderer/volume/brick_builder.h"
#include "renderer/volume/instance.h"

namespace pileus::test {

/// `density(voxel)` at the integer positions 0 .. edge - 1.
template <class Density>
volume::GridPtr gridOf(int edge, const Density& density) {
  volume::VoxelSource source;
  source.name = "made";
  source.activeMin = ivec3(0);
  source.activeMax = ivec3(edge - 1);
  source.fill = [=](ivec3 lo, float* out) {
    for (int z = 0; z < volume::kStoredSize; ++z)
      for (int y = 0; y < volume::kStoredSize; ++y)
        for (int x = 0; x < volume::kStoredSize; ++x) *out++ = density(lo + ivec3(x, y, z));
    return volume::Fill::Voxels;
  };
  JobControl control;
  return volume::buildBricks(source, control).value().grid;
}

inline float blobs(ivec3 voxel) {
  const vec3 p(voxel);
  const auto blob = [&](vec3 c, float r) { return std::max(0.0f, 1.0f - glm::length(p - c) / r); };
  return std::min(1.0f, blob(vec3(22, 24, 26), 17) + 0.8f * blob(vec3(52, 60, 50), 22));
}

/// One world unit in all, its middle at the origin.
inline volume::Instance gridInstance(const volume::GridPtr& grid, int edge, double extinction) {
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = grid;
  i.worldFromLocal =
      glm::scale(dmat4(1.0), dvec3(1.0 / edge)) * glm::translate(dmat4(1.0), dvec3(-0.5 * (edge - 1)));
  i.medium.extinction = extinction;
  return i;
}

/// A table of densities y(0 .. 1) of a part of `highest`.
template <class Y>
volume::RemapPtr table(double lowest, double highest, const Y& y) {
  std::vector<vec4> entries;
  for (int k = 0; k < volume::kRemapEntries; ++k)
    entries.emplace_back(vec3(1), static_cast<float>(y(k / (volume::kRemapEntries - 1.0))));
  return volume::makeRemap(lowest, highest, entries);
}

}  // namespace pileus::test
