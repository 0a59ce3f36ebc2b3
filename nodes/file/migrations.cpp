#include "nodes/file/migrations.h"

#include <array>

#include <nlohmann/json.hpp>

namespace pileus::nodes {
namespace {

using Json = nlohmann::json;

/// A default that another format replaced. A file does not write what is at its default.
struct OldDefault {
  const char *type, *param;
  Json value;
};

/// Writes them out where nothing stands, in this graph and in the groups within. Also below a link: it is
/// what counts again once the link is muted or gone. What is no graph is left for the reader to complain
/// about.
void writeOut(Json& graph, const std::vector<OldDefault>& defaults) {
  if (!graph.is_object() || !graph.contains("nodes") || !graph["nodes"].is_object()) return;
  for (auto& [name, node] : graph["nodes"].items()) {
    if (!node.is_object() || !node.contains("type") || !node["type"].is_string()) continue;
    const auto& type = node["type"].get_ref<const std::string&>();
    if (type == "group" && node.contains("graph")) writeOut(node["graph"], defaults);
    for (const OldDefault& old : defaults) {
      if (type != old.type) continue;
      if (!node.contains("params")) node["params"] = Json::object();
      if (Json& params = node["params"]; params.is_object() && !params.contains(old.param))
        params[old.param] = old.value;
    }
  }
}

/// A point light became a point, maps became those of the knee of the measured curve (docs/bench.md), and
/// level sets, which were not drawn, fog.
void toFormat2(Json& file) {
  writeOut(file, {{"light.point", "radius", 0.01},
                  {"light.spot", "radius", 0.01},
                  {"shadow.pseudometric", "resolution", 1024},
                  {"shadow.extinction", "coefficients", 8},
                  {"shadow.extinction", "storage", "float"},
                  {"volume.vdb_file", "level_set", "ignore"}});
}

/// Pictures got light that has been scattered more than once.
void toFormat3(Json& file) { writeOut(file, {{"render.volume", "scattering", "single"}}); }

/// Clouds got genera.
void toFormat4(Json& file) { writeOut(file, {{"volume.cloud", "genus", "classic"}}); }

}  // namespace

std::span<const Migration> migrations() {
  static constexpr std::array kSteps = {Migration{1, toFormat2}, Migration{2, toFormat3},
                                        Migration{3, toFormat4}};
  return kSteps;
}

void migrate(Json& file, int version, std::span<const Migration> steps) {
  for (const Migration& step : steps) {
    if (step.from < version) continue;
    step.apply(file);
    file["pileus"] = step.from + 1;
  }
}

}  // namespace pileus::nodes
