// Deep shadow maps: the bound and the compression of smoke1, a budget that is too small, prefiltering.
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using namespace test;
using shadow::ShadowSpec;

TEST(DeepShadowMap, KeepsItsBoundAndCompressesSmoke) {
  PILEUS_NEEDS_DATA();
  const volume::InstanceList volumes{smoke1()};
  scene::Light light;
  light.towards = scene::sunDirection(30, 40);
  const auto at = pointsInside(volumes, 20000, 11);
  const auto raw = build(deep(0, 256), volumes, light);
  std::vector<vec4> positions;
  for (const vec3& p : at) positions.push_back(vec4(p, 0));
  for (const double bound : {0.003, 0.01, 0.03}) {
    const auto measured = cli::measureDeep(test::renderer().gpu(), deep(bound, 256), *raw, positions);
    ASSERT_TRUE(measured) << measured.error().message;
    const double worst = measured->largest;
    const shadow::DeepStatistics& s = measured->statistics;
    std::printf(
        "deep map of smoke1, 256 x 256, bound %.3f: largest error of compression %.4f; %zu of %zu vertices, "
        "%.1fx smaller (%.1fx with headers)\n",
        bound, worst, s.vertices, s.rawVertices, s.compression(),
        double(s.rawVertices + s.texels) / double(s.vertices + s.texels));
    EXPECT_LE(worst, bound + 1e-5);
    EXPECT_EQ(s.overBudget, 0u);
    if (bound == 0.01) {
      EXPECT_GE(s.compression(), 10);
    }
  }
  // A budget that is too small is kept, and said.
  ShadowSpec tight = deep(0.001, 128);
  tight.nodeBudget = 6;
  shadow::ShadowPass pass(tight, light, volumes);
  while (*pass.step(test::renderer().gpu(), 1e12) < 1) {
  }
  const auto s = *pass.deepStatistics();
  EXPECT_GT(s.overBudget, 0u);
  EXPECT_LE(s.vertices, s.texels * 6);
  EXPECT_GT(s.worstBound, 0.001);
  // The budget of a lossless map too: what is written is what was counted, and T stays within the bound that
  // was given out.
  tight.errorBound = 0;
  shadow::ShadowPass lossless(tight, light, volumes);
  while (*lossless.step(test::renderer().gpu(), 1e12) < 1) {
  }
  const auto l = *lossless.deepStatistics();
  EXPECT_LE(l.vertices, l.texels * 6);
  const auto truth = build(deep(0, 128), volumes, light);
  const auto tau = test::lookupTau(*lossless.map(), light, at), want = test::lookupTau(*truth, light, at);
  double worst = 0;
  for (std::size_t i = 0; i < at.size(); ++i)
    worst = std::max(worst, std::abs(T(double(tau[i])) - T(double(want[i]))));
  std::printf("deep map of at most 6 vertices: bounds up to %.4f, largest error %.4f\n", l.worstBound, worst);
  EXPECT_LE(worst, l.worstBound + 1e-5);
}

TEST(DeepShadowMap, PrefilteringAveragesTransmittance) {
  // Half of each texel of column 64 lies behind an opaque slab: with 4 x 4 rays its transmittance is the part
  // that is not.
  const volume::InstanceList volumes{box({-0.0503125, 0, 0}, {0.1, 0.2, 1}, 500)};
  ShadowSpec spec = deep(1e-3);
  spec.filter = 4;
  const auto map = buildIn(spec, volumes, narrow());
  // The slab ends at x = -0.0003125: texel 63 spans -0.0015625..0, four fifths of it and three of four rays'
  // columns are covered.
  const auto tau =
      test::lookupTau(*map, map->light,
                      {vec3(-0.00078125f, -0.4f, 0.00078125f), vec3(-0.00234375f, -0.4f, 0.00078125f),
                       vec3(0.00078125f, -0.4f, 0.00078125f)});
  EXPECT_NEAR(T(double(tau[0])), 0.25, 2e-3);
  EXPECT_NEAR(T(double(tau[1])), 0, 2e-3);
  EXPECT_NEAR(T(double(tau[2])), 1, 2e-3);
}

}  // namespace
}  // namespace pileus
