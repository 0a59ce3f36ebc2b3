#pragma once
// Drivers that claim less than the one at hand, and memory that is not to be had: functions of the GL are
// replaced while such an object lives. One at a time; GL thread.
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "renderer/gl/texture.h"

namespace pileus::test {

/// epoxy keeps each function in a variable that the first call fills in.
template <class Function>
class Replaced {
 public:
  Replaced(Function& variable, const char* name, Function by)
      : real(reinterpret_cast<Function>(eglGetProcAddress(name))), variable_(variable) {
    variable_ = by;
  }
  ~Replaced() { variable_ = real; }
  Replaced(const Replaced&) = delete;
  Replaced& operator=(const Replaced&) = delete;

  const Function real;

 private:
  Function& variable_;
};

/// A driver with these limits (GL_MAX_...), whose GPU gives at most `bytes` at a time.
class Faults {
 public:
  static constexpr std::size_t kAny = ~std::size_t(0);

  Faults(std::map<GLenum, GLint> limits, std::size_t bytes) : limits_(std::move(limits)), bytes_(bytes) {
    self() = this;
  }
  ~Faults() { self() = nullptr; }
  int refused() const { return refused_; }  ///< storage that was asked for and not given

 private:
  static Faults*& self() {
    static Faults* f = nullptr;
    return f;
  }
  bool gives(GLenum format, ivec3 size, GLenum edge, bool layered) {
    const auto limit = [&](GLenum name) {
      const auto it = limits_.find(name);
      return it == limits_.end() ? 1 << 30 : it->second;
    };
    const int most = limit(edge), deepest = layered ? limit(GL_MAX_ARRAY_TEXTURE_LAYERS) : most;
    if (size.x > most || size.y > most || size.z > deepest) return refuse(GL_INVALID_VALUE);
    return gives(gl::texelBytes(format) * std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
  }
  bool gives(std::size_t bytes) { return bytes <= bytes_ || refuse(GL_OUT_OF_MEMORY); }
  bool refuse(GLenum error) {
    ++refused_;
    error_ = error;
    return false;
  }
  static void GLAPIENTRY getInteger(GLenum name, GLint* out) {
    const auto it = self()->limits_.find(name);
    if (it != self()->limits_.end())
      *out = it->second;
    else
      self()->getInteger_.real(name, out);
  }
  static GLenum GLAPIENTRY getError() {
    const GLenum error = std::exchange(self()->error_, GLenum(GL_NO_ERROR));
    return error != GL_NO_ERROR ? error : self()->getError_.real();
  }
  static void GLAPIENTRY storage2D(GLuint t, GLsizei mips, GLenum format, GLsizei x, GLsizei y) {
    if (self()->gives(format, ivec3(x, y, 1), GL_MAX_TEXTURE_SIZE, false))
      self()->storage2D_.real(t, mips, format, x, y);
  }
  static void GLAPIENTRY storage3D(GLuint t, GLsizei mips, GLenum format, GLsizei x, GLsizei y, GLsizei z) {
    GLint target = 0;
    glGetTextureParameteriv(t, GL_TEXTURE_TARGET, &target);
    const bool layered = target == GL_TEXTURE_2D_ARRAY;
    if (self()->gives(format, ivec3(x, y, z), layered ? GL_MAX_TEXTURE_SIZE : GL_MAX_3D_TEXTURE_SIZE,
                      layered))
      self()->storage3D_.real(t, mips, format, x, y, z);
  }
  static void GLAPIENTRY bufferStorage(GLuint b, GLsizeiptr bytes, const void* data, GLbitfield flags) {
    if (self()->gives(std::size_t(bytes))) self()->bufferStorage_.real(b, bytes, data, flags);
  }

  std::map<GLenum, GLint> limits_;
  std::size_t bytes_;
  GLenum error_ = GL_NO_ERROR;
  int refused_ = 0;
  Replaced<PFNGLGETINTEGERVPROC> getInteger_{epoxy_glGetIntegerv, "glGetIntegerv", getInteger};
  Replaced<PFNGLGETERRORPROC> getError_{epoxy_glGetError, "glGetError", getError};
  Replaced<PFNGLTEXTURESTORAGE2DPROC> storage2D_{epoxy_glTextureStorage2D, "glTextureStorage2D", storage2D};
  Replaced<PFNGLTEXTURESTORAGE3DPROC> storage3D_{epoxy_glTextureStorage3D, "glTextureStorage3D", storage3D};
  Replaced<PFNGLNAMEDBUFFERSTORAGEPROC> bufferStorage_{epoxy_glNamedBufferStorage, "glNamedBufferStorage",
                                                       bufferStorage};
};

/// Which kinds of access no barrier stands in front of since the last dispatch: named once each.
class BarrierWatch {
 public:
  BarrierWatch() { self() = this; }
  ~BarrierWatch() { self() = nullptr; }
  const std::map<std::string, int>& missing() const { return missing_; }
  int seen(const std::string& call) const {
    const auto it = seen_.find(call);
    return it == seen_.end() ? 0 : it->second;
  }

 private:
  static BarrierWatch*& self() {
    static BarrierWatch* w = nullptr;
    return w;
  }
  void needs(GLbitfield bit, const char* call) {
    ++seen_[call];
    if (dispatched_ && (barriers_ & bit) == 0) ++missing_[call];
  }
  static void GLAPIENTRY dispatch(GLuint x, GLuint y, GLuint z) {
    self()->dispatched_ = true, self()->barriers_ = 0;
    self()->dispatch_.real(x, y, z);
  }
  static void GLAPIENTRY barrier(GLbitfield bits) {
    self()->barriers_ |= bits;
    self()->barrier_.real(bits);
  }
  static void GLAPIENTRY copyImage(GLuint a, GLenum at, GLint al, GLint ax, GLint ay, GLint az, GLuint b,
                                   GLenum bt, GLint bl, GLint bx, GLint by, GLint bz, GLsizei w, GLsizei h,
                                   GLsizei d) {
    self()->needs(GL_TEXTURE_UPDATE_BARRIER_BIT, "copy image");
    self()->copyImage_.real(a, at, al, ax, ay, az, b, bt, bl, bx, by, bz, w, h, d);
  }
  static void GLAPIENTRY copyBuffer(GLuint a, GLuint b, GLintptr from, GLintptr to, GLsizeiptr bytes) {
    self()->needs(GL_BUFFER_UPDATE_BARRIER_BIT, "copy buffer");
    self()->copyBuffer_.real(a, b, from, to, bytes);
  }
  static void GLAPIENTRY subImage(GLuint t, GLint l, GLint x, GLint y, GLint z, GLsizei w, GLsizei h,
                                  GLsizei d, GLenum format, GLenum type, GLsizei bytes, void* out) {
    self()->needs(GL_TEXTURE_UPDATE_BARRIER_BIT, "read texels");
    self()->subImage_.real(t, l, x, y, z, w, h, d, format, type, bytes, out);
  }
  static void GLAPIENTRY draw(GLenum mode, GLint first, GLsizei count) {
    self()->needs(GL_FRAMEBUFFER_BARRIER_BIT, "draw");
    self()->draw_.real(mode, first, count);
  }
  static void GLAPIENTRY drawInstances(GLenum mode, GLint first, GLsizei count, GLsizei n) {
    self()->needs(GL_FRAMEBUFFER_BARRIER_BIT, "draw");
    self()->drawInstances_.real(mode, first, count, n);
  }

  bool dispatched_ = false;
  GLbitfield barriers_ = 0;
  std::map<std::string, int> missing_, seen_;
  Replaced<PFNGLDISPATCHCOMPUTEPROC> dispatch_{epoxy_glDispatchCompute, "glDispatchCompute", dispatch};
  Replaced<PFNGLMEMORYBARRIERPROC> barrier_{epoxy_glMemoryBarrier, "glMemoryBarrier", barrier};
  Replaced<PFNGLCOPYIMAGESUBDATAPROC> copyImage_{epoxy_glCopyImageSubData, "glCopyImageSubData", copyImage};
  Replaced<PFNGLCOPYNAMEDBUFFERSUBDATAPROC> copyBuffer_{epoxy_glCopyNamedBufferSubData,
                                                        "glCopyNamedBufferSubData", copyBuffer};
  Replaced<PFNGLGETTEXTURESUBIMAGEPROC> subImage_{epoxy_glGetTextureSubImage, "glGetTextureSubImage",
                                                  subImage};
  Replaced<PFNGLDRAWARRAYSPROC> draw_{epoxy_glDrawArrays, "glDrawArrays", draw};
  Replaced<PFNGLDRAWARRAYSINSTANCEDPROC> drawInstances_{epoxy_glDrawArraysInstanced, "glDrawArraysInstanced",
                                                        drawInstances};
};

}  // namespace pileus::test
