#pragma once
// A rendered scene-linear picture on the GPU. Published as shared_ptr<const Picture>; its texels may still improve while it is partial.
#include <map>
#include <string>

#include "renderer/gl/texture.h"
#include "renderer/image/image.h"

namespace pileus::view {

struct Picture {
  gl::Texture color;   ///< RGBA32F, premultiplied, row 0 on top
  ivec2 size{0};
  int samples = 0;     ///< finished samples per pixel
  double fraction = 0; ///< of the whole picture; 1 = final
  std::map<std::string, std::string> metadata;
};

/// Waits for the GPU. Error (Internal) if a NaN or infinity is found, naming the pixel.
Result<image::Image> readBack(const Picture& picture);

}  // namespace pileus::view
