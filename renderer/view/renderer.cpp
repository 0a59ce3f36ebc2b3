#include "renderer/view/renderer.h"

#include <epoxy/gl.h>

namespace pileus::view {
namespace {

/// Bytes for bricks and maps together where the user names none: most of a GPU's memory where the driver
/// tells, else 2 GiB.
std::size_t defaultMemory(const gl::DeviceInfo& device) {
  constexpr std::size_t kGiB = std::size_t(1) << 30;
  if (device.software) return 3 * kGiB;
  if (epoxy_has_gl_extension("GL_NVX_gpu_memory_info")) {
    GLint kib = 0;
    glGetIntegerv(GL_GPU_MEMORY_INFO_CURRENT_AVAILABLE_VIDMEM_NVX, &kib);
    if (kib > 0) return std::size_t(kib) * 1024 / 10 * 7;
  }
  return 2 * kGiB;
}

}  // namespace

Renderer::Renderer(gl::DeviceInfo device, std::size_t gpuMemory)
    : device_(std::move(device)),
      gpuMemory_(gpuMemory),
      bricks_(device_, gpuMemory_ / 3 * 2),
      shadows_(gpuMemory_ / 3) {}

Result<std::unique_ptr<Renderer>> Renderer::create(const RendererOptions& options) {
  PILEUS_TRY(gl::DeviceInfo device, gl::inspectCurrentContext());
  const std::size_t memory = options.gpuMemory ? options.gpuMemory : defaultMemory(device);
  return std::unique_ptr<Renderer>(new Renderer(std::move(device), memory));
}

}  // namespace pileus::view
