#include "renderer/truth/compare.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/profile.h"
#include "renderer/image/metrics.h"
#include "renderer/shaders/shared/compare.h"
#include "renderer/shadow/shadow_pass.h"

namespace pileus::truth {

view::RenderScene truthOf(const view::RenderScene& scene, double stepScale) {
  view::RenderScene out = scene;
  for (shadow::ShadowedLight& l : out.lights)
    if (l.shadow) l.shadow = shadow::marchedShadow(l.light, l.shadow->volumes, l.shadow->solids, stepScale);
  return out;
}

ComparePass::ComparePass(const view::RenderScene& scene, TruthKind kind, CompareOrder order)
    : scene_(scene),
      kind_(kind),
      order_(order),
      mapped_(scene),
      truth_(truthPicture(scene, kind)),
      error_(scene, truthOf(scene)) {}

Result<double> ComparePass::step(const shadow::Gpu& gpu, double ms) {
  const Stopwatch clock;
  do {
    // The first sample of the pictures, then the shadows' error (it costs about as much), then the other
    // samples.
    if (pictureWhole() && !shadowWhole()) {
      PILEUS_CHECK(error_.step(gpu, std::max(ms - clock.ms(), 0.0)));
      figures_.shadow = {error_.mean(), error_.quantile(0.95), error_.maximum()};
      figures_.leak = error_.leak(), figures_.dark = error_.dark(), figures_.samples = error_.samples();
    } else if (pictureFraction_ < 1) {
      // One region each, whoever is behind first, so that both have about the same samples everywhere and end
      // each of them together; who is still uploading, or takes several dispatches for a region, is waited
      // for.
      const auto behind = [&] {
        if (order_ == CompareOrder::TruthFirst && !truthWhole()) return false;
        return (mapped() ? mapped()->fraction : 0) <= (truth() ? truth()->fraction : 0);
      };
      if (behind()) {
        PILEUS_TRY(mappedFraction_, mapped_.step(gpu, 0));
      }
      if (!mapped() || !behind()) {
        PILEUS_TRY(truthFraction_, truth_.step(gpu, 0));
      }
      pictureFraction_ = std::min(mappedFraction_, truthFraction_);
      const bool even = kind_ == TruthKind::Judge
                            ? pictureWhole()
                            : mapped() && truth() && mapped()->fraction == truth()->fraction;
      if (even && truth()->samples != figures_.pictureSamples) PILEUS_CHECK(measureRadiance());
    }
    const double errorShare = 1.0 / (1.0 + scene_.options.samples);
    fraction_ = (1 - errorShare) * pictureFraction_ + errorShare * error_.fraction();
    if (pictureFraction_ >= 1 && shadowWhole()) return fraction_ = 1.0;
  } while (clock.ms() < ms);
  return fraction_;
}

Result<void> ComparePass::measureRadiance() {
  PILEUS_TRY(const image::Image a, view::readBack(*mapped()));
  PILEUS_TRY(const image::Image b, view::readBack(*truth()));
  PILEUS_TRY(const image::Difference difference, image::compare(a, b));
  const std::vector<float>& p = a.layers[0].pixels;
  const std::vector<float>& q = b.layers[0].pixels;
  std::vector<double> errors;
  for (std::size_t i = 0; i + 3 < q.size(); i += 4) {
    if (!(q[i + 3] > 0.01f)) continue;
    double e = 0;
    for (std::size_t c = 0; c < 3; ++c) e += std::abs(static_cast<double>(p[i + c] - q[i + c])) / 3;
    errors.push_back(e);
  }
  ErrorFigures figures;
  if (!errors.empty()) {
    for (const double e : errors) figures.mean += e / static_cast<double>(errors.size());
    const auto at =
        errors.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(errors.size() - 1));
    std::nth_element(errors.begin(), at, errors.end());
    figures.p95 = *at;
    figures.maximum = *std::max_element(at, errors.end());
  }
  figures_.radiance = figures;
  figures_.relMse = difference.relMse;
  if (kind_ == TruthKind::Judge && truth_.paths()) {
    PILEUS_TRY(const std::optional<double> scaled, judged(a, *truth_.paths()));
    figures_.relMse = scaled.value_or(0);
  }
  figures_.pictureSamples = truth()->samples;
  return {};
}

vec3 falseColour(double e) {
  // Near black in the middle; then the hue, then brighter: the sign is read from the hue, the size from the
  // lightness.
  constexpr vec3 kMiddle(0.085f, 0.09f, 0.1f);
  constexpr vec3 kDark[3] = {{0.10f, 0.28f, 0.62f}, {0.25f, 0.58f, 0.98f}, {0.66f, 0.88f, 1.0f}};
  constexpr vec3 kLeak[3] = {{0.60f, 0.14f, 0.12f}, {0.97f, 0.42f, 0.20f}, {1.0f, 0.84f, 0.46f}};
  const vec3* side = e < 0 ? kDark : kLeak;
  const float t = 3.0f * static_cast<float>(std::clamp(std::abs(e), 0.0, 1.0));
  if (t < 1) return glm::mix(kMiddle, side[0], t);
  return t < 2 ? glm::mix(side[0], side[1], t - 1) : glm::mix(side[1], side[2], t - 2);
}

Result<unsigned> CompareDisplay::draw(gl::ShaderLibrary& shaders, const ComparePass& pass, Show show,
                                      double scale, int slot) {
  const bool radiance = show == Show::RadianceError;
  if (radiance ? !pass.truth() || !pass.mapped() : !pass.shadowError().errors()) return 0u;
  constexpr int kColours = 511;  // odd: the middle is a texel of its own
  if (!colours_) {
    std::vector<vec3> colours;
    for (int i = 0; i < kColours; ++i) colours.push_back(falseColour(2.0 * i / (kColours - 1) - 1));
    PILEUS_TRY(colours_,
               gl::Texture::create(GL_TEXTURE_1D, GL_RGB32F, ivec3(kColours, 1, 1), "false colours"));
    glTextureSubImage1D(colours_.id(), 0, 0, kColours, GL_RGB, GL_FLOAT, colours.data());
    colours_.filter(GL_LINEAR);
    colours_.wrap(GL_CLAMP_TO_EDGE);
  }
  const ivec2 size = pass.scene().options.size;
  gl::Texture& target = targets_.at(static_cast<std::size_t>(slot));
  if (!target || ivec2(target.size()) != size) {
    PILEUS_TRY(target, gl::Texture::create(GL_TEXTURE_2D, GL_RGBA8, ivec3(size, 1), "comparison"));
    target.filter(GL_LINEAR);
    target.wrap(GL_CLAMP_TO_EDGE);
  }
  PILEUS_TRY(gl::Program * program, shaders.program({"truth/compare.comp.glsl"}));
  program->use();
  program->set("size", size);
  program->set("show", static_cast<int>(show));
  program->set("scale", static_cast<float>(std::max(scale, 1e-9)));
  glBindTextureUnit(UNIT_COMPARED, radiance ? pass.mapped()->color.id() : pass.shadowError().errors().id());
  glBindTextureUnit(UNIT_TRUTH,
                    radiance ? pass.truth()->color.id() : pass.shadowError().transmittances().id());
  glBindTextureUnit(UNIT_COLOURS, colours_.id());
  glBindImageTexture(IMAGE_ERROR, target.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
  const ivec2 groups = (size + 7) / 8;
  glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  return target.id();
}

}  // namespace pileus::truth
