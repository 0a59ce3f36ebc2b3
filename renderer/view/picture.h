#pragma once
// A rendered scene-linear picture on the GPU. Published as shared_ptr<const Picture>; its texels may still
// improve while it is partial.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "renderer/gl/texture.h"
#include "renderer/image/image.h"
#include "renderer/view/picture_layer.h"

namespace pileus::view {

struct RenderScene;  // render_scene.h

struct Picture {
  gl::Texture color;  ///< RGBA32F, premultiplied, row 0 on top
  ivec2 size{0};
  int samples = 0;      ///< finished samples per pixel
  double fraction = 0;  ///< of the whole picture; 1 = final
  double besideMs = 0;  ///< what took as long whatever its size: shadow maps of suns that stand for
                        ///< environments, cells of scattered light
  std::map<std::string, std::string> metadata;
  std::shared_ptr<const RenderScene> scene;  ///< what it shows; null for a picture made from others
  PictureLayer layer;                        ///< what `color` holds
  struct Named {
    std::string name;  ///< as files have it: "depth", "light1"
    std::shared_ptr<const Picture> picture;
  };
  std::vector<Named> layers;  ///< made beside it, of the same size
};

/// The texels of `from`, stretched, as those of `to`.
void stretch(const Picture& from, const Picture& to);
/// The same without mixing: each texel of `to` is one of `from`.
void sample(const Picture& from, const Picture& to);
/// Texels alone, without the scene that keeps volumes and maps alive.
Result<std::shared_ptr<const Picture>> stillOf(const Picture& picture);

/// With its layers; depth has one channel. Waits for the GPU. Error (Internal) if a NaN or infinity is found,
/// naming the pixel.
Result<image::Image> readBack(const Picture& picture);

}  // namespace pileus::view
