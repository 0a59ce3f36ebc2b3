#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <limits>

#include "editor/cli/bench_tables.h"
#include "editor/cli/curve/scenes.h"
#include "editor/cli/scene_file.h"
#include "renderer/base/profile.h"
#include "renderer/image/metrics.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/view/path_trace.h"
#include "renderer/view/volume_render.h"

namespace pileus::cli {
namespace {

constexpr ivec2 kSize{96, 54};
constexpr int kBlock = 4;  ///< pixels along an edge of what is averaged before it is compared

Result<image::Image> rendered(const shadow::Gpu& gpu, const view::RenderScene& scene) {
  view::VolumeRenderPass pass(scene);
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(gpu, std::numeric_limits<double>::infinity()));
  }
  return view::readBack(*pass.picture());
}

struct Way {
  const char* name;
  view::ScatterOptions options;
};

struct View {
  const char* name;
  double azimuth;  ///< of the sun; the camera looks from 0
};

}  // namespace

Result<void> benchScattering(const BenchSetup& setup) {
  if (setup.data.empty()) return fail(Code::Input, "needs test volumes: set PILEUS_TEST_DATA or --data");
  const shadow::Gpu gpu = setup.renderer->gpu();
  const char* given = std::getenv("PILEUS_JUDGE_SAMPLES");
  const int factor = given ? std::max(std::atoi(given) / 64, 1) : 1;
  PILEUS_TRY(const std::vector<CurveScene> scenes, curveScenes(setup.data));
  PILEUS_TRY(view::RenderScene scene,
             sceneOf(*setup.renderer, scenes[1].graph, kCurveRender, scenes[1].name));
  scene.options.size = kSize, scene.options.samples = 16, scene.options.stepScale = 1;
  scene.options.camera = {{0, 120, 1100}, {0, 70, 0}, {0, 1, 0}, 26};
  using view::Scattering;
  const Way ways[] = {{"64 cells", {Scattering::Grid, 64, 1e-4}},
                      {"32 cells", {Scattering::Grid, 32, 3e-3}},
                      {"octaves", {Scattering::Octaves, 64, 1e-4}},
                      {"single", {}}};
  std::printf(
      "WDAS cloud, albedo 0.99, a sun of elevation 30 degrees, marched shadows, 96 x 54; scaled relMSE of "
      "means "
      "of 4 x 4 pixels and ratio of means against all orders by paths.\n\n| depth | g | view |");
  for (const Way& w : ways) std::printf(" %s: scaled relMSE | ratio | s |", w.name);
  std::printf("\n|---|---|---|");
  for (int i = 0; i < 3 * int(std::size(ways)); ++i) std::printf("---|");
  std::printf("\n");
  for (const double depth : {10.0, 30.0})
    for (const double g : {0.0, 0.6, 0.85})
      for (const View& v : {View{"front", 20}, View{"side", 100}, View{"back", 190}}) {
        for (volume::Instance& i : scene.volumes) {
          i.medium.extinction = 0.00721 * depth;
          i.medium.albedo = vec3(0.99f);
          i.medium.phase = scene::henyeyGreenstein(g);
        }
        scene::Light sun;
        sun.towards = scene::sunDirection(v.azimuth, 30);
        scene.lights = {{sun, shadow::marchedShadow(sun, scene.volumes, {})}};
        view::RenderScene paths = scene;
        paths.options.samples = factor * (g == 0 ? 64 : 256);
        view::PathTracePass judge(paths, {});
        for (double done = 0; done < 1;) {
          PILEUS_TRY(done, judge.step(gpu, 1e12));
        }
        PILEUS_TRY(const auto halves, judge.halves());
        std::printf("| %g | %g | %s |", depth, g, v.name);
        for (const Way& w : ways) {
          scene.options.scatter = w.options;
          const Stopwatch clock;
          PILEUS_TRY(const image::Image picture, rendered(gpu, scene));
          const double seconds = clock.ms() / 1000;
          PILEUS_TRY(const image::ScaledRelMse e,
                     image::scaledRelMse(image::blocksOf(picture, kBlock), image::blocksOf(halves[0], kBlock),
                                         image::blocksOf(halves[1], kBlock)));
          std::printf(" %.4f +- %.4f | %.3f | %.1f |", e.value, e.standardError, e.ratio, seconds);
        }
        std::printf("\n");
        std::fflush(stdout);
      }
  return {};
}

}  // namespace pileus::cli
