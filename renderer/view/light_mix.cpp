#include "renderer/view/light_mix.h"

#include <algorithm>

#include "renderer/shaders/shared/bindings.h"

namespace pileus::view {
namespace {

constexpr int kGroup = 16;  // of the shader

/// One dispatch for some of them.
Result<void> add(gl::ShaderLibrary& shaders, const Picture& base, std::span<const MixPart> parts,
                 const Picture& into, bool first) {
  PILEUS_TRY(gl::Program * program,
             shaders.program({"view/light_mix.comp.glsl"}, {{"PARTS", static_cast<int>(parts.size())}}));
  program->use();
  program->set("size", into.size);
  program->set("first", first ? 1 : 0);
  glBindTextureUnit(UNIT_PICTURE, base.color.id());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    program->set(fmt::format("gains[{}]", i).c_str(), parts[i].gain);
    glBindTextureUnit(static_cast<GLuint>(UNIT_MIX + i), parts[i].picture->color.id());
  }
  glBindImageTexture(IMAGE_TARGET, into.color.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  const auto groups = [](int n) { return static_cast<GLuint>((n + kGroup - 1) / kGroup); };
  glDispatchCompute(groups(into.size.x), groups(into.size.y), 1);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                  GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  return {};
}

}  // namespace

Result<std::shared_ptr<Picture>> mixLights(gl::ShaderLibrary& shaders, const Picture& base,
                                           std::span<const MixPart> parts, std::shared_ptr<Picture> into) {
  for (const MixPart& part : parts)
    if (part.picture->size != base.size)
      return fail(Code::Internal, "a layer of {} x {} pixels cannot be added to a picture of {} x {}",
                  part.picture->size.x, part.picture->size.y, base.size.x, base.size.y);
  if (!into || into->size != base.size) {
    into = std::make_shared<Picture>();
    into->size = base.size;
    PILEUS_TRY(into->color, gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(base.size, 1), "light mix"));
  }
  into->samples = base.samples;
  into->fraction = base.fraction;
  into->metadata = base.metadata;
  into->scene = base.scene;
  into->layer = base.layer;
  if (parts.empty()) {  // no light at all: black
    const MixPart none{std::shared_ptr<const Picture>(std::shared_ptr<void>(), &base), vec3(0.0f)};
    PILEUS_CHECK(add(shaders, base, {&none, 1}, *into, true));
    return into;
  }
  for (std::size_t i = 0; i < parts.size(); i += MIX_PARTS)
    PILEUS_CHECK(add(shaders, base, parts.subspan(i, std::min<std::size_t>(MIX_PARTS, parts.size() - i)),
                     *into, i == 0));
  return into;
}

}  // namespace pileus::view
