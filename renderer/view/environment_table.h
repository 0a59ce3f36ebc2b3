#pragma once
// Light from everywhere as the path tracer's shader reads it: radiance by direction, constant in each texel,
// and the chances by which directions are chosen. Twin of lib/environment.glsl. GL thread but for
// environmentTexels().
#include <span>
#include <vector>

#include "renderer/gl/buffer.h"
#include "renderer/gl/shader_library.h"

namespace pileus::view {

/// A lat-long map. Column u and row v, at pixel edges, 0 to 1 from the left and the top, show azimuth
/// (0.5 - u) 360 deg + turn, from +Z towards +X, elevation 90 - 180 v deg.
struct RadianceMap {
  ivec2 size{0};
  std::vector<vec3> texels;  ///< row by row from the top [W/(m^2 sr)], finite, not negative
  double turn = 0;           ///< degrees

  bool empty() const { return texels.empty(); }
};

/// Solid angle [sr] of a texel in a row of so many.
double texelSolidAngle(ivec2 size, int row);
/// Unit vector towards a place in the map, turned.
dvec3 mapDirection(const RadianceMap& map, dvec2 uv);

/// `size.y` rows {chance of this and all rows above, solid angle of a texel, 0, 0}, then the texels {rgb, chance
/// of this and those before it in its row}. A black map is chosen from evenly.
std::vector<vec4> environmentTexels(const RadianceMap& map);
/// Luminance of a map's radiance over all directions [W/m^2].
double environmentPower(const RadianceMap& map);

class EnvironmentTable {
 public:
  Result<void> make(const RadianceMap& map);
  /// To its binding point, with the uniforms of lib/environment.glsl.
  void bind(gl::Program& program, bool visible) const;
  bool empty() const { return size_.x == 0; }

 private:
  gl::Buffer texels_{"environment"};
  ivec2 size_{0};
  double turn_ = 0, power_ = 0;
};

}  // namespace pileus::view
