#include "editor/cli/bench_scenes.h"

#include <random>

#include "renderer/volume/cloud/procedural.h"

namespace pileus::cli {
namespace {

using shadow::Basis;
using shadow::Metric;
using shadow::ShadowSpec;
using shadow::Storage;

constexpr int kBakes = 8, kVoxels = 64;

/// A single cloud of about a metre across about the origin.
Result<volume::GridPtr> bakeOne(int seed) {
  volume::CloudParams p;
  p.genus = volume::Genus::Classic;  // so that figures compare with those of before
  p.seed = seed;
  p.center = dvec3(0);
  p.size = dvec3(1.6, 1, 1.6);
  p.coverage = 0.5;
  p.density = 1;
  p.resolution = kVoxels;
  JobControl control;
  return volume::bakeCloud(p, control);
}

volume::Instance place(const volume::GridPtr& grid, const dvec3& at, double size, double turn, double sigma) {
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = grid;
  i.worldFromLocal = composeTransform(at, dvec3(0, turn, 0), dvec3(size)) * grid->worldFromIndex;
  i.medium.extinction = sigma;
  i.medium.phase = scene::henyeyGreenstein(0.3);
  return i;
}

scene::Light sun(double azimuth, double elevation) {
  scene::Light light;
  light.towards = scene::sunDirection(azimuth, elevation);
  light.emitted = vec3(10.0f);
  return light;
}

ShadowSpec extinction(Metric metric, int count, Basis basis, int coefficients, int resolution) {
  ShadowSpec s;
  s.metric.metric = metric;
  s.metric.intervals = s.metric.coefficients = count;
  s.metric.storage = s.extinction.storage = Storage::Half;
  s.extinction.basis = basis;
  s.extinction.coefficients = coefficients;
  return shadow::withResolution(s, resolution);
}

ShadowSpec transmittance(Basis basis, int coefficients, int resolution) {
  ShadowSpec s = fourierOpacity(coefficients, resolution);
  s.kind = ShadowSpec::Kind::TransmittanceFunction;
  s.basis = basis;
  return s;
}

}  // namespace

Result<view::RenderScene> cloudField(int count, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<volume::GridPtr> grids;
  for (int i = 0; i < kBakes; ++i) {
    PILEUS_TRY(const volume::GridPtr grid, bakeOne(int(seed) * 100 + i));
    grids.push_back(grid);
  }
  view::RenderScene scene;
  dvec3 group(0);
  for (int i = 0; i < count; ++i) {
    if (i % 4 == 0) group = dvec3(1000 * (u(rng) - 0.5), 200 + 250 * u(rng), 1000 * (u(rng) - 0.5));
    const dvec3 at = group + dvec3(220 * (u(rng) - 0.5), 90 * (u(rng) - 0.5), 220 * (u(rng) - 0.5));
    // Optical depths through a cloud from about 1 to 8.
    const double size = 80 + 100 * u(rng);
    scene.volumes.push_back(
        place(grids[std::size_t(i % kBakes)], at, size, 360 * u(rng), (2 + 14 * u(rng)) / size));
  }
  scene.lights = {{sun(40, 28), nullptr}};
  scene.options.size = ivec2(480, 270);
  scene.options.samples = 4;
  scene.options.camera = scene::frameBounds(volume::worldBounds(scene.volumes), 16.0 / 9);
  return scene;
}

Result<view::RenderScene> threeClouds() {
  view::RenderScene scene;
  scene.lights = {{sun(90, 30), nullptr}};
  const dvec3 along = -scene.lights[0].light.towards;
  const double sizes[] = {170, 210, 240};
  for (int i = 0; i < 3; ++i) {
    PILEUS_TRY(const volume::GridPtr grid, bakeOne(40 + i));
    scene.volumes.push_back(
        place(grid, 650.0 * (i - 1) * along + dvec3(0, 20.0 * i, 0), sizes[i], 70.0 * i, 5 / sizes[i]));
  }
  scene.options.size = ivec2(320, 180);
  scene.options.samples = 4;
  const dvec3 middle = volume::worldBounds(scene.volumes).center();
  scene.options.camera = {middle + dvec3(200, 40, 1500), middle, {0, 1, 0}, 40};
  return scene;
}

ShadowSpec fourierOpacity(int coefficients, int resolution, bool range) {
  ShadowSpec s;
  s.kind = ShadowSpec::Kind::FourierOpacity;
  s.coefficients = coefficients;
  s.range = range;
  s.storage = Storage::Half;
  return shadow::withResolution(s, resolution);
}

ShadowSpec improved32(int resolution) {
  ShadowSpec s = extinction(Metric::Interval, 4, Basis::Cosine, 12, resolution);
  s.metric.compact = true;
  return s;
}

ShadowSpec piecewise32(int resolution) {
  ShadowSpec s = improved32(resolution);
  s.extinction.basis = Basis::Piecewise;
  return s;
}

ShadowSpec improved40(int resolution) {
  ShadowSpec s = improved32(resolution);
  s.metric.weighting = shadow::Weighting::Root;
  s.metric.horizon = shadow::kUsualHorizon;
  return s;
}

std::vector<TableRow> representationTable(int resolution) {
  const auto deep = [&](double bound) {
    ShadowSpec s;
    s.kind = ShadowSpec::Kind::Deep;
    s.errorBound = bound;
    return shadow::withResolution(s, resolution);
  };
  std::vector<TableRow> rows{{improved32(resolution), true}};
  for (const int n : {3, 7, 11, 15}) rows.push_back({fourierOpacity(n, resolution)});
  for (const int n : {7, 11}) rows.push_back({fourierOpacity(n, resolution, true)});
  for (const Basis basis : {Basis::Fourier, Basis::Cosine})
    for (const int n : {7, 15}) rows.push_back({transmittance(basis, n, resolution)});
  rows.push_back({extinction(Metric::None, 4, Basis::Cosine, 16, resolution)});
  rows.push_back({extinction(Metric::None, 4, Basis::Slab, 16, resolution)});
  rows.push_back({extinction(Metric::Fourier, 4, Basis::Fourier, 8, resolution)});
  rows.push_back({extinction(Metric::Cosine, 4, Basis::Cosine, 8, resolution)});
  rows.push_back({extinction(Metric::Cosine, 8, Basis::Cosine, 8, resolution)});
  rows.push_back({piecewise32(resolution), true});
  rows.push_back({extinction(Metric::Interval, 4, Basis::Cosine, 8, resolution), true});
  rows.push_back({extinction(Metric::Interval, 4, Basis::Slab, 8, resolution), true});
  rows.push_back({extinction(Metric::Interval, 2, Basis::Cosine, 12, resolution), true});
  rows.push_back({improved40(resolution), true});
  rows.push_back({extinction(Metric::Interval, 8, Basis::Cosine, 8, resolution), true});
  rows.push_back({extinction(Metric::Interval, 4, Basis::Cosine, 16, resolution), true});
  rows.push_back({extinction(Metric::Interval, 4, Basis::Piecewise, 16, resolution), true});
  for (const double bound : {0.03, 0.01}) rows.push_back({deep(bound)});
  return rows;
}

}  // namespace pileus::cli
