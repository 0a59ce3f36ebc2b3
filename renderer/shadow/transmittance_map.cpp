#include "renderer/shadow/transmittance_map.h"

#include "renderer/base/profile.h"
#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/new_map.h"

namespace pileus::shadow {

TransmittancePass::TransmittancePass(const ShadowSpec& spec, const scene::Light& light,
                                     const volume::InstanceList& volumes, const scene::SolidList& solids,
                                     const LightFrustum& frustum)
    : pass_(volumes, frustum, spec.resolution),
      map_(newMap(ShadowMap::Kind::TransmittanceFunction, spec, light, pass_.volumes(), solids, frustum)) {
  map_->basis = spec.basis;
  map_->coefficients = spec.coefficients;
  map_->storage = spec.storage;
}

Result<double> TransmittancePass::step(const Gpu& gpu, double ms) {
  const Stopwatch clock;
  PILEUS_TRY(const double resident, pass_.prepare(gpu, ms));
  if (resident < 1) return 0.3 * resident;
  if (!map_->block) {
    PILEUS_TRY(map_->block,
               gpu.store.allocate(map_->storage == Storage::Float ? Texels::Float : Texels::Half,
                                  pass_.resolution(), (map_->coefficients + 3) / 4, map_->frustum.faces()));
  }
  PILEUS_CHECK(pass_.bindLight(*map_));
  if (!march_) march_.emplace(pass_, 2, map_->coefficients + 2);
  gl::Defines defines = march_->defines();
  defines.insert(defines.end(), {{"BASIS", map_->basis == Basis::Cosine ? BASIS_COSINE : BASIS_FOURIER},
                                 {"BASIS_FLOATS", map_->coefficients},
                                 {"STORE", int(map_->block->texels())}});
  PILEUS_TRY(gl::Program * program, gpu.shaders.program({"shadow/transmittance_map.comp.glsl"}, defines));
  glBindImageTexture(IMAGE_TARGET, map_->block->texture(), 0, GL_TRUE, 0, GL_WRITE_ONLY,
                     map_->block->format());
  do {
    PILEUS_CHECK(march_->run(gpu, pass_, *program));
    pass_.next();
  } while (!pass_.done() && clock.ms() < ms);
  return 0.3 + 0.7 * pass_.fraction();
}

}  // namespace pileus::shadow
