#include <cmath>
#include <cstdio>

#include "editor/cli/bench_tables.h"
#include "renderer/base/file.h"
#include "renderer/base/profile.h"
#include "renderer/image/environment_import.h"
#include "renderer/scene/environment_strata.h"
#include "renderer/scene/environment_suns.h"
#include "renderer/shadow/reference.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/judge.h"
#include "renderer/view/volume_render.h"
#include "renderer/volume/vdb_import.h"

namespace fs = std::filesystem;

namespace pileus::cli {
namespace {

constexpr const char* kSkies[] = {"pmndrs_sky_1k.hdr", "polyhaven_spiaggia_di_mondello_1k.hdr",
                                  "pmndrs_studio_1k.hdr", "pmndrs_forest_1k.hdr", "rpr_envLightImage.exr"};

/// As deep as 10 through the middle.
Result<volume::Instance> cloud(const BenchSetup& setup) {
  JobControl control;
  volume::ImportLimits limits;
  limits.executable = executablePath();
  const fs::path file = setup.data / "vdb" / "wdas_cloud_sixteenth.vdb";
  if (setup.data.empty() || !fs::exists(file))
    return fail(Code::Input, "needs vdb/wdas_cloud_sixteenth.vdb and env/ ($PILEUS_TEST_DATA)");
  PILEUS_TRY(const auto imported, volume::importVdb(file, "", control, limits));
  volume::Instance out;
  out.shape = volume::Shape::Grid;
  out.grid = imported.grid;
  out.worldFromLocal = imported.grid->worldFromIndex;
  out.medium.albedo = vec3(0.99f);
  const Box3 box = volume::worldBounds(out);
  const dvec3 across(box.size().x, 0, 0);
  out.medium.extinction = 1;
  out.medium.extinction = 10 / shadow::opticalDepth({out}, box.center() - across, box.center() + across);
  return out;
}

/// Its suns, and the rest as one light; not seen behind the cloud.
Result<std::vector<scene::Light>> lightsOf(const fs::path& file) {
  JobControl control;
  PILEUS_TRY(image::EnvironmentFile read, image::importEnvironment(file, control));
  PILEUS_TRY(const auto config, image::ColorConfig::shipped());
  std::vector<std::string> warnings;
  PILEUS_TRY(scene::EnvironmentMap map, image::environmentFrom(std::move(read), "", *config, warnings));
  std::vector<scene::Light> out = scene::extractSuns(map);
  auto environment = std::make_shared<scene::Environment>(scene::environmentOf(std::move(map)));
  environment->visible = false;
  environment->strata = scene::strataOf(*environment);
  out.push_back(scene::environmentLight(std::move(environment)));
  return out;
}

/// What nodes begin with, at the resolution of a dropped environment.
shadow::ShadowSpec mapsOf() {
  shadow::ShadowSpec spec;
  spec.metric = {.resolution = 128, .weighting = shadow::Weighting::Root, .horizon = shadow::kUsualHorizon};
  spec.extinction.coefficients = 32;
  spec.extinction.resolution = 128;
  spec.extinction.storage = shadow::Storage::Half;
  return spec;
}

/// Mean |a - b| over RGB where there is medium, by the mean of b.
double meanOff(const image::Image& a, const image::Image& b) {
  const std::vector<float>&p = a.layers[0].pixels, &q = b.layer("judge")->pixels;
  double each = 0, sum = 0;
  for (std::size_t i = 0; i < p.size(); i += 4)
    for (std::size_t c = 0; c < 3 && p[i + 3] > 0.01f; ++c)
      each += std::abs(double(p[i + c]) - double(q[i + c])), sum += double(q[i + c]);
  return each / sum;
}

template <class Pass>
Result<void> toTheEnd(const BenchSetup& setup, Pass& pass) {
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(setup.renderer->gpu(), 1e12));
  }
  return {};
}

Result<void> row(const BenchSetup& setup, const volume::Instance& medium, const char* sky, double g,
                 bool marched) {
  PILEUS_TRY(const std::vector<scene::Light> lights, lightsOf(setup.data / "env" / sky));
  view::RenderScene scene;
  scene.options.size = marched ? ivec2(64, 36) : ivec2(96, 54);
  scene.options.samples = 64;  // of 16 the edges of pixels are most of the error
  scene.volumes = {medium};
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(g);
  scene.options.camera = scene::frameBounds(volume::worldBounds(medium), 16.0 / 9);
  for (const scene::Light& light : lights) {
    const bool environment = light.kind == scene::LightKind::Environment;
    shadow::ShadowSpec spec = mapsOf();
    if (marched) spec = {}, spec.kind = shadow::ShadowSpec::Kind::RayMarch;
    if (environment || marched) {
      scene.lights.push_back({light, shadow::describedShadow(spec, light, scene.volumes, {})});
    } else {
      PILEUS_TRY(auto map, shadow::buildShadow(setup.renderer->gpu(), shadow::withResolution(spec, 384),
                                               light, scene.volumes));
      scene.lights.push_back({light, std::move(map)});
    }
  }
  const CpuStopwatch cpu;
  view::VolumeRenderPass pass(scene);
  PILEUS_CHECK(toTheEnd(setup, pass));
  const double seconds = cpu.ms() / 1000;
  PILEUS_TRY(image::Image picture, view::readBack(*pass.picture()));
  truth::JudgePass judge(std::move(picture), scene, {.bounces = 0, .samples = 8192});
  PILEUS_CHECK(toTheEnd(setup, judge));
  const truth::JudgeFigures& f = judge.figures();
  std::printf("| %s | %.1f | %s | %zu | %.1e +- %.1e | %+.2f +- %.2f %% | %.2f %% | %.2f %% | %.1f |\n", sky,
              g, marched ? "marched" : "maps, 128", lights.size() - 1, f.scaled.value, f.scaled.standardError,
              100 * (f.scaled.ratio - 1), 100 * f.ratioError, 100 * meanOff(judge.picture(), judge.picture()),
              100 * f.noise, seconds);
  std::fflush(stdout);
  return {};
}

}  // namespace

Result<void> benchEnvironments(const BenchSetup& setup) {
  PILEUS_TRY(const volume::Instance medium, cloud(setup));
  std::printf(
      "| sky | g | shadows | suns taken out | scaled relMSE | mean | mean abs | judge's noise | CPU s |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  for (const bool marched : {false, true})
    for (const char* sky : kSkies)
      for (const double g : {0.0, 0.6}) PILEUS_CHECK(row(setup, medium, sky, g, marched));
  return {};
}

}  // namespace pileus::cli
