#pragma once
// A rendered scene-linear picture on the GPU. Published as shared_ptr<const Picture>; its texels may still improve while it is partial.
#include <map>
#include <memory>
#include <string>

#include "renderer/gl/texture.h"
#include "renderer/image/image.h"

namespace pileus::view {

struct RenderScene;  // render_scene.h

struct Picture {
  gl::Texture color;   ///< RGBA32F, premultiplied, row 0 on top
  ivec2 size{0};
  int samples = 0;     ///< finished samples per pixel
  double fraction = 0; ///< of the whole picture; 1 = final
  std::map<std::string, std::string> metadata;
  std::shared_ptr<const RenderScene> scene;  ///< what it shows; null for a picture made from others
};

/// Waits for the GPU. Error (Internal) if a NaN or infinity is found, naming the pixel.
Result<image::Image> readBack(const Picture& picture);

}  // namespace pileus::view
