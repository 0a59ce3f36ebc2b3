// Albedo 1 under the same light from everywhere: whatever the media do, every ray brings that light.
#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

view::RenderScene furnace(const volume::InstanceList& volumes, int samples, ivec2 size = {32, 18}) {
  view::RenderScene scene;
  scene.options.size = size;
  scene.options.samples = samples;
  scene.options.camera = {{0, 0.4, 2.4}, {0, 0, 0}, {0, 1, 0}, 40};
  scene.volumes = volumes;
  for (volume::Instance& i : scene.volumes) i.medium.albedo = vec3(1.0f);
  scene.lights = {test::halves(vec3(1), vec3(1))};
  return scene;
}

/// With directions chosen by the environment too, of which none is worth it.
test::Traced traced(const view::RenderScene& scene) {
  view::PathOptions o;
  o.skyChoice = 1;
  return test::traced(scene, o);
}

void expectOne(const test::Traced& t, const std::string& what) {
  test::expectMean(t, 1, 0.002, what);
  // Pixel by pixel, where a fifth of the samples scattered: all others are exactly 1, and of a few the spread
  // is not known.
  const std::vector<float>&p = t.picture.layers[0].pixels, &v = t.variance.layers[0].pixels;
  int beyond3 = 0, beyond6 = 0, pixels = 0;
  for (std::size_t i = 0; i < p.size(); i += 4) {
    if (v[i] <= 0 || p[i + 3] < 0.2f) continue;
    const double z = (double(p[i]) - 1) / std::sqrt(double(v[i]));
    ++pixels, beyond3 += std::abs(z) > 3, beyond6 += std::abs(z) > 6;
  }
  std::printf("  %-46s %d of %d pixels beyond 3 s.e., %d beyond 6\n", "", beyond3, pixels, beyond6);
  EXPECT_LE(beyond3, std::max(0.005 * pixels, 3.0)) << what;
  EXPECT_EQ(beyond6, 0) << what;
}

TEST(Furnace, Boxes) {
  for (const double tau : {0.1, 1.0, 10.0, 100.0})
    expectOne(traced(furnace({test::box({0, 0, 0}, {1, 1, 1}, tau)}, 256)),
              fmt::format("box, optical depth {}", tau));
}

TEST(Furnace, AThousandDeep) {
  expectOne(traced(furnace({test::box({0, 0, 0}, {1, 1, 1}, 1000)}, 200, {16, 9})),
            "box, optical depth 1000");
}

volume::RemapPtr hollow() {
  std::vector<vec4> entries;  // the thinnest and the densest become nothing
  for (int i = 0; i < volume::kRemapEntries; ++i)
    entries.push_back(vec4(1, 1, 1, float(std::sin(kPi * i / (volume::kRemapEntries - 1)))));
  return volume::makeRemap(0, 1, entries);
}

TEST(Furnace, GridsThatOverlapRemapsAndPhases) {
  const volume::Instance cloud = test::gridInstance(test::gridOf(80, test::blobs), 80, 20);
  volume::Instance turned = cloud, remapped = cloud, ball = test::ball({0.1, 0, 0}, 0.4, 3);
  turned.worldFromLocal = composeTransform({0.1, 0, 0}, {30, 50, 0}, dvec3(1)) * cloud.worldFromLocal;
  turned.medium.phase = scene::droplets(10);
  remapped.remap = hollow();
  remapped.medium.phase = scene::doubleHenyeyGreenstein(0.8, -0.4, 0.3);
  ball.medium.phase = scene::rayleigh();
  expectOne(traced(furnace({cloud}, 256)), "grid");
  expectOne(traced(furnace({remapped}, 256)), "grid, remapped, two lobes");
  expectOne(traced(furnace({cloud, turned, remapped, ball}, 128)), "four that overlap");
  expectOne(traced(furnace({cloud, turned, remapped, ball, test::box({0, 0, 0}, {1, 0.2, 1}, 2),
                            test::box({0, 0, 0}, {0.2, 1, 1}, 2)},
                           64)),
            "six that overlap");
}

// A face of a box under light from a hemisphere sends back its albedo.
TEST(Furnace, Solids) {
  view::RenderScene scene = furnace({}, 64);
  scene.solids = {test::solidBox({0, 0, 0}, {1, 1, 1}, {20, 30, 0}, vec3(1.0f))};
  expectOne(traced(scene), "box");
  scene.volumes = {test::box({0, 0, 0}, {1.6, 1.6, 1.6}, 3)};
  scene.volumes[0].medium.albedo = vec3(1.0f);
  scene.options.samples = 256;
  expectOne(traced(scene), "box in a fog");
}

}  // namespace
}  // namespace pileus
