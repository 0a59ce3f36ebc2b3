#pragma once
// What the layered genera share: evaluating bricks of a field that fills the box from wall to wall.
#include "renderer/volume/cloud/bubbles.h"
#include "renderer/volume/cloud/cloud_field.h"

namespace pileus::volume {

/// CloudField::brick for a density(p, voxel) that is 0 outside of the heights low .. high.
template <class Density>
bool fillBrick(vec3 first, float voxel, float low, float high, float* out, const Density& density) {
  const float last = voxel * static_cast<float>(kBrickSize - 1);
  if (first.y > high || first.y + last < low) return false;
  bool any = false;
  for (int z = 0; z < kBrickSize; ++z)
    for (int y = 0; y < kBrickSize; ++y)
      for (int x = 0; x < kBrickSize; ++x) {
        const float v = density(first + voxel * vec3(ivec3(x, y, z)));
        if (v <= 0) continue;
        if (!any) std::fill(out, out + kBrickSize * kBrickSize * kBrickSize, 0.0f);
        any = true;
        out[(z * kBrickSize + y) * kBrickSize + x] = v;
      }
  return any;
}

/// 1 inside, fading to 0 over the outer 12 % of the half width at the walls; 0 outside the box.
inline float wallFade(vec3 p, vec3 size) {
  if (p.y <= 0 || p.y >= size.y) return 0;
  const float x = 1.0f - std::abs(2.0f * p.x / size.x - 1.0f),
              z = 1.0f - std::abs(2.0f * p.z / size.z - 1.0f);
  return rise(0.0f, 0.12f, x) * rise(0.0f, 0.12f, z);
}

}  // namespace pileus::volume
