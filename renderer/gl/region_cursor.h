#pragma once
// Walks a picture or map in square regions, so that no dispatch holds the window for long (a llvmpipe
// dispatch cannot be interrupted).
#include "renderer/base/math.h"
#include "renderer/gl/context.h"

namespace pileus::gl {

struct RegionCursor {
  ivec2 size{0};
  int edge = 64;
  int next = 0;
  ivec2 at{0};  ///< the first pixel: a part of a larger picture

  RegionCursor() = default;
  RegionCursor(ivec2 extent, const DeviceInfo& device, int softwareEdge = 64)
      : size(extent), edge(device.software ? softwareEdge : 512) {}

  ivec2 grid() const { return (size + edge - 1) / edge; }
  int count() const { return grid().x * grid().y; }
  bool done() const { return next >= count(); }
  ivec2 origin() const { return at + edge * ivec2(next % grid().x, next / grid().x); }
  ivec2 end() const { return glm::min(origin() + edge, at + size); }
};

}  // namespace pileus::gl
