#include "editor/document/daylight.h"

#include "editor/document/scene_builder.h"

namespace pileus::editor {
namespace {

constexpr double kElevation = 38;  // a clear afternoon

}  // namespace

void addDaylight(SceneBuilder& build, std::span<const std::string> media, double azimuth, const dvec2& at,
                 const std::string& render) {
  const std::string sky = build.add("light.sky", at.x, at.y, "Sky");
  build.set(sky, "azimuth", azimuth);
  build.set(sky, "elevation", kElevation);
  const auto shadow = [&](const char* of, const char* metricName, const char* mapName, double row) {
    const std::string metric = build.add("shadow.pseudometric", at.x + 1, row, metricName),
                      map = build.add("shadow.extinction", at.x + 2, row, mapName);
    build.link(sky, of, metric, "light");
    build.link(metric, "metric", map, "metric");
    for (const std::string& medium : media) build.link(medium, "volume", metric, "volumes");
    build.link(map, "light", render, "lights");
    return metric;
  };
  shadow("sun", "Sun Metric", "Sun Shadow", at.y - 0.4);
  build.set(shadow("sky", "Sky Metric", "Sky Shadow", at.y + 0.6), "resolution", kWideLightTexels);
}

Result<nodes::Graph> newScene() {
  SceneBuilder build{{}};
  const std::string render = build.add("render.volume", 3, 0, "Render");
  addDaylight(build, {}, 45, {0, 0.4}, render);
  const std::string view = build.add("output.view", 4, 0, "View");
  build.link(render, "image", view, "image");
  return build.finish();
}

}  // namespace pileus::editor
