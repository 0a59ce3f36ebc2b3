#include "renderer/gl/buffer.h"

#include <algorithm>

#include "renderer/gl/storage.h"

namespace pileus::gl {

void Buffer::reset() {
  if (texels_) glDeleteTextures(1, &texels_);
  if (id_) glDeleteBuffers(1, &id_);
  id_ = texels_ = 0;
  capacity_ = 0;
}

Result<void> Buffer::reserve(std::size_t bytes) {
  if (id_ && bytes <= capacity_) return {};
  const std::size_t wanted = std::max({bytes, capacity_ * 2, std::size_t(256)});
  const std::size_t size =
      wanted > bytes && wanted > (std::size_t(64) << 20) ? std::max(bytes, std::size_t(256)) : wanted;
  reset();
  forgetErrors();
  glCreateBuffers(1, &id_);
  glNamedBufferStorage(id_, static_cast<GLsizeiptr>(size), nullptr, GL_DYNAMIC_STORAGE_BIT);
  if (auto stored = checkStorage(label_, size); !stored) {
    reset();
    return stored;
  }
  if (!label_.empty()) glObjectLabel(GL_BUFFER, id_, static_cast<GLsizei>(label_.size()), label_.data());
  capacity_ = size;
  return {};
}

void Buffer::bindTexels(GLuint unit, GLenum format) const {
  if (!texels_) {
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &texels_);
    glTextureBuffer(texels_, format, id_);
  }
  glBindTextureUnit(unit, texels_);
}

Result<void> Buffer::assign(const void* data, std::size_t bytes) {
  PILEUS_CHECK(reserve(bytes));
  if (bytes > 0) glNamedBufferSubData(id_, 0, static_cast<GLsizeiptr>(bytes), data);
  return {};
}

}  // namespace pileus::gl
