#pragma once
// The OpenGL 4.5 core context: our own headless one (EGL), or whatever is current (a GLFW window). GL thread
// only.
#include <memory>
#include <string>

#include "renderer/base/result.h"

namespace pileus::gl {

struct DeviceInfo {
  std::string vendor, renderer, version;
  bool software = false;  ///< llvmpipe and friends: smaller tiles, smaller drafts
  int maxTextureSize = 0, max3dTextureSize = 0, maxArrayLayers = 0;
  std::size_t maxStorageBytes = 0;  ///< of one shader storage block
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
