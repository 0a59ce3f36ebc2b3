// Shadow representations on whole scenes: 76 clouds, and the picture of three clouds one behind the other.
#include "editor/cli/bench_scenes.h"
#include "renderer/image/metrics.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/shadow_probe.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

truth::ShadowSamples samplesOf(const view::RenderScene& scene, int count) {
  JobControl control;
  truth::SampleOptions options;
  options.count = count;
  options.limitMs = 1e9;
  auto samples = truth::sampleShadow(scene.lights[0].light, scene.volumes, options, control);
  EXPECT_TRUE(samples) << (samples ? "" : samples.error().message);
  return samples ? *samples : truth::ShadowSamples{};
}

std::shared_ptr<const shadow::ShadowMap> build(const view::RenderScene& scene,
                                               const shadow::ShadowSpec& spec) {
  auto map = shadow::buildShadow(test::renderer().gpu(), spec, scene.lights[0].light, scene.volumes);
  EXPECT_TRUE(map) << (map ? "" : map.error().message);
  return map ? *map : nullptr;
}

TEST(Scenes, ImprovedMapLeadsOn76Clouds) {
  test::renderer();
  const auto scene = cli::cloudField(76, 1);
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->volumes.size(), 76u);
  const truth::ShadowSamples samples = samplesOf(*scene, 6000);
  double improved = 0;
  int beaten = 0;
  for (const cli::TableRow& row : cli::representationTable(256)) {
    const auto map = build(*scene, row.spec);
    ASSERT_TRUE(map);
    const auto r = truth::probe(test::renderer().gpu(), *map, samples, 0);
    ASSERT_TRUE(r);
    std::printf("76 clouds, %-62s %5.1f bytes a texel, mean |dT| %.4f, p95 %.4f, largest %.3f\n",
                shadow::describe(row.spec).c_str(), map->bytesPerTexel(), r->error.mean, r->error.p95,
                r->error.maximum);
    if (improved == 0)
      improved = r->error.mean;
    else if (!row.ours && row.spec.kind != shadow::ShadowSpec::Kind::Deep &&
             shadow::bytesPerTexel(row.spec) <= 32) {
      EXPECT_GT(r->error.mean, improved) << shadow::describe(row.spec);
      ++beaten;
    }
  }
  EXPECT_GE(beaten, 14);
}

TEST(Scenes, PictureOfThreeClouds) {
  test::renderer();
  const auto scene = cli::threeClouds();
  ASSERT_TRUE(scene);
  const scene::Light& light = scene->lights[0].light;
  const auto picture = [&](const std::shared_ptr<const shadow::ShadowMap>& map) {
    view::RenderScene lit = *scene;
    lit.lights[0].shadow = map;
    return test::render(lit.options, lit.volumes, lit.lights);
  };
  const image::Image truth = picture(shadow::marchedShadow(light, scene->volumes, {}, 0.5));
  const auto relMse = [&](const shadow::ShadowSpec& spec) {
    const auto difference = image::compare(picture(build(*scene, spec)), truth);
    EXPECT_TRUE(difference);
    const double e = difference ? difference->relMse : 1;
    std::printf("three clouds, %-62s relMSE %.2e\n", shadow::describe(spec).c_str(), e);
    return e;
  };
  const double fourier = relMse(cli::fourierOpacity(15, 512));
  EXPECT_EQ(shadow::bytesPerTexel(cli::fourierOpacity(15, 512)), shadow::bytesPerTexel(cli::improved32(512)));
  EXPECT_LE(4 * relMse(cli::improved32(512)), fourier);
  EXPECT_LE(4 * relMse(cli::piecewise32(512)), fourier);
  relMse(cli::improved40(512));
}

}  // namespace
}  // namespace pileus
