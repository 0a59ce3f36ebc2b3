#include "renderer/transport/ordinates.h"

#include <cmath>

namespace pileus::transport {

Ordinates ordinates() {
  // What x^4 + y^4 + z^4 has over the sphere, 12 pi/5, gives (b^2 - 1/3)^2 = 8/135.
  const double b2 = 1.0 / 3 - std::sqrt(8.0 / 135), b = std::sqrt(b2), c = std::sqrt(1 - 2 * b2),
               a = 1 / std::sqrt(3.0);
  Ordinates out;
  out.direction = {dvec3(a, a, a), dvec3(b, b, c), dvec3(b, c, b), dvec3(c, b, b)};
  out.weight.fill(kPi / 8);
  return out;
}

}  // namespace pileus::transport
