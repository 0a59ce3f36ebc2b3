#pragma once
// Passes that step through all volumes of a light ray in order (lib/ordered_march.glsl). llvmpipe ends all
// loops of an invocation once they have run 65535 times in total, and a GPU must not be held for seconds:
// long marches are cut into windows along the ray, a dispatch each; what a texel has found so far waits in a
// buffer. GL thread.
#include "renderer/shadow/map_pass.h"

namespace pileus::shadow {

class OrderedMarch {
 public:
  /// Steps of `halves` half voxels; `floats`: what a texel keeps between windows. After MapPass::prepare()
  /// said 1.
  OrderedMarch(const MapPass& pass, int halves, int floats);
  /// Variant constants of lib/ordered_march.glsl.
  gl::Defines defines() const;
  /// All windows of the region at the pass's cursor.
  Result<void> run(const Gpu& gpu, MapPass& pass, gl::Program& program);
  int windows() const { return windows_; }

 private:
  gl::Defines defines_;
  int windows_ = 1, floats_ = 0;
  gl::Buffer states_{"march states"};
};

}  // namespace pileus::shadow
