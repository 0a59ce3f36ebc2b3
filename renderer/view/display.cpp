#include "renderer/view/display.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/gl/shader_library.h"
#include "renderer/shaders/shared/bindings.h"

namespace pileus::view {
namespace {

Result<gl::Texture> upload(const image::LutTexture& lut) {
  const GLenum format = lut.channels == 1 ? GL_R32F : GL_RGB32F;
  const GLenum target = lut.dimensions == 3   ? GL_TEXTURE_3D
                        : lut.dimensions == 2 ? GL_TEXTURE_2D
                                              : GL_TEXTURE_1D;
  PILEUS_TRY(gl::Texture t, gl::Texture::create(target, format, glm::max(lut.size, ivec3(1)), lut.sampler));
  const GLenum pixels = lut.channels == 1 ? GL_RED : GL_RGB;
  if (lut.dimensions == 3)
    glTextureSubImage3D(t.id(), 0, 0, 0, 0, lut.size.x, lut.size.y, lut.size.z, pixels, GL_FLOAT,
                        lut.texels.data());
  else if (lut.dimensions == 1)
    glTextureSubImage1D(t.id(), 0, 0, lut.size.x, pixels, GL_FLOAT, lut.texels.data());
  else
    glTextureSubImage2D(t.id(), 0, 0, 0, lut.size.x, std::max(lut.size.y, 1), pixels, GL_FLOAT,
                        lut.texels.data());
  t.filter(lut.linear ? GL_LINEAR : GL_NEAREST);
  return t;
}

/// An OCIO transform on the GPU.
struct Compiled {
  gl::Program* program = nullptr;
  std::vector<std::pair<std::string, gl::Texture>> luts;
};

}  // namespace

const std::array<vec3, kExposureBands>& exposureBands() {
  // Cold to hot around a neutral middle; each differs from its neighbours in lightness, too.
  static const std::array<vec3, kExposureBands> bands{
      vec3(0.04f, 0.02f, 0.06f), vec3(0.20f, 0.06f, 0.30f), vec3(0.30f, 0.16f, 0.52f),
      vec3(0.20f, 0.26f, 0.66f), vec3(0.16f, 0.42f, 0.76f), vec3(0.12f, 0.56f, 0.68f),
      vec3(0.22f, 0.62f, 0.44f), vec3(0.50f, 0.50f, 0.50f), vec3(0.56f, 0.70f, 0.30f),
      vec3(0.82f, 0.80f, 0.28f), vec3(0.94f, 0.66f, 0.20f), vec3(0.92f, 0.46f, 0.16f),
      vec3(0.86f, 0.24f, 0.16f), vec3(0.94f, 0.50f, 0.52f), vec3(1.00f, 0.94f, 0.94f)};
  return bands;
}

struct Display::Impl {
  gl::ShaderLibrary* shaders;
  std::map<std::string, Compiled> compiled;  ///< by the config's content, display, view and look
  std::map<int, gl::Texture> targets;
  GLuint framebuffer = 0, vertices = 0;

  Result<Compiled*> transform(const image::ColorConfig& config, const DisplaySettings& s) {
    const std::string key = fmt::format("{}|{}|{}|{}", config.key().hex(), s.display, s.view, s.look);
    if (const auto it = compiled.find(key); it != compiled.end()) return &it->second;
    PILEUS_TRY(const image::GpuTransform gpu, config.gpuTransform(s.display, s.view, s.look));
    Compiled c;
    const std::string text = "#define HAS_OCIO 1\n" + gpu.glsl + "\n";
    PILEUS_TRY(c.program, shaders->program({"view/display.vert.glsl", "view/display.frag.glsl"}, {}, text,
                                           gpu.key.hex()));
    for (const image::LutTexture& lut : gpu.textures) {
      PILEUS_TRY(gl::Texture texture, upload(lut));
      c.luts.emplace_back(lut.sampler, std::move(texture));
    }
    return &compiled.emplace(key, std::move(c)).first->second;
  }
};

Display::Display(gl::ShaderLibrary& shaders) : impl_(std::make_unique<Impl>()) {
  impl_->shaders = &shaders;
  glCreateFramebuffers(1, &impl_->framebuffer);
  glCreateVertexArrays(1, &impl_->vertices);
}

Display::~Display() {
  glDeleteFramebuffers(1, &impl_->framebuffer);
  glDeleteVertexArrays(1, &impl_->vertices);
}

Result<unsigned> Display::draw(const gl::Texture& color, ivec2 size, ivec2 outputSize,
                               const image::ColorConfig& config, const DisplaySettings& settings, int slot) {
  PILEUS_TRY(Compiled * c, impl_->transform(config, settings));
  gl::Texture& target = impl_->targets[slot];
  if (!target || ivec2(target.size()) != outputSize) {
    PILEUS_TRY(target, gl::Texture::create(GL_TEXTURE_2D, GL_RGBA8, ivec3(outputSize, 1), "display"));
    target.filter(GL_LINEAR);
  }
  GLint before[4], bound = 0;
  glGetIntegerv(GL_VIEWPORT, before);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glNamedFramebufferTexture(impl_->framebuffer, GL_COLOR_ATTACHMENT0, target.id(), 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, impl_->framebuffer);
  glViewport(0, 0, outputSize.x, outputSize.y);
  for (const GLenum state : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST}) glDisable(state);
  c->program->use();
  c->program->set("gain", float(std::exp2(settings.exposure)));
  c->program->set("inverseGamma", float(1 / std::max(settings.gamma, 1e-3)));
  c->program->set("raw", int(settings.raw));
  c->program->set("channel", int(settings.channel));
  c->program->set("falseColor", int(settings.falseColor));
  c->program->set("zebra", int(settings.zebra));
  c->program->set("range", settings.range);
  if (settings.falseColor)
    for (int i = 0; i < kExposureBands; ++i)
      c->program->set(fmt::format("bands[{}]", i).c_str(), exposureBands()[std::size_t(i)]);
  c->program->set("pictureSize", size);
  c->program->set("outputSize", outputSize);
  color.filter(outputSize.x > size.x || outputSize.y > size.y ? GL_LINEAR : GL_NEAREST);
  glBindTextureUnit(UNIT_PICTURE, color.id());
  int unit = UNIT_LUT;
  for (const auto& [sampler, texture] : c->luts) {
    c->program->set(sampler.c_str(), unit);
    glBindTextureUnit(GLuint(unit++), texture.id());
  }
  glBindVertexArray(impl_->vertices);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound));
  glViewport(before[0], before[1], before[2], before[3]);
  return target.id();
}

}  // namespace pileus::view
