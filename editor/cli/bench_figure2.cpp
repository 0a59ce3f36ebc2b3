#include <cstdio>

#include "editor/cli/bench_tables.h"
#include "editor/cli/ray_families.h"

namespace pileus::cli {

Result<void> benchFigure2(const BenchSetup& setup) {
  using shadow::Basis;
  using shadow::Metric;
  struct Row {
    const char* name;
    shadow::MetricOptions metric;
    shadow::ExtinctionOptions extinction;
  };
  const Row rows[] = {
      {"Fourier 12, Euclidean", {Metric::None, 4, 4}, {Basis::Fourier, 12}},
      {"paper budget: Fourier 4 + Fourier 8", {Metric::Fourier, 4, 4}, {Basis::Fourier, 8}},
      {"cosine 4 + cosine 8", {Metric::Cosine, 4, 4}, {Basis::Cosine, 8}},
      {"interval K = 4 + cosine 8", {Metric::Interval, 4, 4}, {Basis::Cosine, 8}},
      {"interval K = 4 + 8 slabs", {Metric::Interval, 4, 4}, {Basis::Slab, 8}},
      {"interval K = 4 + cosine 16", {Metric::Interval, 4, 4}, {Basis::Cosine, 16}},
  };
  PILEUS_TRY(const RayScene scene, makeRayScene(rayFamily("two"), 200, 2));
  const shadow::Gpu gpu = setup.renderer->gpu();
  std::printf("Family *two*: 200 seeded rays, frustum fitted to the boxes; |dT| inside the media.\n\n");
  std::printf("| representation | mean | p95 of each ray's max | mean rms | against Fourier 12 |\n|---|---|---|---|---|\n");
  double baseline = 0;
  for (const Row& row : rows) {
    PILEUS_TRY(const RayError e, measure(gpu, scene, row.metric, row.extinction));
    if (baseline == 0) baseline = e.mean;
    std::printf("| %s | %.4f | %.3f | %.4f | %.1fx lower |\n", row.name, e.mean, e.p95Max, e.rms, baseline / e.mean);
  }
  return {};
}

}  // namespace pileus::cli
