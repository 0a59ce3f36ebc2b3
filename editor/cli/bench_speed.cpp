#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "editor/cli/bench_tables.h"
#include "renderer/base/profile.h"
#include "renderer/shadow/extinction_map.h"
#include "renderer/view/volume_render.h"
#include "renderer/volume/vdb_import.h"

namespace pileus::cli {
namespace {

constexpr double kForever = 1e12;

template <class Pass>
Result<void> finish(Pass& pass, const shadow::Gpu& gpu) {
  for (;;) {
    PILEUS_TRY(const double fraction, pass.step(gpu, kForever));
    if (fraction >= 1) return {};
  }
}

struct Frame {
  double mapMs = 0, viewMs = 0;
  image::Image picture;
};

Result<Frame> mapped(const shadow::Gpu& gpu, int coefficients, const volume::InstanceList& volumes,
                     const scene::Light& sun, const view::RenderOptions& o) {
  Frame frame;
  const Stopwatch clock;
  shadow::PseudometricPass metric({shadow::Metric::Interval, 4, 4, 512, shadow::Storage::Float}, sun, volumes,
                                  shadow::fitLight(sun, volumes, 512));
  PILEUS_CHECK(finish(metric, gpu));
  shadow::ExtinctionPass extinction({shadow::Basis::Cosine, coefficients, 512, shadow::Storage::Float},
                                    metric.map());
  PILEUS_CHECK(finish(extinction, gpu));
  frame.mapMs = clock.ms();
  view::VolumeRenderPass pass(o, volumes, {{sun, extinction.map()}});
  PILEUS_CHECK(finish(pass, gpu));
  frame.viewMs = clock.ms() - frame.mapMs;
  PILEUS_TRY(frame.picture, view::readBack(*pass.picture()));
  return frame;
}

Result<Frame> marched(const shadow::Gpu& gpu, const volume::InstanceList& volumes, const scene::Light& sun,
                      const view::RenderOptions& o) {
  Frame frame;
  auto map = std::make_shared<shadow::ShadowMap>();
  map->kind = shadow::ShadowMap::Kind::RayMarch;
  map->volumes = volumes;
  map->stepScale = 0.5;
  const Stopwatch clock;
  view::VolumeRenderPass pass(o, volumes, {{sun, map}});
  PILEUS_CHECK(finish(pass, gpu));
  frame.viewMs = clock.ms();
  PILEUS_TRY(frame.picture, view::readBack(*pass.picture()));
  return frame;
}

/// Mean |a - b| over the pixels with some medium, relative to the mean of b there.
double relativeDifference(const image::Image& a, const image::Image& b) {
  double difference = 0, mean = 0;
  const auto& pa = a.layers[0].pixels;
  const auto& pb = b.layers[0].pixels;
  for (std::size_t i = 0; i < pa.size(); i += 4) {
    if (pb[i + 3] <= 0.01f) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      difference += std::abs(double(pa[i + c]) - double(pb[i + c]));
      mean += double(pb[i + c]);
    }
  }
  return mean > 0 ? difference / mean : 0;
}

}  // namespace

Result<volume::Instance> benchSmoke(const BenchSetup& setup) {
  if (setup.data.empty()) return fail(Code::Input, "needs smoke1.vdb: set PILEUS_TEST_DATA or --data");
  JobControl control;
  PILEUS_TRY(const volume::ImportedGrid imported,
             volume::importVdb(setup.data / "vdb" / "smoke1.vdb", "", control));
  volume::Instance smoke;
  smoke.shape = volume::Shape::Grid;
  smoke.grid = imported.grid;
  smoke.worldFromLocal = imported.grid->worldFromIndex;
  smoke.medium.extinction = 0.5;
  return smoke;
}

Result<void> benchSpeed(const BenchSetup& setup) {
  PILEUS_TRY(const volume::Instance smoke, benchSmoke(setup));
  const volume::InstanceList volumes{smoke};
  scene::Light sun;
  sun.towards = scene::sunDirection(30, 40);
  sun.emitted = vec3(10.0f);
  view::RenderOptions o;
  o.size = ivec2(640, 360);
  o.samples = 1;
  o.camera = {{10, 42, 46}, {-6, 38, 0}, {0, 1, 0}, 40};  // close enough for the plume to fill the picture
  const shadow::Gpu gpu = setup.renderer->gpu();
  std::printf(
      "Interval metric, K = 4, cosine basis; map 512 x 512; march of half a voxel. Three runs each, the two "
      "in turn.\n\n");
  std::printf(
      "| coefficients | maps ms | view ms | march ms | speed-up (bound 8x) | radiance difference / mean "
      "(bound 3 %%) |\n|---|---|---|---|---|---|\n");
  PILEUS_TRY(Frame b, marched(gpu, volumes, sun, o));
  for (const int coefficients : {8, 12, 16}) {
    PILEUS_TRY(Frame a, mapped(gpu, coefficients, volumes, sun, o));  // once to compile shaders
    std::vector<std::array<double, 4>> runs;
    for (int i = 0; i < 3; ++i) {
      PILEUS_TRY(a, mapped(gpu, coefficients, volumes, sun, o));
      PILEUS_TRY(b, marched(gpu, volumes, sun, o));
      runs.push_back({b.viewMs / (a.mapMs + a.viewMs), a.mapMs, a.viewMs, b.viewMs});
    }
    std::sort(runs.begin(), runs.end());
    const auto& median = runs[1];
    std::printf("| %d | %.0f | %.0f | %.0f | %.1fx | %.2f %% |\n", coefficients, median[1], median[2],
                median[3], median[0], 100 * relativeDifference(a.picture, b.picture));
    std::fflush(stdout);
  }
  return {};
}

}  // namespace pileus::cli
