// Voxels much wider than high, as weather models have them, under a map and under marched shadows.
#include <fmt/format.h>

#include <any>
#include <cmath>
#include <ctime>

#include "nodes/types/shadow_common.h"
#include "tests/support/exact_scattering.h"
#include "tests/support/noise_grid.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

constexpr ivec3 kVoxels(400, 40, 400);  // y up

volume::GridPtr layer() {
  static const volume::GridPtr grid = [] {
    volume::VoxelSource source;
    source.name = "layer";
    source.activeMin = ivec3(0);
    source.activeMax = kVoxels - 1;
    source.fill = [](ivec3 lo, float* out) {
      for (int z = 0; z < volume::kStoredSize; ++z)
        for (int y = 0; y < volume::kStoredSize; ++y)
          for (int x = 0; x < volume::kStoredSize; ++x) {
            const vec3 p = vec3(lo + ivec3(x, y, z));
            const float cells =
                std::sin(0.06f * p.x + std::sin(0.045f * p.z)) * std::sin(0.055f * p.z + 0.4f) +
                0.4f * std::sin(0.19f * p.x) * std::sin(0.17f * p.z);
            const float height = 1 - std::abs(p.y - 20) / 20;
            *out++ = std::clamp(2 * (cells - 0.15f), 0.0f, 1.0f) * std::clamp(height * 1.5f, 0.0f, 1.0f);
          }
      return volume::Fill::Voxels;
    };
    JobControl control;
    return volume::buildBricks(source, control).value().grid;
  }();
  return grid;
}

/// Of an optical depth of about 8 through the layer.
volume::Instance placed(const dvec3& voxel) {
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = layer();
  i.worldFromLocal = glm::scale(dmat4(1.0), voxel) * glm::translate(dmat4(1.0), -0.5 * dvec3(kVoxels));
  i.medium.extinction = 8.0 / (25 * voxel.y);
  return i;
}

scene::Light slantedSun() { return test::sunFrom({0.5, 0.6, 0.35}, 10); }

struct Error {
  double map = 0, marched = 0, seconds = 0;
};

/// Of T at points in the medium: root of the mean square over the mean. Seconds of CPU that the map takes
/// once its programs are there, whatever else the machine does.
Error errorOf(const volume::Instance& grid, const ShadowSpec& spec) {
  const scene::Light sun = slantedSun();
  Error e;
  auto map = test::build(spec, {grid}, sun);
  const std::clock_t begin = std::clock();
  map = test::build(spec, {grid}, sun);
  e.seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
  const std::vector<vec3> at = test::pointsInside({grid}, 2000, 11);
  const auto tau = test::lookupTau(*map, sun, at);
  ShadowSpec march;
  march.kind = ShadowSpec::Kind::RayMarch;
  const auto tauMarched = test::lookupTau(*test::shadowed(sun, march, {grid}).shadow, sun, at);
  double sum = 0, square = 0, squareMarched = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double right = test::T(shadow::opticalDepthToLight({grid}, sun, dvec3(at[i])));
    const double d = test::T(double(tau[i])) - right, dm = test::T(double(tauMarched[i])) - right;
    sum += right, square += d * d, squareMarched += dm * dm;
  }
  const double n = double(at.size());
  e.map = std::sqrt(square / n) / (sum / n), e.marched = std::sqrt(squareMarched / n) / (sum / n);
  return e;
}

/// What a node with a map of that resolution says of the grid.
std::vector<std::string> warningsFor(const volume::Instance& grid, int resolution) {
  const nodes::EvalSettings settings{};
  const Stopwatch clock;
  std::any state;
  nodes::EvalContext ctx(settings, nullptr, state, Key{}, clock);
  nodes::warnOfThinMedia({slantedSun()}, {grid}, resolution, ctx);
  return ctx.warnings();
}

// A texel that is wider than the layer is thick blurs its shadow, and a map's node says so. It takes no
// longer for that; marched shadows know no texels.
TEST(FlatGrid, MapsSayWhereTheirTexelsAreTooWide) {
  test::renderer();
  test::Rows rows("flat grid");
  constexpr int kTexels = 256;
  const volume::Instance flat = placed({2000, 10, 2000}), even = placed(dvec3(10));
  const ShadowSpec spec = test::improved(4, 8, kTexels);
  const Error a = errorOf(flat, spec), b = errorOf(even, spec);
  std::printf("flat grid, map of %d: error %.3f, %.2f s; isotropic %.3f, %.2f s\n", kTexels, a.map, a.seconds,
              b.map, b.seconds);
  rows.check("map, flat", a.map, 0, 0, 0.25);
  rows.check("map, isotropic", b.map, 0, 0, 0.06);
  rows.check("marched, flat", a.marched, 0, 0, 0.02);
  rows.check("marched, isotropic", b.marched, 0, 0, 0.02);

  const std::vector<std::string> said = warningsFor(flat, kTexels);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said[0].find("resolution: a texel is"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("its shadow is blurred"), std::string::npos) << said[0];
  EXPECT_TRUE(said[0].find("texels tell it apart") != std::string::npos ||
              said[0].find("shadow.ray_march") != std::string::npos)
      << said[0];
  EXPECT_TRUE(warningsFor(even, kTexels).empty());
}

/// Of a map's picture against that of the march: root of the mean square over the mean, where something is
/// seen.
double pictureError(double wide, double high) {
  const volume::Instance grid = placed({wide, high, wide});
  const scene::Light sun = slantedSun();
  view::RenderScene scene;
  scene.volumes = {grid};
  scene.options.size = ivec2(48, 36);
  scene.options.samples = 1;
  scene.options.camera = {{20 * wide, 150 * wide, 200 * wide}, {0, 0, 30 * wide}, {0, 1, 0}, 30};
  ShadowSpec march;
  march.kind = ShadowSpec::Kind::RayMarch;
  scene.lights = {test::shadowed(sun, march, {grid})};
  const image::Image truth = test::render(scene);
  scene.lights = {test::shadowed(sun, test::improved(4, 8, 256), {grid})};
  const image::Image mapped = test::render(scene);
  double square = 0, sum = 0, count = 0;
  for (std::size_t i = 0; i < truth.layers[0].pixels.size(); i += 4) {
    if (truth.layers[0].pixels[i + 3] <= 0.01f) continue;
    const double a = double(mapped.layers[0].pixels[i]), b = double(truth.layers[0].pixels[i]);
    square += (a - b) * (a - b), sum += b, ++count;
  }
  EXPECT_GT(count, 100);
  return std::sqrt(square / count) / (sum / count);
}

TEST(FlatGrid, PicturesOfMapsAndMarchesAgree) {
  test::renderer();
  test::Rows rows("flat grid, picture of a map against that of a march");
  rows.check("flat", pictureError(2000, 10), 0, 0, 0.05);
  rows.check("isotropic", pictureError(10, 10), 0, 0, 0.03);
}

}  // namespace
}  // namespace pileus
