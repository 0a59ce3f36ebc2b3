#include <algorithm>
#include <cstdio>

#include "editor/cli/bench_scenes.h"
#include "editor/cli/bench_tables.h"
#include "renderer/base/profile.h"
#include "renderer/image/metrics.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/shadow_probe.h"
#include "renderer/view/volume_render.h"

namespace pileus::cli {
namespace {

/// A whole picture with the first light's shadow replaced. `ms`: what it takes, on a software device the
/// processor's time.
Result<image::Image> picture(const shadow::Gpu& gpu, view::RenderScene scene,
                             std::shared_ptr<const shadow::ShadowMap> shadow, double* ms = nullptr) {
  scene.lights[0].shadow = std::move(shadow);
  view::VolumeRenderPass pass(scene);
  const Stopwatch clock;
  const CpuStopwatch cpu;
  for (double done = 0; done < 1;) {
    PILEUS_TRY(done, pass.step(gpu, 1e12));
  }
  glFinish();
  if (ms) *ms = gpu.device.software ? cpu.ms() : clock.ms();
  return view::readBack(*pass.picture());
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

Result<void> benchCloudField(const BenchSetup& setup) {
  constexpr int kResolution = 512;
  PILEUS_TRY(const view::RenderScene scene, cloudField(76, 1));
  JobControl control;
  PILEUS_TRY(const truth::ShadowSamples samples,
             truth::sampleShadow(scene.lights[0].light, scene.volumes, {}, control));
  const shadow::Gpu gpu = setup.renderer->gpu();
  std::printf(
      "76 clouds over a square kilometre, 6 groups in 10 overlap; one sun, maps of %d x %d. |dT| at %zu "
      "points in the media on random light rays; the truth is exact "
      "(regular tracking). Rows up to 32 bytes a texel first.\n\n",
      kResolution, kResolution, samples.positions.size());
  std::printf(
      "| representation | bytes a texel | mean | p95 | largest | bias | map ms | ns a lookup "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (const TableRow& row : representationTable(kResolution)) {
    PILEUS_TRY(const auto warm, shadow::buildShadow(gpu, row.spec, scene.lights[0].light, scene.volumes));
    const Stopwatch clock;
    PILEUS_TRY(const auto map, shadow::buildShadow(gpu, row.spec, scene.lights[0].light, scene.volumes));
    const double ms = clock.ms();
    PILEUS_TRY(const truth::ProbeResult r, truth::probe(gpu, *map, samples));
    std::printf("| %s | %.0f | %.4f | %.4f | %.3f | %+.4f | %.0f | %.0f |\n",
                shadow::describe(row.spec).c_str(), map->bytesPerTexel(), r.error.mean, r.error.p95,
                r.error.maximum, r.error.bias, ms, r.nsPerLookup);
    std::fflush(stdout);
  }
  return {};
}

Result<void> benchThreeClouds(const BenchSetup& setup) {
  constexpr int kResolution = 1024;
  PILEUS_TRY(const view::RenderScene scene, threeClouds());
  const scene::Light& light = scene.lights[0].light;
  const shadow::Gpu gpu = setup.renderer->gpu();
  JobControl control;
  PILEUS_TRY(const truth::ShadowSamples samples, truth::sampleShadow(light, scene.volumes, {}, control));
  PILEUS_TRY(const image::Image truth,
             picture(gpu, scene, shadow::marchedShadow(light, scene.volumes, {}, 0.5)));
  std::printf(
      "Three clouds one behind the other under one sun, maps of %d x %d, picture %d x %d with %d samples "
      "against the converged ray march. Bounds: relMSE of the 32-byte "
      "map at most a quarter of Fourier opacity's at equal bytes; a lookup at most 1.5 times as dear. "
      "Lookups alone: with their texels in the caches; in the picture: what it "
      "takes longer with this shadow than without any.\n\n",
      kResolution, kResolution, scene.options.size.x, scene.options.size.y, scene.options.samples);
  std::printf(
      "| representation | bytes a texel | mean dT | p95 | relMSE of the picture | against Fourier opacity 15 "
      "| ns a lookup | against Fourier opacity 15 | lookups in the picture, ms | against Fourier opacity 15 "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  struct Row {
    shadow::ShadowSpec spec;
    std::shared_ptr<const shadow::ShadowMap> map;
    double relMse = 0;
    truth::ShadowError error;
    std::vector<double> ns, nsRatios, ms, msRatios;
  };
  std::vector<Row> rows;
  for (const shadow::ShadowSpec& spec :
       {fourierOpacity(15, kResolution), improved32(kResolution), piecewise32(kResolution),
        improved40(kResolution), fourierOpacity(7, kResolution)}) {
    Row row;
    row.spec = spec;
    PILEUS_TRY(row.map, shadow::buildShadow(gpu, spec, light, scene.volumes));
    PILEUS_TRY(const image::Image image, picture(gpu, scene, row.map));
    PILEUS_TRY(const image::Difference difference, image::compare(image, truth));
    row.relMse = difference.relMse;
    rows.push_back(std::move(row));
  }
  // Lookups in turn, so that whatever else the machine does meets all alike.
  for (int round = 0; round < 15; ++round) {
    double unshadowed = 0, shadowed = 0;
    PILEUS_CHECK(picture(gpu, scene, nullptr, &unshadowed));
    for (Row& row : rows) {
      PILEUS_TRY(const truth::ProbeResult r, truth::probe(gpu, *row.map, samples, 1));
      row.error = r.error;
      row.ns.push_back(r.nsPerLookup);
      row.nsRatios.push_back(r.nsPerLookup / rows.front().ns.back());
      PILEUS_CHECK(picture(gpu, scene, row.map, &shadowed));
      row.ms.push_back(shadowed - unshadowed);
      row.msRatios.push_back(row.ms.back() / rows.front().ms.back());
    }
  }
  for (Row& row : rows)
    std::printf("| %s | %.0f | %.4f | %.4f | %.2e | %.3f | %.0f | %.2f | %.0f | %.2f |\n",
                shadow::describe(row.spec).c_str(), row.map->bytesPerTexel(), row.error.mean, row.error.p95,
                row.relMse, row.relMse / rows.front().relMse, median(row.ns), median(row.nsRatios),
                median(row.ms), median(row.msRatios));
  return {};
}

}  // namespace pileus::cli
