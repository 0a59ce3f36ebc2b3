// The points shadows are judged at, and the judgement: against closed forms, the march and maps that are
// wrong on purpose.
#include "renderer/truth/shadow_probe.h"

#include <cmath>

#include "renderer/shadow/reference.h"
#include "renderer/shadow/shadow_pass.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

scene::Light pointAt(const dvec3& position) {
  scene::Light light;
  light.kind = scene::LightKind::Point;
  light.position = position;
  return light;
}

scene::Light spotAt(const dvec3& position, const dvec3& target, double cone) {
  scene::Light light = pointAt(position);
  light.kind = scene::LightKind::Spot;
  light.towards = glm::normalize(position - target);
  light.cone = cone;
  return light;
}

truth::ShadowSamples sample(const scene::Light& light, const volume::InstanceList& volumes,
                            const truth::SampleOptions& options = {}) {
  JobControl control;
  auto samples = truth::sampleShadow(light, volumes, options, control);
  EXPECT_TRUE(samples) << samples.error().message;
  return samples ? std::move(samples).value() : truth::ShadowSamples{};
}

const volume::InstanceList kGap{test::ball({-3, 0, 0}, 1, 0.8), test::box({2, 0.3, 0}, {1, 2, 2}, 1.1)};

TEST(ShadowSamples, LieInTheMediaWithTheExactTransmittance) {
  for (const scene::Light& light : {test::sunFrom({-1, 0.4, 0.2}), pointAt({-6, 1, 0}),
                                    spotAt({-7, 1, 0}, {0, 0, 0}, 40), pointAt({-3, 0.2, 0})}) {
    const truth::ShadowSamples s = sample(light, kGap, {.count = 4000});
    ASSERT_EQ(s.positions.size(), 4000u);
    ASSERT_EQ(s.transmittance.size(), 4000u);
    for (std::size_t i = 0; i < s.positions.size(); ++i) {
      const dvec3 p = s.origin + dvec3(vec3(s.positions[i]));
      ASSERT_TRUE(volume::sigmaAt(kGap[0], p) > 0 || volume::sigmaAt(kGap[1], p) > 0);
      ASSERT_NEAR(s.transmittance[i], std::exp(-shadow::opticalDepthToLight(kGap, light, p)), 1e-5);
      if (light.kind == scene::LightKind::Spot) {
        ASSERT_GT(glm::dot(glm::normalize(light.position - p), light.towards),
                  std::cos(glm::radians(20.0)) - 1e-6);
      }
    }
  }
}

TEST(ShadowSamples, AreUniformUnderASunAndFollowTheSeed) {
  // A ball, seen in parallel rays by their length in it: uniform over its volume, so that E|p|^2 = 3/5.
  const volume::InstanceList ball{test::ball({0, 0, 0}, 1, 2)};
  const truth::ShadowSamples a = sample(test::sunFrom({0.3, 1, 0.1}), ball),
                             b = sample(test::sunFrom({0.3, 1, 0.1}), ball),
                             c = sample(test::sunFrom({0.3, 1, 0.1}), ball, {.seed = 2});
  double square = 0;
  for (const vec4& p : a.positions) square += double(glm::dot(vec3(p), vec3(p))) / double(a.positions.size());
  EXPECT_NEAR(square, 0.6, 0.01);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_NE(a.positions, c.positions);
}

TEST(ShadowSamples, AreUniformOverDistanceUnderAPointLight) {
  // From the centre of a ball every ray is a radius: distances are uniform in [0, 1].
  const truth::ShadowSamples s = sample(pointAt({0, 0, 0}), {test::ball({0, 0, 0}, 1, 2)});
  double mean = 0, second = 0;
  dvec3 centre(0);
  for (std::size_t i = 0; i < s.positions.size(); ++i) {
    const vec3 p = vec3(s.origin) + vec3(s.positions[i]);
    const double r = double(glm::length(p)), n = double(s.positions.size());
    ASSERT_NEAR(s.transmittance[i], std::exp(-2 * r), 1e-5);
    mean += r / n, second += r * r / n;
    centre += dvec3(p) / n;
  }
  EXPECT_NEAR(mean, 0.5, 0.01);
  EXPECT_NEAR(second, 1.0 / 3, 0.01);
  EXPECT_LT(glm::length(centre), 0.02);
}

TEST(ShadowSamples, SayWhereThereIsNothingToSample) {
  JobControl control;
  EXPECT_EQ(truth::sampleShadow(test::sunFrom({0, 1, 0}), {}, {}, control).error().code, Code::Input);
  EXPECT_EQ(truth::sampleShadow(spotAt({0, 5, 0}, {0, 10, 0}, 30), kGap, {}, control).error().code,
            Code::Input)
      << "shines the other way";
  control.cancel();
  EXPECT_EQ(truth::sampleShadow(test::sunFrom({0, 1, 0}), kGap, {}, control).error().code, Code::Cancelled);
}

TEST(ShadowProbe, FindsTheMarchRightAndGoodMapsGood) {
  const shadow::Gpu gpu = test::renderer().gpu();
  for (const scene::Light& light :
       {test::sunFrom({-1, 0.4, 0.2}), pointAt({-6, 1, 0}), spotAt({-7, 1, 0}, {0, 0, 0}, 40)}) {
    const truth::ShadowSamples samples = sample(light, kGap, {.count = 6000});
    const auto march = truth::probe(gpu, *shadow::marchedShadow(light, kGap, {}), samples);
    ASSERT_TRUE(march) << march.error().message;
    EXPECT_LT(march->error.maximum, 1e-3);
    EXPECT_GT(march->nsPerLookup, 0);
    shadow::ShadowSpec spec;
    spec.metric.storage = spec.extinction.storage = shadow::Storage::Half;
    const auto map = shadow::buildShadow(gpu, shadow::withResolution(spec, 256), light, kGap);
    ASSERT_TRUE(map) << map.error().message;
    const auto good = truth::probe(gpu, **map, samples);
    ASSERT_TRUE(good);
    std::printf("light kind %d: interval map mean %.5f p95 %.5f max %.4f, %.0f ns a lookup\n",
                int(light.kind), good->error.mean, good->error.p95, good->error.maximum, good->nsPerLookup);
    EXPECT_LT(good->error.mean, 0.004);
    EXPECT_LT(good->error.p95, 0.015);
    EXPECT_LE(good->error.mean, good->error.maximum);
    EXPECT_LE(good->error.p95, good->error.maximum);
  }
}

TEST(ShadowProbe, AShadowWithoutTheMediaLeaksAllTheirLight) {
  const scene::Light light = test::sunFrom({-1, 0.4, 0.2});
  const truth::ShadowSamples samples = sample(light, kGap, {.count = 4000});
  double expected = 0;
  for (const double t : samples.transmittance) expected += (1 - t) / double(samples.transmittance.size());
  const auto none = truth::probe(test::renderer().gpu(), *shadow::marchedShadow(light, {}, {}), samples, 0);
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_NEAR(none->error.bias, expected, 1e-6);
  EXPECT_NEAR(none->error.mean, expected, 1e-6);
  EXPECT_EQ(none->nsPerLookup, 0);
  // Twice the media: too dark.
  volume::InstanceList twice = kGap;
  for (volume::Instance& i : twice) i.medium.extinction *= 2;
  const auto dark =
      truth::probe(test::renderer().gpu(), *shadow::marchedShadow(light, twice, {}), samples, 0);
  ASSERT_TRUE(dark);
  EXPECT_LT(dark->error.bias, -0.1);
}

TEST(ShadowProbe, PercentilesAreThoseOfTheErrors) {
  std::vector<float> mapped;
  std::vector<double> truth;
  for (int i = 0; i <= 100; ++i)
    mapped.push_back(1), truth.push_back(1 - i * 1e-3);  // errors 0, 0.001 .. 0.1
  const truth::ShadowError e = truth::shadowError(mapped, truth);
  EXPECT_NEAR(e.mean, 0.05, 1e-12);
  EXPECT_NEAR(e.bias, 0.05, 1e-12);
  EXPECT_NEAR(e.p95, 0.095, 1e-12);
  EXPECT_NEAR(e.maximum, 0.1, 1e-12);
}

}  // namespace
}  // namespace pileus
