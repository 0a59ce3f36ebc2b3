#include "editor/cli/curve/scenes.h"

#include <nlohmann/json.hpp>

#include "nodes/file/serialize.h"
#include "nodes/shadows/shadow_spec_nodes.h"
#include "renderer/scene/light.h"

namespace pileus::cli {
namespace {

using Json = nlohmann::json;

constexpr const char* kMap = "Extinction Map";

void add(Json& file, const std::string& name, const char* type, Json params = Json::object()) {
  file["nodes"][name] = {{"type", type}, {"params", std::move(params)}};
}

void link(Json& file, const std::string& from, const std::string& to) {
  file["links"].push_back(from + " -> " + to);
}

/// A medium that is drawn and casts shadows.
void addMedium(Json& file, const std::string& volume, double extinction) {
  const std::string name = volume + " Medium";
  add(file, name, "volume.medium", {{"extinction", extinction}, {"albedo", {0.95, 0.95, 0.95}}});
  link(file, volume + ".volume", name + ".volume");
  link(file, name + ".volume", "Pseudometric Map.volumes");
  link(file, name + ".volume", std::string(kCurveRender) + ".volumes");
}

/// All but the media. Without a camera the picture is framed on them, from azimuth 24.
Json lit(double azimuth, double elevation) {
  Json file = {{"pileus", nodes::kFormatVersion}, {"nodes", Json::object()}, {"links", Json::array()}};
  file["settings"]["size"] = {1280, 720};
  add(file, "Sun", "light.sun", {{"azimuth", azimuth}, {"elevation", elevation}});
  add(file, "Pseudometric Map", "shadow.pseudometric");
  add(file, kMap, "shadow.extinction");
  add(file, kCurveRender, "render.volume", {{"samples", 1}, {"scattering", "single"}});
  add(file, "EXR", "output.exr");
  link(file, "Sun.light", "Pseudometric Map.light");
  link(file, "Pseudometric Map.metric", std::string(kMap) + ".metric");
  link(file, std::string(kMap) + ".light", std::string(kCurveRender) + ".lights");
  link(file, std::string(kCurveRender) + ".image", "EXR.image");
  return file;
}

Result<CurveScene> parsed(std::string name, const Json& file) {
  PILEUS_TRY(nodes::Loaded loaded, nodes::parseGraph(file.dump()));
  if (!loaded.faults.empty())
    return fail(Code::Internal, "{}: {}", name, nodes::faultText(loaded.faults.front()));
  return CurveScene{std::move(name), std::move(loaded.graph)};
}

/// A file under a sun from the side.
Result<CurveScene> fileScene(std::string name, const std::filesystem::path& path, const char* grid,
                             double extinction) {
  if (!std::filesystem::exists(path)) return fail(Code::Input, "{}: is not there", path.string());
  Json file = lit(-51, 38);
  add(file, "File", "volume.vdb_file", {{"file", path.string()}, {"grid", grid}});
  addMedium(file, "File", extinction);
  return parsed(std::move(name), file);
}

/// Apart along the way of the sun, each in the shadow of those before it, seen from the side.
Result<CurveScene> cloudScene() {
  Json file = lit(90, 30);
  const dvec3 along = -scene::sunDirection(90, 30);
  const double sizes[] = {170, 210, 240};
  for (int i = 0; i < 3; ++i) {
    const std::string name = "Cloud " + std::to_string(i + 1);
    const dvec3 at = 650.0 * (i - 1) * along + dvec3(0, 20 * i, 0);
    const double size = sizes[i];
    add(file, name, "volume.cloud",
        {{"genus", "classic"},  // so that figures compare with those of before
         {"seed", 40 + i},
         {"center", {at.x, at.y, at.z}},
         {"size", {1.6 * size, size, 1.6 * size}},
         {"coverage", 0.5},
         {"density", 12 / size},
         {"resolution", 96}});
    addMedium(file, name, 1);
  }
  add(file, "Camera", "camera.perspective", {{"eye", {200, 40, 1500}}, {"target", {0, 0, 0}}});
  link(file, "Camera.camera", std::string(kCurveRender) + ".camera");
  return parsed("three clouds", file);
}

}  // namespace

Result<std::vector<CurveScene>> curveScenes(const std::filesystem::path& data) {
  const auto vdb = data / "vdb";
  std::vector<CurveScene> scenes;
  PILEUS_TRY(CurveScene smoke, fileScene("smoke1", vdb / "smoke1.vdb", "density", 0.5));
  PILEUS_TRY(CurveScene cloud, fileScene("WDAS cloud", vdb / "wdas_cloud_sixteenth.vdb", "density", 0.08));
  PILEUS_TRY(CurveScene fire,
             fileScene("EmberGen", vdb / "embergen_fire" / "embergen_fire_a_20.vdb", "flames", 1));
  PILEUS_TRY(CurveScene three, cloudScene());
  for (CurveScene* s : {&smoke, &cloud, &fire, &three}) scenes.push_back(std::move(*s));
  return scenes;
}

Result<shadow::ShadowSpec> defaultShadow(const CurveScene& scene) {
  PILEUS_TRY(const nodes::ShadowNodes nodes, nodes::readShadow(scene.graph, kMap));
  return nodes.spec;
}

Result<nodes::Graph> withShadow(const CurveScene& scene, const shadow::ShadowSpec& spec) {
  PILEUS_TRY(const nodes::ShadowNodes nodes, nodes::readShadow(scene.graph, kMap));
  return nodes::writeShadow(scene.graph, nodes, spec);
}

}  // namespace pileus::cli
