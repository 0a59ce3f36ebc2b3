#include "renderer/gl/texture.h"

#include <utility>

namespace pileus::gl {

std::size_t texelBytes(GLenum format) {
  switch (format) {
    case GL_R8:
      return 1;
    case GL_R16:
    case GL_R16F:
      return 2;
    case GL_RGBA8:
    case GL_R32F:
    case GL_RG16F:
      return 4;
    case GL_RGBA16:
    case GL_RGBA16F:
    case GL_RG32F:
      return 8;
    case GL_RGB32F:
      return 12;
    default:
      return 16;
  }
}

Texture::Texture(GLenum target, GLenum internalFormat, ivec3 size, std::string_view label, int mips)
    : target_(target), format_(internalFormat), size_(size) {
  glCreateTextures(target, 1, &id_);
  if (target == GL_TEXTURE_1D)
    glTextureStorage1D(id_, mips, internalFormat, size.x);
  else if (target == GL_TEXTURE_2D)
    glTextureStorage2D(id_, mips, internalFormat, size.x, size.y);
  else
    glTextureStorage3D(id_, mips, internalFormat, size.x, size.y, size.z);
  glObjectLabel(GL_TEXTURE, id_, static_cast<GLsizei>(label.size()), label.data());
  filter(GL_NEAREST);
  wrap(GL_CLAMP_TO_EDGE);
  bytes_ = texelBytes(internalFormat) * std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

Texture Texture::view(const Texture& of, GLenum internalFormat, std::string_view label) {
  Texture t;
  t.target_ = of.target_, t.format_ = internalFormat, t.size_ = of.size_;
  const GLuint layers = of.target_ == GL_TEXTURE_2D_ARRAY ? static_cast<GLuint>(of.size_.z) : 1u;
  glGenTextures(1, &t.id_);  // a view needs a name without a target
  glTextureView(t.id_, of.target_, of.id_, internalFormat, 0, 1, 0, layers);
  glObjectLabel(GL_TEXTURE, t.id_, static_cast<GLsizei>(label.size()), label.data());
  t.filter(GL_NEAREST);
  t.wrap(GL_CLAMP_TO_EDGE);
  return t;
}

void Texture::reset() {
  if (id_) glDeleteTextures(1, &id_);
  id_ = 0;
}

void Texture::swap(Texture& o) noexcept {
  std::swap(id_, o.id_);
  std::swap(target_, o.target_);
  std::swap(format_, o.format_);
  std::swap(size_, o.size_);
  std::swap(bytes_, o.bytes_);
}

void Texture::filter(GLenum mode) const {
  glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(mode));
  glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mode));
}

void Texture::wrap(GLenum mode) const {
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(id_, axis, static_cast<GLint>(mode));
}

void Texture::clear(const vec4& value) const { glClearTexImage(id_, 0, GL_RGBA, GL_FLOAT, &value.x); }

}  // namespace pileus::gl
