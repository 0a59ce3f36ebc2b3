#include "renderer/scene/light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/scene/acescg.h"

namespace pileus::scene {
namespace {

/// CIE xy of the Planckian locus.
dvec2 planckianXy(double k) {
  const double t = 1e3 / k, t2 = t * t, t3 = t2 * t;
  const double x = k < 4000 ? -0.2661239 * t3 - 0.2343589 * t2 + 0.8776956 * t + 0.179910
                            : -3.0258469 * t3 + 2.1070379 * t2 + 0.2226347 * t + 0.240390;
  const double x2 = x * x, x3 = x2 * x;
  const double y = k < 2222   ? -1.1063814 * x3 - 1.34811020 * x2 + 2.18555832 * x - 0.20219683
                   : k < 4000 ? -0.9549476 * x3 - 1.37418593 * x2 + 2.09137015 * x - 0.16748867
                              : 3.0817580 * x3 - 5.87338670 * x2 + 3.75112997 * x - 0.37001483;
  return {x, y};
}

/// Of luminance 1.
dvec3 acescg(dvec2 xy) { return acescgFromXyz({xy.x / xy.y, 1.0, (1 - xy.x - xy.y) / xy.y}); }

}  // namespace

Incidence incidence(const Light& light, const dvec3& point) {
  if (light.kind == LightKind::Sun)
    return {light.towards, std::numeric_limits<double>::infinity(), 1,
            light.air ? sunThrough(*light.air, point.y) : vec3(1.0f)};
  const dvec3 to = light.position - point;
  const double r = glm::length(to);
  Incidence out{r > 0 ? to / r : light.towards, r, 1 / std::max({r * r, light.radius * light.radius, 1e-12}),
                vec3(1.0f)};
  if (light.kind == LightKind::Spot) {
    const double outer = glm::radians(light.cone) / 2, inner = outer * (1 - light.softness);
    const double c = glm::dot(out.towards, light.towards), c0 = std::cos(outer), c1 = std::cos(inner);
    const double t = glm::clamp((c - c0) / std::max(c1 - c0, 1e-6), 0.0, 1.0);
    out.falloff *= t * t * (3 - 2 * t);
  }
  return out;
}

Light environmentLight(std::shared_ptr<const Environment> environment) {
  Light light;
  light.kind = LightKind::Environment;
  light.environment = std::move(environment);
  return light;
}

std::vector<std::shared_ptr<const Environment>> environmentsOf(const std::vector<Light>& lights) {
  std::vector<std::shared_ptr<const Environment>> out;
  for (const Light& l : lights)
    if (l.kind == LightKind::Environment) out.push_back(l.environment);
  return out;
}

std::vector<Light> splitDisc(const Light& sun, int count) {
  if (sun.kind != LightKind::Sun || sun.angle <= 0 || count <= 1) return {sun};
  const dvec3 axis = glm::normalize(sun.towards);
  const dvec3 right =
                  glm::normalize(glm::cross(std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), axis)),
              up = glm::cross(axis, right);
  const double edge = std::sin(glm::radians(sun.angle) / 2), golden = kPi * (3 - std::sqrt(5.0));
  std::vector<Light> out;
  for (int i = 0; i < count; ++i) {
    // Evenly over the disc as seen from below it: equal shares of its area.
    const double r = edge * std::sqrt((i + 0.5) / count), a = golden * i;
    Light part = sun;
    part.disc = axis;
    part.towards = glm::normalize(axis * std::sqrt(1 - r * r) + r * (std::cos(a) * right + std::sin(a) * up));
    part.emitted = sun.emitted / float(count);
    out.push_back(part);
  }
  return out;
}

dvec3 sunDirection(double azimuth, double elevation) {
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

vec3 temperatureColor(double kelvin) {
  const dvec3 white = acescg(planckianXy(6500.0));
  dvec3 c = glm::max(acescg(planckianXy(glm::clamp(kelvin, 1667.0, 25000.0))) / white, dvec3(0.0));
  return vec3(c / acescgLuminance(c));
}

}  // namespace pileus::scene
