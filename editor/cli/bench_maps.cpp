#include <cstdio>

#include "editor/cli/bench_tables.h"
#include "editor/cli/map_measures.h"
#include "renderer/truth/shadow_samples.h"

namespace pileus::cli {

Result<void> benchSilhouette(const BenchSetup& setup) {
  std::printf(
      "A slanted box edge over another box, maps of 256 x 256: largest |dT| in the lower box against the "
      "bilinear blend of exact transmittances (bound 0.05).\n\n"
      "| representation | largest dT |\n|---|---|\n");
  shadow::ShadowSpec slabs = intervalSpec(4, 32, 256, true);
  slabs.extinction.basis = shadow::Basis::Slab;
  for (const shadow::ShadowSpec& spec : {intervalSpec(4, 16, 256, true), slabs}) {
    PILEUS_TRY(const double largest, silhouetteError(setup.renderer->gpu(), spec));
    std::printf("| %s | %.3f |\n", shadow::describe(spec).c_str(), largest);
  }
  return {};
}

Result<void> benchDeep(const BenchSetup& setup) {
  PILEUS_TRY(const volume::Instance smoke, benchSmoke(setup));
  const shadow::Gpu gpu = setup.renderer->gpu();
  scene::Light sun;
  sun.towards = scene::sunDirection(30, 40);
  JobControl control;
  PILEUS_TRY(const truth::ShadowSamples samples, truth::sampleShadow(sun, {smoke}, {}, control));
  PILEUS_TRY(const std::shared_ptr<const shadow::ShadowMap> raw,
             shadow::buildShadow(gpu, deepSpec(0, 256), sun, {smoke}));
  std::printf(
      "Extinction 0.5, maps of 256 x 256 against the one that keeps every step. Bounds: the error never "
      "above the map's; at 0.01 at least 10x smaller.\n\n"
      "| bound | largest error of compression | vertices kept | of | smaller by | with headers "
      "|\n|---|---|---|---|---|---|\n");
  for (const double bound : {0.003, 0.01, 0.03}) {
    PILEUS_TRY(const DeepMeasure m, measureDeep(gpu, deepSpec(bound, 256), *raw, samples.positions));
    const shadow::DeepStatistics& s = m.statistics;
    std::printf("| %.3f | %.4f | %zu | %zu | %.1fx | %.1fx |\n", bound, m.largest, s.vertices, s.rawVertices,
                s.compression(), double(s.rawVertices + s.texels) / double(s.vertices + s.texels));
  }
  return {};
}

}  // namespace pileus::cli
