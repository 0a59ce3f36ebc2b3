#include "renderer/volume/emission.h"

#include <algorithm>

#include "renderer/scene/black_body.h"

namespace pileus::volume {
namespace {

vec4 entryOf(const dvec3& radiance) {
  const vec3 rgb(radiance);
  return {rgb, std::max({rgb.r, rgb.g, rgb.b})};
}

}  // namespace

RemapPtr makeEmission(double lowest, double highest, const std::function<double(double)>& curve,
                      const BlackBody& body) {
  std::vector<vec4> entries;
  for (int i = 0; i < kRemapEntries; ++i) {
    const double part = curve(static_cast<double>(i) / (kRemapEntries - 1));
    const double kelvin = glm::mix(body.coolest, body.hottest, part);
    entries.push_back(part > 0 ? entryOf(body.strength * scene::blackBodyColor(kelvin, body.hottest))
                               : vec4(0));
  }
  return makeRemap(lowest, highest, std::move(entries));
}

RemapPtr emissionBehind(const RemapPtr& remap, const RemapPtr& emission) {
  if (!remap) return emission;
  std::vector<vec4> entries;
  for (const vec4& e : remap->entries)
    entries.push_back(entryOf(dvec3(emission->at(static_cast<double>(e.a)))));
  return makeRemap(remap->lowest, remap->highest, std::move(entries));
}

}  // namespace pileus::volume
