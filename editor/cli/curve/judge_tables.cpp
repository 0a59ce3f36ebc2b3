#include <ctime>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "editor/cli/bench_tables.h"
#include "editor/cli/curve/scenes.h"
#include "editor/cli/scene_file.h"
#include "nodes/file/serialize.h"
#include "nodes/shadows/shadow_spec_nodes.h"
#include "renderer/image/metrics.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/compare.h"
#include "renderer/truth/truth_picture.h"

namespace pileus::cli {
namespace {

constexpr ivec2 kSize{320, 180};

/// Processor time of all threads, in seconds.
double cpuSeconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

int samplesOf(const char* variable, int usual) {
  const char* given = std::getenv(variable);
  return given ? std::max(std::atoi(given), 2) : usual;
}

Result<void> finish(view::PathTracePass& pass, const shadow::Gpu& gpu) {
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(gpu, 1e12));
  }
  return {};
}

Result<image::Image> rendered(const shadow::Gpu& gpu, const view::RenderScene& scene) {
  view::VolumeRenderPass pass(scene);
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(gpu, 1e12));
  }
  return view::readBack(*pass.picture());
}

/// A cloud under a sun with a map and under the sky, which is traced.
constexpr char kSunAndSky[] = R"({ "pileus": 2, "settings": { "size": [320, 180] },
  "nodes": {
    "Cloud": { "type": "volume.cloud", "params": { "seed": 41, "size": [320, 200, 320], "coverage": 0.6,
               "density": 0.08, "resolution": 96 } },
    "Medium": { "type": "volume.medium",
                "params": { "extinction": 1, "albedo": [0.99, 0.99, 0.99], "anisotropy": 0.6 } },
    "Sky": { "type": "light.sky", "params": { "azimuth": 60, "elevation": 35, "visible": false } },
    "Metric": { "type": "shadow.pseudometric", "params": {} },
    "Map": { "type": "shadow.extinction", "params": {} },
    "Camera": { "type": "camera.perspective", "params": { "eye": [0, 285, 230], "target": [0, 272, 0] } },
    "Render": { "type": "render.volume", "params": { "samples": 1 } },
    "EXR": { "type": "output.exr", "params": {} } },
  "links": [ "Cloud.volume -> Medium.volume", "Medium.volume -> Metric.volumes", "Sky.sun -> Metric.light",
             "Metric.metric -> Map.metric", "Medium.volume -> Render.volumes", "Map.light -> Render.lights",
             "Sky.sky -> Render.lights", "Camera.camera -> Render.camera", "Render.image -> EXR.image" ] })";

/// The lights' maps as the description has them, not as drafts do.
Result<void> buildMaps(const shadow::Gpu& gpu, view::RenderScene& scene, const shadow::ShadowSpec& spec) {
  for (shadow::ShadowedLight& l : scene.lights) {
    if (!l.shadow) continue;
    PILEUS_TRY(l.shadow, shadow::buildShadow(gpu, spec, l.light, l.shadow->volumes, l.shadow->solids));
  }
  return {};
}

struct Efficiency {
  double error = 0;    ///< scaled relMSE of a picture of one sample a pixel: its variance
  double seconds = 0;  ///< of the processor for one sample a pixel
  double mean = 0, meanError = 0;
};

/// By variance, over the pixels of the fast picture that scaled relMSE counts; time without what the first
/// samples take.
Result<Efficiency> efficiencyOf(const shadow::Gpu& gpu, view::RenderScene scene, const view::PathOptions& o,
                                int samples, const image::Image& fast) {
  const auto traced = [&](int n) -> Result<std::pair<std::unique_ptr<view::PathTracePass>, double>> {
    scene.options.samples = n;
    auto pass = std::make_unique<view::PathTracePass>(scene, o);
    const double begin = cpuSeconds();
    PILEUS_CHECK(finish(*pass, gpu));
    return std::pair(std::move(pass), cpuSeconds() - begin);
  };
  PILEUS_CHECK(traced(1));  // compiles
  PILEUS_TRY(auto first, traced(1));
  PILEUS_TRY(auto all, traced(samples));
  Efficiency e;
  e.seconds = (all.second - first.second) / (samples - 1);
  PILEUS_TRY(const image::Image picture, view::readBack(*all.first->picture()));
  PILEUS_TRY(const auto variances, all.first->variance());
  PILEUS_TRY(const image::Image variance, view::readBack(*variances));
  const std::vector<float>&p = picture.layers[0].pixels, &v = variance.layers[0].pixels;
  const std::vector<float>& seen = fast.layers[0].pixels;
  double count = 0, squares = 0;
  for (std::size_t i = 0; i < p.size(); i += 4) {
    if (!(seen[i + 3] > 0.01f)) continue;
    ++count;
    for (std::size_t c = 0; c < 3; ++c) e.mean += double(p[i + c]) / 3;
    squares += double(v[i + 1]);
  }
  if (count == 0) return fail(Code::Internal, "nothing is seen");
  e.mean /= count, e.meanError = std::sqrt(squares) / count;
  for (std::size_t i = 0; i < p.size(); i += 4) {
    if (!(seen[i + 3] > 0.01f)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double b = double(p[i + c]);
      e.error += samples * double(v[i + c]) / (b * b + 0.01 * e.mean * e.mean) / (3 * count);
    }
  }
  return e;
}

}  // namespace

Result<void> benchJudge(const BenchSetup& setup) {
  if (setup.data.empty()) return fail(Code::Input, "needs test volumes: set PILEUS_TEST_DATA or --data");
  const shadow::Gpu gpu = setup.renderer->gpu();
  const int samples = samplesOf("PILEUS_JUDGE_SAMPLES", 1024);
  std::printf(
      "render.volume against single scattering by the judge, 320 x 180, %d samples of the judge; every "
      "shadow "
      "marched in half-voxel steps, or a map as new nodes make it. Bounds: 2e-4 and 0.5 %%, 6e-4 and 1 "
      "%%.\n\n"
      "| scene | marched: scaled relMSE | ratio of means | map: scaled relMSE | ratio of means | judge, CPU "
      "s "
      "|\n|---|---|---|---|---|---|\n",
      samples);
  PILEUS_TRY(const std::vector<CurveScene> scenes, curveScenes(setup.data));
  for (const CurveScene& s : scenes) {
    PILEUS_TRY(view::RenderScene scene, sceneOf(*setup.renderer, s.graph, kCurveRender, s.name));
    PILEUS_TRY(const shadow::ShadowSpec spec, defaultShadow(s));
    PILEUS_CHECK(buildMaps(gpu, scene, spec));
    scene.options.size = kSize, scene.options.samples = 16;
    scene.options.scatter = {};
    view::RenderScene paths = scene, marched = truth::truthOf(scene);
    paths.options.samples = samples;
    marched.options.stepScale = 0.5;
    const double begin = cpuSeconds();
    view::PathOptions once;
    once.bounces = 0;
    view::PathTracePass judge(paths, once);
    PILEUS_CHECK(finish(judge, gpu));
    const double seconds = cpuSeconds() - begin;
    PILEUS_TRY(const auto halves, judge.halves());
    const view::PathStatistics statistics = judge.statistics();
    std::printf("| %s |", s.name.c_str());
    for (const view::RenderScene& fast : {marched, scene}) {
      PILEUS_TRY(const image::Image picture, rendered(gpu, fast));
      PILEUS_TRY(const image::ScaledRelMse r, image::scaledRelMse(picture, halves[0], halves[1]));
      const double error = statistics.standardError / statistics.mean / std::sqrt(double(r.pixels));
      std::printf(" %.2e +- %.1e | %.4f +- %.4f |", r.value, r.standardError, r.ratio, error);
    }
    std::printf(" %.0f |\n", seconds);
    std::fflush(stdout);
  }
  return {};
}

Result<void> benchJudgeSpeed(const BenchSetup& setup) {
  PILEUS_TRY(const nodes::Loaded loaded, nodes::parseGraph(kSunAndSky));
  PILEUS_TRY(view::RenderScene scene, sceneOf(*setup.renderer, loaded.graph, "Render", "sun and sky"));
  PILEUS_TRY(const nodes::ShadowNodes map, nodes::readShadow(loaded.graph, "Map"));
  PILEUS_CHECK(buildMaps(setup.renderer->gpu(), scene, map.spec));
  scene.options.size = kSize;
  const int samples = samplesOf("PILEUS_JUDGE_SAMPLES", 48);
  struct Way {
    const char* what;
    view::PathOptions options;
  };
  view::PathOptions plain;
  plain.skyChoice = 1;
  plain.transmittance = view::ShadowEstimate::Ratio;
  std::vector<Way> ways;
  ways.push_back({"ratio tracking, lights by unshadowed power", plain});
  ways.back().options.unshadowedShare = 1;
  ways.push_back({"ratio tracking, lights by their maps", plain});
  plain.transmittance = view::ShadowEstimate::Series;
  ways.push_back({"series, lights by their maps", plain});
  ways.push_back({"and the sky by its contrast (default)", {}});
  view::RenderScene fast = scene;
  fast.options.samples = 4;
  PILEUS_TRY(const image::Image picture, rendered(setup.renderer->gpu(), fast));
  std::printf(
      "Clouds (albedo .99, g .6) under sun and sky, 320 x 180, %d samples; scaled relMSE of one sample a "
      "pixel "
      "and processor time for it. Goal: a quarter of the first row.\n\n"
      "| orders | way | scaled relMSE x samples | CPU s a sample | their product | of the first | mean |\n"
      "|---|---|---|---|---|---|---|\n",
      samples);
  for (const int bounces : {0, -1}) {
    double first = 0;
    for (Way w : ways) {
      w.options.bounces = bounces;
      PILEUS_TRY(const Efficiency e, efficiencyOf(setup.renderer->gpu(), scene, w.options, samples, picture));
      const double product = e.error * e.seconds;
      if (first == 0) first = product;
      std::printf("| %s | %s | %.2f | %.3f | %.3f | %.2f | %.5f +- %.5f |\n", bounces == 0 ? "one" : "all",
                  w.what, e.error, e.seconds, product, product / first, e.mean, e.meanError);
      std::fflush(stdout);
    }
  }
  return {};
}

}  // namespace pileus::cli
