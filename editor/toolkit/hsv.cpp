#include "editor/toolkit/hsv.h"

#include <algorithm>
#include <cmath>

namespace pileus::editor {

Hsv hsvOf(const dvec3& color, const Hsv& like) {
  const dvec3 c = glm::max(color, dvec3(0));
  const double high = std::max({c.x, c.y, c.z}), low = std::min({c.x, c.y, c.z}), range = high - low;
  Hsv out{like.hue, like.saturation, high};
  if (high <= 0) return out;
  out.saturation = range / high;
  if (range <= 1e-9 * high) {
    out.saturation = 0;
    return out;
  }
  const double sector = c.x == high   ? (c.y - c.z) / range
                        : c.y == high ? 2 + (c.z - c.x) / range
                                      : 4 + (c.x - c.y) / range;
  out.hue = sector / 6 - std::floor(sector / 6);
  return out;
}

dvec3 rgbOf(const Hsv& hsv) {
  const double h = (hsv.hue - std::floor(hsv.hue)) * 6;
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + h, 6.0);
    return hsv.value * (1 - hsv.saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace pileus::editor
