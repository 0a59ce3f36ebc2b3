#include "nodes/types/environment_common.h"

namespace pileus::nodes {

std::vector<LightWithShadow> standIns(const std::shared_ptr<const scene::Environment>& environment,
                                      const scene::EnvironmentStrata& strata) {
  std::vector<LightWithShadow> out;
  for (const scene::EnvironmentLight& part : scene::draftLights(strata)) {
    scene::Light sun;
    sun.kind = scene::LightKind::Sun;
    sun.towards = scene::turned(part.towards, environment->rotation);
    sun.emitted = part.irradiance * environment->scale;
    sun.environment = environment;
    sun.narrow = part.narrow;
    out.push_back({sun, nullptr});
  }
  return out;
}

}  // namespace pileus::nodes
