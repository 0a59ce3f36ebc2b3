#include "renderer/view/environment_table.h"

#include <cmath>

#include "renderer/scene/acescg.h"
#include "renderer/shaders/shared/path.h"

namespace pileus::view {

double texelSolidAngle(ivec2 size, int row) {
  const auto height = [&](int y) { return std::cos(kPi * y / size.y); };
  return (height(row) - height(row + 1)) * 2 * kPi / size.x;
}

dvec3 mapDirection(const RadianceMap& map, dvec2 uv) {
  const double azimuth = (0.5 - uv.x) * 2 * kPi + glm::radians(map.turn), polar = kPi * uv.y;
  return {std::sin(polar) * std::sin(azimuth), std::cos(polar), std::sin(polar) * std::cos(azimuth)};
}

std::vector<vec4> environmentTexels(const RadianceMap& map) {
  const auto width = std::size_t(map.size.x), height = std::size_t(map.size.y);
  std::vector<vec4> out(height + width * height);
  std::vector<double> rows(height);
  double sum = 0;
  const bool black = environmentPower(map) <= 0;
  for (std::size_t y = 0; y < height; ++y) {
    double row = 0;
    std::vector<double> until(width);
    for (std::size_t x = 0; x < width; ++x) {
      const vec3& c = map.texels[y * width + x];
      // Every channel counts: what is seen by one alone is chosen, too.
      row += black ? 1.0 : double(c.r + c.g + c.b);
      until[x] = row;
    }
    for (std::size_t x = 0; x < width; ++x)
      out[height + y * width + x] =
          vec4(map.texels[y * width + x], x + 1 == width ? 1.0f : row > 0 ? float(until[x] / row) : 0.0f);
    rows[y] = (sum += row * texelSolidAngle(map.size, int(y)));
  }
  for (std::size_t y = 0; y < height; ++y)
    out[y] = vec4(y + 1 == height ? 1.0f : float(rows[y] / sum), float(texelSolidAngle(map.size, int(y))), 0,
                  0);
  return out;
}

double environmentPower(const RadianceMap& map) {
  double power = 0;
  for (std::size_t i = 0; i < map.texels.size(); ++i)
    power += scene::acescgLuminance(dvec3(map.texels[i])) *
             texelSolidAngle(map.size, int(i / std::size_t(map.size.x)));
  return power;
}

Result<void> EnvironmentTable::make(const RadianceMap& map) {
  size_ = map.size, turn_ = map.turn, power_ = environmentPower(map);
  const std::vector<vec4> texels = environmentTexels(map);
  return texels_.assign(std::span<const vec4>(texels));
}

void EnvironmentTable::bind(gl::Program& program, bool visible) const {
  texels_.bindTexels(UNIT_ENVIRONMENT, GL_RGBA32F);
  program.set("environmentSize", size_);
  program.set("environmentTurn", float(turn_ / 360));
  program.set("environmentPower", float(power_));
  program.set("environmentVisible", int(visible));
}

}  // namespace pileus::view
