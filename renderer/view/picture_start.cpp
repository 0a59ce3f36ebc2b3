#include "renderer/view/picture_start.h"

namespace pileus::view {

Result<std::shared_ptr<Picture>> startPicture(std::shared_ptr<const RenderScene> scene, const Picture* seed) {
  const RenderOptions& o = scene->options;
  auto picture = std::make_shared<Picture>();
  PILEUS_TRY(picture->color, gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(o.size, 1), "picture"));
  picture->size = o.size;
  picture->layer = o.layer;
  if (seed && seed->layer == o.layer)
    stretch(*seed, *picture);
  else
    picture->color.clear();
  picture->scene = std::move(scene);
  return picture;
}

gl::RegionCursor startRegions(const RenderOptions& o, const gl::DeviceInfo& device) {
  const ivec2 lo = glm::clamp(ivec2(glm::floor(o.region.min * dvec2(o.size))), ivec2(0), o.size - 1);
  const ivec2 hi = glm::clamp(ivec2(glm::ceil(o.region.max * dvec2(o.size))), lo + 1, o.size);
  return gl::RegionCursor(hi - lo, device, 1, lo);
}

}  // namespace pileus::view
