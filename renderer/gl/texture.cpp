#include "renderer/gl/texture.h"

#include <algorithm>
#include <utility>

#include "renderer/gl/storage.h"

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

namespace {

Result<void> checkLimits(GLenum target, ivec3 size, std::string_view label) {
  const bool layered = target == GL_TEXTURE_2D_ARRAY;
  const GLenum limit = target == GL_TEXTURE_3D ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE;
  GLint most = 0, layers = 0;
  glGetIntegerv(limit, &most);
  if (layered) glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
  const int deepest = layered ? layers : most;
  if (size.x < 1 || size.y < 1 || size.z < 1)
    return fail(Code::Internal, "{}: a texture of {} x {} x {} texels", label, size.x, size.y, size.z);
  if (size.x > most || size.y > most)
    return fail(Code::Gpu,
                "{}: {} x {} texels are wanted, this OpenGL driver holds at most {} x {} in a texture", label,
                size.x, size.y, most, most);
  if (size.z > deepest)
    return fail(Code::Gpu, "{}: {} layers are wanted, this OpenGL driver holds at most {} in a texture",
                label, size.z, deepest);
  return {};
}

}  // namespace

Result<Texture> Texture::create(GLenum target, GLenum internalFormat, ivec3 size, std::string_view label,
                                int mips) {
  PILEUS_CHECK(checkLimits(target, size, label));
  Texture t;
  t.target_ = target, t.format_ = internalFormat, t.size_ = size;
  t.bytes_ = texelBytes(internalFormat) * std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
  forgetErrors();
  glCreateTextures(target, 1, &t.id_);
  if (target == GL_TEXTURE_1D)
    glTextureStorage1D(t.id_, mips, internalFormat, size.x);
  else if (target == GL_TEXTURE_2D)
    glTextureStorage2D(t.id_, mips, internalFormat, size.x, size.y);
  else
    glTextureStorage3D(t.id_, mips, internalFormat, size.x, size.y, size.z);
  PILEUS_CHECK(checkStorage(label, t.bytes_));
  glObjectLabel(GL_TEXTURE, t.id_, static_cast<GLsizei>(label.size()), label.data());
  t.filter(GL_NEAREST);
  t.wrap(GL_CLAMP_TO_EDGE);
  return t;
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

void readTexels(const Texture& texture, GLenum format, int channels, float* out, std::size_t stripBytes) {
  const ivec2 size(texture.size());
  const std::size_t rowFloats = std::size_t(size.x) * std::size_t(channels);
  const int rows =
      int(std::clamp<std::size_t>(stripBytes / (rowFloats * sizeof(float)), 1, std::size_t(size.y)));
  for (int y = 0; y < size.y; y += rows) {
    const int count = std::min(rows, size.y - y);
    const std::size_t floats = rowFloats * std::size_t(count);
    glGetTextureSubImage(texture.id(), 0, 0, y, 0, size.x, count, 1, format, GL_FLOAT,
                         GLsizei(floats * sizeof(float)), out + rowFloats * std::size_t(y));
  }
}

void Texture::clear(const vec4& value) const { glClearTexImage(id_, 0, GL_RGBA, GL_FLOAT, &value.x); }

}  // namespace pileus::gl
