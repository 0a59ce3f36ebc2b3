#pragma once
// The GPU services that passes share: shader programs, the brick pool, the shadow store. One per context; GL
// thread only.
#include <memory>

#include "renderer/gl/context.h"
#include "renderer/gl/shader_library.h"
#include "renderer/residency/brick_pool.h"
#include "renderer/shadow/gpu.h"
#include "renderer/shadow/shadow_store.h"

namespace pileus::view {

struct RendererOptions {
  std::size_t gpuMemory = 0;  ///< bytes for bricks and shadow maps together; 0 = chosen from the device
};

class Renderer {
 public:
  /// On the current context.
  static Result<std::unique_ptr<Renderer>> create(const RendererOptions& options = {});

  const gl::DeviceInfo& device() const { return device_; }
  gl::ShaderLibrary& shaders() { return shaders_; }
  residency::BrickPool& bricks() { return bricks_; }
  shadow::ShadowStore& shadows() { return shadows_; }
  std::size_t gpuMemory() const { return gpuMemory_; }
  /// The same services as the shadow passes and the picture passes take them.
  shadow::Gpu gpu() { return {device_, shaders_, bricks_, shadows_}; }

 private:
  Renderer(gl::DeviceInfo device, std::size_t gpuMemory);
  gl::DeviceInfo device_;
  std::size_t gpuMemory_;
  gl::ShaderLibrary shaders_;
  residency::BrickPool bricks_;
  shadow::ShadowStore shadows_;
};

}  // namespace pileus::view
