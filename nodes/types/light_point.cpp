// light.point: a small light that shines evenly in all directions.
#include "nodes/types/light_common.h"

namespace pileus::nodes {
namespace {

struct In {
  LocalLight local{.position = {0, 2, 0}};
};

void describe(Describe<In, LocalLightOut>& d) {
  d.name("Point Light").category("Light").keywords("lamp bulb omni local flash lightning");
  d.help(
      "A light at one place that shines evenly in all directions; it may stand inside a volume. Irradiance "
      "falls "
      "with the square of the distance.");
  describePosition(d);
  describeIntensity(d,
                    "Radiant intensity before the colour: at distance r the irradiance is intensity / r^2.");
  describeRadius(d);
}

Result<LocalLightOut> evaluate(const In& in, EvalContext&) {
  return LocalLightOut{{{{in.local.made(scene::LightKind::Point), nullptr}}}};
}

}  // namespace

NodeType node_light_point() { return makeNode<In, LocalLightOut>("light.point", 1, describe, evaluate); }

}  // namespace pileus::nodes
