#include "renderer/view/environment_table.h"

#include <algorithm>

#include "renderer/scene/acescg.h"
#include "renderer/scene/environment_sampler.h"
#include "renderer/shaders/shared/path.h"

namespace pileus::view {
namespace {

/// `size.y` rows {chance of this and all rows above, solid angle of a texel, 0, 0}, then the texels
/// {radiance, chance of this and those before it in its row}, of the map as it is scaled. A black map is
/// chosen from evenly.
std::vector<vec4> environmentTexels(const scene::EnvironmentMap& map, const vec3& scale) {
  const scene::EnvironmentSampler sampler = scene::environmentSampler(map, map.size);
  const auto width = std::size_t(map.size.x), height = std::size_t(map.size.y);
  std::vector<vec4> out;
  out.reserve(height + width * height);
  for (std::size_t y = 0; y < height; ++y)
    out.emplace_back(sampler.table[y + 1], float(scene::texelSolidAngle(map.size, int(y))), 0, 0);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x)
      out.emplace_back(scale * map.at(int(x), int(y)),
                       sampler.table[sampler.columns() + y * (width + 1) + x + 1]);
  return out;
}

}  // namespace

Result<void> EnvironmentTable::make(const scene::Environment& environment) {
  const scene::EnvironmentMap& map = *environment.map;
  size_ = map.size, turn_ = environment.rotation;
  power_ = scene::acescgLuminance(scene::environmentFlux(map) * dvec3(environment.scale));
  double squares = 0;
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      const double l = scene::acescgLuminance(dvec3(environment.scale * map.at(x, y)));
      squares += l * l * scene::texelSolidAngle(size_, y);
    }
  contrast_ = squares > 0 ? std::clamp(1 - power_ * power_ / (4 * kPi * squares), 0.0, 1.0) : 0;
  const std::vector<vec4> texels = environmentTexels(map, environment.scale);
  return texels_.assign(std::span<const vec4>(texels));
}

void EnvironmentTable::bind(gl::Program& program) const {
  texels_.bindTexels(UNIT_ENVIRONMENT, GL_RGBA32F);
  program.set("environmentSize", size_);
  program.set("environmentTurn", float(turn_ / 360));
  program.set("environmentPower", float(power_));
}

Result<void> Backdrop::make(const scene::Environment& environment) {
  const scene::EnvironmentMap& map = *environment.seen;
  PILEUS_TRY(map_, gl::Texture::create(GL_TEXTURE_2D, GL_RGB32F, ivec3(map.size, 1), "backdrop"));
  glTextureSubImage2D(map_.id(), 0, 0, 0, map.size.x, map.size.y, GL_RGB, GL_FLOAT, map.radiance.data());
  map_.filter(GL_LINEAR);
  glTextureParameteri(map_.id(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTextureParameteri(map_.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  turn_ = environment.rotation, scale_ = environment.scale;
  return {};
}

void Backdrop::bind(gl::Program& program) const {
  glBindTextureUnit(UNIT_BACKDROP, map_.id());
  program.set("backdropTurn", float(turn_ / 360));
  program.set("backdropScale", scale_);
}

}  // namespace pileus::view
