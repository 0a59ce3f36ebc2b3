#pragma once
// A driver that offers what OpenGL 4.5 guarantees and no more, by standing between us and the real one.
#include <gtest/gtest.h>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <map>

namespace pileus::test {

/// While one lives the driver says that it can do no more than guaranteed, and whoever asks for more fails
/// the test. One at a time, with a current context.
class GuaranteedLimits {
 public:
  static constexpr GLint kTexture = 16384, k3d = 2048, kLayers = 2048, kViewport = 16384,
                         kBufferTexels = 65536, kUnits = 16, kImages = 8, kGroups = 65535, kStorageBlocks = 8;
  static constexpr GLint64 kStorageBytes = GLint64(128) << 20;

  GuaranteedLimits() {
    epoxy_glGetIntegerv = [](GLenum name, GLint* out) {
      real().getIntegerv(name, out);
      static const std::map<GLenum, GLint> least = {{GL_MAX_TEXTURE_SIZE, kTexture},
                                                    {GL_MAX_3D_TEXTURE_SIZE, k3d},
                                                    {GL_MAX_ARRAY_TEXTURE_LAYERS, kLayers},
                                                    {GL_MAX_TEXTURE_BUFFER_SIZE, kBufferTexels},
                                                    {GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, kUnits},
                                                    {GL_MAX_IMAGE_UNITS, kImages},
                                                    {GL_MAX_UNIFORM_BLOCK_SIZE, 16384},
                                                    {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, kStorageBlocks},
                                                    {GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, 1024},
                                                    {GL_MAX_COLOR_ATTACHMENTS, 8},
                                                    {GL_MAX_DRAW_BUFFERS, 8}};
      if (const auto it = least.find(name); it != least.end()) *out = std::min(*out, it->second);
      if (name == GL_MAX_VIEWPORT_DIMS)
        out[0] = std::min(out[0], kViewport), out[1] = std::min(out[1], kViewport);
    };
    epoxy_glGetInteger64v = [](GLenum name, GLint64* out) {
      real().getInteger64v(name, out);
      if (name == GL_MAX_SHADER_STORAGE_BLOCK_SIZE) *out = std::min(*out, kStorageBytes);
    };
    epoxy_glViewport = [](GLint x, GLint y, GLsizei width, GLsizei height) {
      EXPECT_LE(std::max(width, height), kViewport) << "glViewport";
      real().viewport(x, y, width, height);
    };
    epoxy_glBindTextureUnit = [](GLuint unit, GLuint name) {
      EXPECT_LT(unit, GLuint(kUnits)) << "glBindTextureUnit";
      real().bindTextureUnit(unit, name);
    };
    epoxy_glBindImageTexture = [](GLuint unit, GLuint name, GLint level, GLboolean layered, GLint layer,
                                  GLenum access, GLenum format) {
      EXPECT_LT(unit, GLuint(kImages)) << "glBindImageTexture";
      real().bindImageTexture(unit, name, level, layered, layer, access, format);
    };
    epoxy_glBindBufferBase = [](GLenum target, GLuint index, GLuint name) {
      GLint64 bytes = 0;
      if (name) glGetNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &bytes);
      if (target == GL_SHADER_STORAGE_BUFFER) {
        EXPECT_LE(bytes, kStorageBytes) << "glBindBufferBase";
      }
      real().bindBufferBase(target, index, name);
    };
    epoxy_glTextureStorage2D = [](GLuint name, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
      EXPECT_LE(std::max(width, height), kTexture) << "glTextureStorage2D";
      real().textureStorage2D(name, levels, format, width, height);
    };
    epoxy_glTextureStorage3D = [](GLuint name, GLsizei levels, GLenum format, GLsizei width, GLsizei height,
                                  GLsizei depth) {
      GLint target = 0;
      glGetTextureParameteriv(name, GL_TEXTURE_TARGET, &target);
      EXPECT_LE(std::max(width, height), target == GL_TEXTURE_3D ? k3d : kTexture) << "glTextureStorage3D";
      EXPECT_LE(depth, target == GL_TEXTURE_3D ? k3d : kLayers) << "glTextureStorage3D";
      real().textureStorage3D(name, levels, format, width, height, depth);
    };
    epoxy_glDispatchCompute = [](GLuint x, GLuint y, GLuint z) {
      EXPECT_LE(std::max({x, y, z}), GLuint(kGroups)) << "glDispatchCompute";
      real().dispatchCompute(x, y, z);
    };
  }
  ~GuaranteedLimits() {
    epoxy_glGetIntegerv = real().getIntegerv;
    epoxy_glGetInteger64v = real().getInteger64v;
    epoxy_glViewport = real().viewport;
    epoxy_glBindTextureUnit = real().bindTextureUnit;
    epoxy_glBindImageTexture = real().bindImageTexture;
    epoxy_glBindBufferBase = real().bindBufferBase;
    epoxy_glTextureStorage2D = real().textureStorage2D;
    epoxy_glTextureStorage3D = real().textureStorage3D;
    epoxy_glDispatchCompute = real().dispatchCompute;
  }
  GuaranteedLimits(const GuaranteedLimits&) = delete;
  GuaranteedLimits& operator=(const GuaranteedLimits&) = delete;

 private:
  /// The driver's own functions.
  struct Driver {
    PFNGLGETINTEGERVPROC getIntegerv = find<PFNGLGETINTEGERVPROC>("glGetIntegerv");
    PFNGLGETINTEGER64VPROC getInteger64v = find<PFNGLGETINTEGER64VPROC>("glGetInteger64v");
    PFNGLVIEWPORTPROC viewport = find<PFNGLVIEWPORTPROC>("glViewport");
    PFNGLBINDTEXTUREUNITPROC bindTextureUnit = find<PFNGLBINDTEXTUREUNITPROC>("glBindTextureUnit");
    PFNGLBINDIMAGETEXTUREPROC bindImageTexture = find<PFNGLBINDIMAGETEXTUREPROC>("glBindImageTexture");
    PFNGLBINDBUFFERBASEPROC bindBufferBase = find<PFNGLBINDBUFFERBASEPROC>("glBindBufferBase");
    PFNGLTEXTURESTORAGE2DPROC textureStorage2D = find<PFNGLTEXTURESTORAGE2DPROC>("glTextureStorage2D");
    PFNGLTEXTURESTORAGE3DPROC textureStorage3D = find<PFNGLTEXTURESTORAGE3DPROC>("glTextureStorage3D");
    PFNGLDISPATCHCOMPUTEPROC dispatchCompute = find<PFNGLDISPATCHCOMPUTEPROC>("glDispatchCompute");
    template <class Function>
    static Function find(const char* name) {
      return reinterpret_cast<Function>(eglGetProcAddress(name));
    }
  };
  static const Driver& real() {
    static const Driver driver;
    return driver;
  }
};

}  // namespace pileus::test
