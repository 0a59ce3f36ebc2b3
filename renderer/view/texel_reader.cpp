#include "renderer/view/texel_reader.h"

#include <algorithm>

namespace pileus::view {

void TexelReader::request(const gl::Texture& texture, ivec2 lo, ivec2 size) {
  forget();
  const ivec2 whole(texture.size());
  lo = glm::clamp(lo, ivec2(0), whole - 1);
  size = glm::clamp(size, ivec2(1), whole - lo);
  count_ = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  if (!buffer_.reserve(count_ * sizeof(vec4))) return;
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  glGetTextureSubImage(texture.id(), 0, lo.x, lo.y, 0, size.x, size.y, 1, GL_RGBA, GL_FLOAT,
                       static_cast<GLsizei>(count_ * sizeof(vec4)), nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

std::optional<std::vector<vec4>> TexelReader::take() {
  if (!fence_) return std::nullopt;
  const GLenum state = glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
  if (state == GL_TIMEOUT_EXPIRED) return std::nullopt;
  forget();
  std::vector<vec4> texels(count_);
  glGetNamedBufferSubData(buffer_.id(), 0, static_cast<GLsizeiptr>(count_ * sizeof(vec4)), texels.data());
  return texels;
}

void TexelReader::forget() {
  if (fence_) glDeleteSync(fence_);
  fence_ = nullptr;
}

}  // namespace pileus::view
