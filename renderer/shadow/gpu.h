#pragma once
// The GPU services the shadow passes work with. All references outlive the passes; GL thread only.
#include "renderer/gl/shader_library.h"
#include "renderer/residency/brick_pool.h"
#include "renderer/shadow/shadow_store.h"

namespace pileus::shadow {

struct Gpu {
  const gl::DeviceInfo& device;
  gl::ShaderLibrary& shaders;
  residency::BrickPool& bricks;
  ShadowStore& store;
};

}  // namespace pileus::shadow
