#pragma once
// The OpenGL 4.5 core context: our own headless one (EGL), or whatever is current (a GLFW window). GL thread
// only.
#include <memory>
#include <string>

#include "renderer/base/result.h"

namespace pileus::gl {

/// What may be exceeded; the defaults are what OpenGL 4.5 guarantees. Of everything else (16 texture units
/// and 8 image units of a stage, 8 storage blocks, 16 KiB of a uniform block, 1024 invocations of a
/// workgroup, 8 colour attachments) no shader takes more than that.
struct DeviceInfo {
  std::string vendor, renderer, version;
  bool software = false;  ///< llvmpipe and friends: smaller tiles, smaller drafts
  int maxTextureSize = 16384, max3dTextureSize = 2048, maxArrayLayers = 2048;
  int maxViewport = 16384;                               ///< the lesser of width and height
  std::size_t maxBufferTexels = 65536;                   ///< of a buffer texture
  std::size_t maxStorageBytes = std::size_t(128) << 20;  ///< of one shader storage block
};

/// Checks the current context (version 4.5 or newer, compute) and reads its limits; installs the debug log.
/// Error (Gpu) names what is missing.
Result<DeviceInfo> inspectCurrentContext();

class HeadlessContext {
 public:
  /// EGL: a device platform first (a real GPU if there is one), Mesa's surfaceless platform otherwise. Made
  /// current. Error (Gpu).
  static Result<std::unique_ptr<HeadlessContext>> create();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  HeadlessContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace pileus::gl
