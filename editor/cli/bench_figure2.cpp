#include <cstdio>

#include "editor/cli/bench_tables.h"
#include "editor/cli/ray_families.h"

namespace pileus::cli {
namespace {

using shadow::Basis;
using shadow::Metric;

struct Row {
  const char* name;
  shadow::MetricOptions metric;
  shadow::ExtinctionOptions extinction;
};

shadow::MetricOptions interval(int count, shadow::Weighting weighting, double horizon, bool compact = false) {
  shadow::MetricOptions m{Metric::Interval, count};
  m.weighting = weighting;
  m.horizon = horizon;
  m.compact = compact;
  return m;
}

const Row kRows[] = {
    {"Fourier 7, Euclidean", {Metric::None}, {Basis::Fourier, 7}},
    {"Fourier 12, Euclidean", {Metric::None}, {Basis::Fourier, 12}},
    {"Fourier 15, Euclidean", {Metric::None}, {Basis::Fourier, 15}},
    {"paper budget: Fourier 4 + Fourier 8", {Metric::Fourier, 4, 4}, {Basis::Fourier, 8}},
    {"cosine 4 + cosine 8", {Metric::Cosine, 4, 4}, {Basis::Cosine, 8}},
    {"interval K = 4 + cosine 8", {Metric::Interval, 4}, {Basis::Cosine, 8}},
    {"interval K = 4 + 8 slabs", {Metric::Interval, 4}, {Basis::Slab, 8}},
    {"interval K = 4 + cosine 16", {Metric::Interval, 4}, {Basis::Cosine, 16}},
    {"interval K = 8 + cosine 8", {Metric::Interval, 8}, {Basis::Cosine, 8}},
    {"interval K = 8 + cosine 16", {Metric::Interval, 8}, {Basis::Cosine, 16}},
    {"interval K = 8, weights + cosine 8", interval(8, shadow::Weighting::Root, 0), {Basis::Cosine, 8}},
    {"interval K = 8 + 8 cosines per interval", {Metric::Interval, 8}, {Basis::Piecewise, 8}},
    {"interval K = 4, horizon 5.5 + cosine 8", interval(4, shadow::Weighting::None, 5.5), {Basis::Cosine, 8}},
    {"interval K = 4, horizon 5.5 + cosine 16",
     interval(4, shadow::Weighting::None, 5.5),
     {Basis::Cosine, 16}},
    {"interval K = 4, weights, horizon 5.5 + cosine 8",
     interval(4, shadow::Weighting::Root, 5.5),
     {Basis::Cosine, 8}},
    {"interval K = 4 in 8 bits + cosine 12",
     interval(4, shadow::Weighting::None, 0, true),
     {Basis::Cosine, 12}},
};

constexpr int kRays = 500;
constexpr std::uint64_t kSeed = 2;

/// A line a row, a column a scene; `cell` prints one error.
template <class Cell>
Result<void> table(const BenchSetup& setup, const std::vector<std::pair<std::string, RayFamily>>& columns,
                   const Cell& cell) {
  std::vector<RayScene> scenes;
  std::printf("| representation |");
  for (const auto& [title, family] : columns) {
    PILEUS_TRY(RayScene scene, makeRayScene(family, kRays, kSeed));
    scenes.push_back(std::move(scene));
    std::printf(" %s |", title.c_str());
  }
  std::printf("\n|---|");
  for (std::size_t i = 0; i < scenes.size(); ++i) std::printf("---|");
  std::printf("\n");
  for (const Row& row : kRows) {
    std::printf("| %s |", row.name);
    for (const RayScene& scene : scenes) {
      PILEUS_TRY(const RayError e, measure(setup.renderer->gpu(), scene, row.metric, row.extinction));
      cell(e);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  return {};
}

}  // namespace

Result<void> benchFigure2(const BenchSetup& setup) {
  std::printf(
      "%d seeded rays of %d voxels, |dT| inside the media. The five named families, mean over rays of each "
      "ray's rms:\n\n",
      kRays, kRaySamples);
  std::vector<std::pair<std::string, RayFamily>> named, boxes;
  for (const char* name : {"one", "two", "three", "eight", "thin+thick"})
    named.emplace_back(name, rayFamily(name));
  PILEUS_CHECK(table(setup, named, [](const RayError& e) { std::printf(" %.4f |", e.rms); }));
  std::printf("\nThree boxes on 10 %% of the ray, mean / 95th percentile of each ray's largest:\n\n");
  for (const double tau : {2.0, 3.0, 10.0, 50.0})
    boxes.emplace_back(fmt::format("tau {}", tau), threeBoxes(tau));
  return table(setup, boxes, [](const RayError& e) { std::printf(" %.4f / %.3f |", e.mean, e.p95Max); });
}

}  // namespace pileus::cli
