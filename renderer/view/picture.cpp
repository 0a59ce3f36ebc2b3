#include "renderer/view/picture.h"

#include <cmath>

namespace pileus::view {

Result<image::Image> readBack(const Picture& picture) {
  image::Image out;
  out.size = picture.size;
  out.metadata = picture.metadata;
  image::Layer beauty;
  beauty.pixels.resize(std::size_t(picture.size.x) * std::size_t(picture.size.y) * 4);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glGetTextureImage(picture.color.id(), 0, GL_RGBA, GL_FLOAT, GLsizei(beauty.pixels.size() * sizeof(float)), beauty.pixels.data());
  for (std::size_t i = 0; i < beauty.pixels.size(); ++i)
    if (!std::isfinite(beauty.pixels[i]))
      return fail(Code::Internal, "the picture holds {} at pixel {}, {}", beauty.pixels[i], i / 4 % std::size_t(picture.size.x), i / 4 / std::size_t(picture.size.x));
  out.layers.push_back(std::move(beauty));
  return out;
}

}  // namespace pileus::view
