#include "renderer/view/picture.h"

#include <cmath>

namespace pileus::view {

namespace {

Result<image::Layer> layerOf(const Picture& picture, const std::string& name) {
  image::Layer out;
  out.name = name;
  out.pixels.resize(std::size_t(picture.size.x) * std::size_t(picture.size.y) * 4);
  gl::readTexels(picture.color, GL_RGBA, 4, out.pixels.data());
  for (std::size_t i = 0; i < out.pixels.size(); ++i)
    if (!std::isfinite(out.pixels[i]))
      return fail(Code::Internal, "the picture{} holds {} at pixel {}, {}",
                  name.empty() ? "" : "'s layer " + name, out.pixels[i], i / 4 % std::size_t(picture.size.x),
                  i / 4 / std::size_t(picture.size.x));
  if (picture.layer.kind != PictureLayer::Kind::Depth) return out;
  out.channels = 1;
  out.data = true;
  for (std::size_t i = 0; i < out.pixels.size() / 4; ++i) out.pixels[i] = out.pixels[4 * i];
  out.pixels.resize(out.pixels.size() / 4);
  return out;
}

void blit(const Picture& from, const Picture& to, GLenum filter) {
  GLuint framebuffers[2];
  glCreateFramebuffers(2, framebuffers);
  glNamedFramebufferTexture(framebuffers[0], GL_COLOR_ATTACHMENT0, from.color.id(), 0);
  glNamedFramebufferTexture(framebuffers[1], GL_COLOR_ATTACHMENT0, to.color.id(), 0);
  const bool scissor = glIsEnabled(GL_SCISSOR_TEST);
  glDisable(GL_SCISSOR_TEST);
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
  glBlitNamedFramebuffer(framebuffers[0], framebuffers[1], 0, 0, from.size.x, from.size.y, 0, 0, to.size.x,
                         to.size.y, GL_COLOR_BUFFER_BIT, filter);
  if (scissor) glEnable(GL_SCISSOR_TEST);
  glDeleteFramebuffers(2, framebuffers);
}

}  // namespace

Result<image::Image> readBack(const Picture& picture) {
  image::Image out;
  out.size = picture.size;
  out.metadata = picture.metadata;
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  PILEUS_TRY(image::Layer beauty, layerOf(picture, {}));
  out.layers.push_back(std::move(beauty));
  for (const Picture::Named& each : picture.layers) {
    PILEUS_TRY(image::Layer layer, layerOf(*each.picture, each.name));
    out.layers.push_back(std::move(layer));
  }
  return out;
}

void stretch(const Picture& from, const Picture& to) {
  blit(from, to, from.size == to.size ? GL_NEAREST : GL_LINEAR);
}
void sample(const Picture& from, const Picture& to) { blit(from, to, GL_NEAREST); }

Result<std::shared_ptr<const Picture>> stillOf(const Picture& picture) {
  auto still = std::make_shared<Picture>();
  still->size = picture.size;
  still->samples = picture.samples;
  still->fraction = picture.fraction;
  still->metadata = picture.metadata;
  still->layer = picture.layer;
  PILEUS_TRY(still->color, gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(picture.size, 1), "still"));
  stretch(picture, *still);
  return std::shared_ptr<const Picture>(std::move(still));
}

}  // namespace pileus::view
