#include "renderer/gl/context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

#include "renderer/base/log.h"

namespace pileus::gl {
namespace {

void GLAPIENTRY onDebugMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text,
                               const void*) {
  if (type == GL_DEBUG_TYPE_ERROR || severity == GL_DEBUG_SEVERITY_HIGH)
    log::error("OpenGL: {}", text);
  else if (type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR || type == GL_DEBUG_TYPE_PORTABILITY)
    log::debug("OpenGL: {}", text);
}

std::string glText(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "unknown";
}

int glInt(GLenum name) {
  GLint v = 0;
  glGetIntegerv(name, &v);
  return v;
}

bool isSoftware(std::string_view renderer) {
  return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos ||
         renderer.find("SwiftShader") != renderer.npos;
}

/// A context on one display, or nothing; the display is terminated where it did not work out.
void* tryContext(EGLDisplay display) {
  EGLint major = 0, minor = 0;
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) return nullptr;
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                      EGL_NONE};
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               5,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  eglBindAPI(EGL_OPENGL_API);
  if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count == 0)
    config = EGL_NO_CONFIG_KHR;
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
    return nullptr;
  }
  return context;
}

}  // namespace

Result<DeviceInfo> inspectCurrentContext() {
  const int version = epoxy_gl_version();
  DeviceInfo info;
  info.vendor = glText(GL_VENDOR);
  info.renderer = glText(GL_RENDERER);
  info.version = glText(GL_VERSION);
  if (!epoxy_is_desktop_gl() || version < 45)
    return fail(Code::Gpu,
                "OpenGL 4.5 is needed; {} offers {}. Update the driver, or set LIBGL_ALWAYS_SOFTWARE=1",
                info.renderer, info.version);
  info.software = isSoftware(info.renderer);
  info.maxTextureSize = glInt(GL_MAX_TEXTURE_SIZE);
  info.max3dTextureSize = glInt(GL_MAX_3D_TEXTURE_SIZE);
  info.maxArrayLayers = glInt(GL_MAX_ARRAY_TEXTURE_LAYERS);
  GLint viewport[2] = {};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
  info.maxViewport = std::min(viewport[0], viewport[1]);
  info.maxBufferTexels = static_cast<std::size_t>(glInt(GL_MAX_TEXTURE_BUFFER_SIZE));
  GLint64 storage = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &storage);
  info.maxStorageBytes = static_cast<std::size_t>(storage);
  glEnable(GL_DEBUG_OUTPUT);
  glDebugMessageCallback(onDebugMessage, nullptr);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  log::debug("OpenGL {} on {}", info.version, info.renderer);
  return info;
}

Result<std::unique_ptr<HeadlessContext>> HeadlessContext::create() {
  std::unique_ptr<HeadlessContext> out(new HeadlessContext);
  const auto adopt = [&](EGLDisplay display) {
    out->context_ = tryContext(display);
    if (out->context_) out->display_ = display;
    return out->context_ != nullptr;
  };
  // Two rounds over the devices: real GPUs first, then whatever is left (llvmpipe's device).
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    EGLDeviceEXT devices[32];
    EGLint count = 0;
    if (eglQueryDevicesEXT(32, devices, &count)) {
      for (int i = 0; i < count; ++i) {
        const char* extensions = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
        const bool software = extensions && std::strstr(extensions, "EGL_MESA_device_software");
        if (!software && adopt(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr)))
          return out;
      }
    }
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") &&
      adopt(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)))
    return out;
  if (adopt(eglGetDisplay(EGL_DEFAULT_DISPLAY))) return out;
  return fail(Code::Gpu, "no OpenGL 4.5 through EGL: install libgl1-mesa-dri (software) or a GPU driver");
}

HeadlessContext::~HeadlessContext() {
  if (!context_) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

}  // namespace pileus::gl
