#include "renderer/view/map_thumbnail.h"

#include "renderer/shaders/shared/bindings.h"

namespace pileus::view {
namespace {

enum class Mode { Signed = 0, Ends = 1, Deep = 2 };

struct Source {
  Mode mode = Mode::Signed;
  int values = 0;
  ivec4 place{0};
  GLuint texture = 0;
};

Source ofBlock(const shadow::ShadowBlock& block, Mode mode, int values) {
  return {mode, std::min(values, 4 * block.layers()), block.record().place, block.texture()};
}

Result<int> draw(const shadow::Gpu& gpu, const Source& source, int tile, gl::Texture& into) {
  if (source.values == 0) return 0;
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"view/map_thumbnail.comp.glsl"}));
  const ivec3 size(source.values * tile, tile, 1);
  if (!into || into.size() != size) {
    PILEUS_TRY(into, gl::Texture::create(GL_TEXTURE_2D, GL_RGBA8, size, "map thumbnail"));
    into.filter(GL_LINEAR);
  }
  program->use();
  program->set("place", source.place);
  program->set("mode", static_cast<int>(source.mode));
  program->set("tileEdge", tile);
  const bool isSigned = source.mode == Mode::Signed;
  program->set("low", isSigned ? vec3(0.23f, 0.50f, 0.85f) : vec3(0.16f, 0.11f, 0.32f));
  program->set("middle", isSigned ? vec3(0.15f, 0.16f, 0.18f) : vec3(0.20f, 0.52f, 0.56f));
  program->set("high", isSigned ? vec3(0.95f, 0.62f, 0.26f) : vec3(0.97f, 0.90f, 0.56f));
  program->set("nothing", vec3(0.09f, 0.09f, 0.10f));
  gpu.store.bind();
  if (source.texture) glBindTextureUnit(UNIT_PICTURE, source.texture);
  glBindImageTexture(IMAGE_TARGET, into.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
  glDispatchCompute(static_cast<GLuint>(source.values), 1, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  return source.values;
}

}  // namespace

Result<int> drawMapThumbnail(const shadow::Gpu& gpu, const shadow::ShadowMap& map, int tile,
                             gl::Texture& into) {
  Source source;
  if (map.deep)
    source = {Mode::Deep, 2, ivec4(0, 0, map.spec.resolution, static_cast<int>(map.deep->first())), 0};
  else if (map.block)
    source = ofBlock(*map.block, Mode::Signed, map.coefficients);
  return draw(gpu, source, tile, into);
}

Result<int> drawMapThumbnail(const shadow::Gpu& gpu, const shadow::PseudometricMap& map, int tile,
                             gl::Texture& into) {
  if (!map.block) return 0;
  const bool intervals = map.options.metric == shadow::Metric::Interval;
  return draw(gpu,
              ofBlock(*map.block, intervals ? Mode::Ends : Mode::Signed,
                      intervals ? 2 * map.options.intervals : map.options.coefficients),
              tile, into);
}

}  // namespace pileus::view
