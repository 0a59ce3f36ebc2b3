#include "renderer/gl/storage.h"

#include <epoxy/gl.h>

#include <cmath>

namespace pileus::gl {

std::string neededMib(std::size_t bytes) {
  return fmt::format("{:.1f} MiB", std::ceil(static_cast<double>(bytes) / (1 << 20) * 10) / 10);
}
std::string givenMib(std::size_t bytes) {
  return fmt::format("{:.1f} MiB", std::floor(static_cast<double>(bytes) / (1 << 20) * 10) / 10);
}

void forgetErrors() {
  constexpr int kMost = 16;  // a lost context has no end of them
  for (int i = 0; i < kMost && glGetError() != GL_NO_ERROR; ++i) {
  }
}

Result<void> checkStorage(std::string_view label, std::size_t bytes) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return {};
  if (error == GL_OUT_OF_MEMORY)
    return fail(Code::Gpu, "{}: out of GPU memory: {:.1f} MiB more are needed", label,
                static_cast<double>(bytes) / (1 << 20));
  return fail(Code::Gpu, "{}: the OpenGL driver refuses {:.1f} MiB (error 0x{:04x})", label,
              static_cast<double>(bytes) / (1 << 20), error);
}

}  // namespace pileus::gl
