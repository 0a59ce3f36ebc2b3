#pragma once
// Picture -> display-referred 8-bit texture: exposure, then the OCIO display transform, then a dither of one code value. Float all the
// way; nothing is clamped before the view transform. GL thread.
#include <map>
#include <memory>
#include <string>

#include "renderer/gl/texture.h"
#include "renderer/image/color.h"

namespace pileus::gl {
class ShaderLibrary;
}

namespace pileus::view {

struct DisplaySettings {
  std::string display, view;  ///< "" = the config's default
  double exposure = 0;        ///< stops
  bool operator==(const DisplaySettings&) const = default;
};

class Display {
 public:
  explicit Display(gl::ShaderLibrary& shaders);
  ~Display();
  /// Draws `color` (RGBA32F, size `size`) into a texture of `outputSize` (bilinear when magnified, area-averaged when reduced) that
  /// stays owned by the Display and valid until the next call with the same slot. Alpha 1: the picture stands over black. Returns the
  /// GL texture name (RGBA8, row 0 on top). Programs are cached by the transform's key.
  Result<unsigned> draw(const gl::Texture& color, ivec2 size, ivec2 outputSize, const image::ColorConfig& config, const DisplaySettings& settings,
                        int slot = 0);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pileus::view
