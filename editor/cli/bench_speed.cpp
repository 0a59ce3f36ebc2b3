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

Result<Frame> mapped(const shadow::Gpu& gpu, const volume::InstanceList& volumes, const scene::Light& sun, const view::RenderOptions& o) {
  Frame frame;
  const Stopwatch clock;
  shadow::PseudometricPass metric({shadow::Metric::Interval, 4, 4, 512, shadow::Storage::Float}, sun, volumes, shadow::fitSun(sun, volumes, 512));
  PILEUS_CHECK(finish(metric, gpu));
  shadow::ExtinctionPass extinction({shadow::Basis::Cosine, 8, 512, shadow::Storage::Float}, metric.map());
  PILEUS_CHECK(finish(extinction, gpu));
  frame.mapMs = clock.ms();
  view::VolumeRenderPass pass(o, volumes, {{sun, extinction.map()}});
  PILEUS_CHECK(finish(pass, gpu));
  frame.viewMs = clock.ms() - frame.mapMs;
  PILEUS_TRY(frame.picture, view::readBack(*pass.picture()));
  return frame;
}

Result<Frame> marched(const shadow::Gpu& gpu, const volume::InstanceList& volumes, const scene::Light& sun, const view::RenderOptions& o) {
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

}  // namespace

Result<void> benchSpeed(const BenchSetup& setup) {
  if (setup.data.empty()) return fail(Code::Input, "needs smoke1.vdb: set PILEUS_TEST_DATA or --data");
  JobControl control;
  PILEUS_TRY(const volume::ImportedGrid imported, volume::importVdb(setup.data / "vdb" / "smoke1.vdb", "", control));
  volume::Instance smoke;
  smoke.shape = volume::Shape::Grid;
  smoke.grid = imported.grid;
  smoke.worldFromLocal = imported.grid->worldFromIndex;
  smoke.medium.extinction = 0.5;
  const volume::InstanceList volumes{smoke};
  scene::Light sun;
  sun.towards = scene::sunDirection(30, 40);
  sun.emitted = vec3(10.0f);
  view::RenderOptions o;
  o.size = ivec2(640, 360);
  o.samples = 1;
  o.camera = scene::frameBounds(volume::worldBounds(smoke), 640.0 / 360.0, 40);
  const shadow::Gpu gpu = setup.renderer->gpu();
  // Once each to compile shaders and upload bricks, then the counted frames, the two in turn.
  PILEUS_TRY(Frame a, mapped(gpu, volumes, sun, o));
  PILEUS_TRY(Frame b, marched(gpu, volumes, sun, o));
  constexpr int kRuns = 3;
  std::vector<double> ratios;
  for (int i = 0; i < kRuns; ++i) {
    PILEUS_TRY(a, mapped(gpu, volumes, sun, o));
    PILEUS_TRY(b, marched(gpu, volumes, sun, o));
    ratios.push_back(b.viewMs / (a.mapMs + a.viewMs));
    std::printf("run %d: map %.0f ms + view %.0f ms = %.0f ms; march %.0f ms; ratio %.1f\n", i + 1, a.mapMs, a.viewMs, a.mapMs + a.viewMs, b.viewMs, ratios.back());
  }
  std::sort(ratios.begin(), ratios.end());
  double difference = 0, mean = 0;
  const auto& pa = a.picture.layers[0].pixels;
  const auto& pb = b.picture.layers[0].pixels;
  for (std::size_t i = 0; i < pa.size(); i += 4) {
    if (pb[i + 3] <= 0.01f) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      difference += std::abs(double(pa[i + c]) - double(pb[i + c]));
      mean += double(pb[i + c]);
    }
  }
  std::printf("\n| quantity | measured | bound |\n|---|---|---|\n");
  std::printf("| speed-up of the frame, maps rebuilt (median of %d) | %.1fx | 8x |\n", kRuns, ratios[ratios.size() / 2]);
  std::printf("| mean abs radiance difference / mean in the medium | %.2f %% | 3 %% |\n", 100 * difference / mean);
  return {};
}

}  // namespace pileus::cli
