#include "renderer/view/environment_thumbnail.h"

#include <cmath>
#include <vector>

namespace pileus::view {
namespace {

constexpr double kSunTexels = 1.6;  // radius of a disc

/// Adds a sun of that irradiance, spread evenly over the texels of its disc.
void addSun(scene::EnvironmentMap& map, const scene::Light& sun) {
  const dvec2 at = scene::environmentUv(glm::normalize(sun.towards)) * dvec2(map.size);
  std::vector<ivec2> disc;
  double solidAngle = 0;
  for (int y = int(std::floor(at.y - kSunTexels)); y <= int(std::floor(at.y + kSunTexels)); ++y)
    for (int x = int(std::floor(at.x - kSunTexels)); x <= int(std::floor(at.x + kSunTexels)); ++x) {
      if (y < 0 || y >= map.size.y || glm::length(dvec2(x, y) + 0.5 - at) > kSunTexels) continue;
      disc.push_back({(x + map.size.x) % map.size.x, y});
      solidAngle += scene::texelSolidAngle(map.size, y);
    }
  for (const ivec2& p : disc) map.at(p.x, p.y) += sun.emitted / float(solidAngle);
}

}  // namespace

scene::EnvironmentMap environmentPreview(const scene::Environment& environment,
                                         std::span<const scene::Light> suns, ivec2 size) {
  const scene::EnvironmentMap small = scene::refined(scene::reduced(*environment.seen, size), size);
  scene::EnvironmentMap out = small;
  const double shift = environment.rotation / 360 * small.size.x, whole = std::floor(shift);
  const auto part = float(shift - whole);
  const auto column = [&](int x) {
    const auto w = double(small.size.x);
    return int(x + whole - w * std::floor((x + whole) / w));
  };
  for (int x = 0; x < small.size.x; ++x) {
    const int a = column(x), b = column(x + 1);
    for (int y = 0; y < small.size.y; ++y)
      out.at(x, y) = environment.scale * glm::mix(small.at(a, y), small.at(b, y), part);
  }
  for (const scene::Light& sun : suns) addSun(out, sun);
  return out;
}

Result<gl::Texture> environmentThumbnail(const scene::Environment& environment,
                                         std::span<const scene::Light> suns, ivec2 size) {
  const scene::EnvironmentMap map = environmentPreview(environment, suns, size);
  std::vector<vec4> texels;
  texels.reserve(map.radiance.size());
  for (const vec3& radiance : map.radiance) texels.emplace_back(radiance, 1.0f);
  PILEUS_TRY(gl::Texture texture,
             gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, {map.size, 1}, "picture of an environment"));
  glTextureSubImage2D(texture.id(), 0, 0, 0, map.size.x, map.size.y, GL_RGBA, GL_FLOAT, texels.data());
  return texture;
}

}  // namespace pileus::view
