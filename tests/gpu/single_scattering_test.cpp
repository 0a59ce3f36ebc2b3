// Pictures with exact answers: single scattering in a homogeneous slab, lit along its normal, by map and by march.
#include <cmath>

#include "tests/support/gpu.h"

namespace pileus {
namespace {

constexpr double kSigma = 0.8, kDepth = 2.0, kWidth = 40.0;
constexpr double kAlbedo = 0.7;
constexpr double kIsotropic = 1 / (4 * kPi);

struct Lit {
  volume::InstanceList volumes;
  scene::Light light;
  std::vector<shadow::ShadowedLight> byMap, byMarch;
};

Lit slab() {
  Lit lit;
  lit.volumes = {test::box({0, 0, 0}, {kWidth, kDepth, kWidth}, kSigma)};
  lit.volumes[0].medium.albedo = vec3(float(kAlbedo));
  lit.light = test::sunFrom({0, 1, 0});
  lit.byMap = {{lit.light, test::buildMap(lit.volumes, lit.light, {shadow::Metric::Interval, 4, 4, 128}, {shadow::Basis::Cosine, 8, 128})}};
  auto march = std::make_shared<shadow::ShadowMap>();
  march->kind = shadow::ShadowMap::Kind::RayMarch;
  march->volumes = lit.volumes;
  lit.byMarch = {{lit.light, march}};
  return lit;
}

image::Image look(const Lit& lit, const std::vector<shadow::ShadowedLight>& lights, const dvec3& eye, const dvec3& target, int samples = 1) {
  view::RenderOptions o;
  o.size = ivec2(33, 33);
  o.samples = samples;
  o.camera.eye = eye;
  o.camera.target = target;
  o.camera.up = std::abs(glm::normalize(target - eye).y) > 0.9 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
  o.camera.fov = 0.5;
  return test::render(o, lit.volumes, lights);
}

double centre(const image::Image& image, std::size_t channel) { return double(image.layers[0].pixels[(16 * 33 + 16) * 4 + channel]); }

TEST(SingleScattering, SlabFromTheLitSide) {
  const Lit lit = slab();
  for (const auto& lights : {lit.byMap, lit.byMarch}) {
    const auto image = look(lit, lights, {0, 50, 0}, {0, 0, 0});
    EXPECT_NEAR(centre(image, 0), kAlbedo * kIsotropic * (1 - std::exp(-2 * kSigma * kDepth)) / 2, 2e-3 * kAlbedo * kIsotropic);
    EXPECT_NEAR(centre(image, 3), 1 - std::exp(-kSigma * kDepth), 1e-4);
  }
}

TEST(SingleScattering, SlabAgainstTheLight) {
  const Lit lit = slab();
  for (const auto& lights : {lit.byMap, lit.byMarch})
    EXPECT_NEAR(centre(look(lit, lights, {0, -50, 0}, {0, 0, 0}), 0), kAlbedo * kIsotropic * kSigma * kDepth * std::exp(-kSigma * kDepth), 2e-3 * kAlbedo * kIsotropic);
}

TEST(SingleScattering, SlabAcrossTheLight) {
  const Lit lit = slab();
  for (const double y : {0.3, 1.0, 1.7})
    for (const auto& lights : {lit.byMap, lit.byMarch})
      EXPECT_NEAR(centre(look(lit, lights, {100, kDepth / 2 - y, 0}, {0, kDepth / 2 - y, 0}), 0), kAlbedo * kIsotropic * std::exp(-kSigma * y) * (1 - std::exp(-kSigma * kWidth)),
                  2e-3 * kAlbedo * kIsotropic);
}

TEST(SingleScattering, CameraInsideAndMirroredVolume) {
  Lit lit = slab();
  const auto outside = look(lit, lit.byMap, {0, 0, 0}, {1, 0, 0});
  EXPECT_NEAR(centre(outside, 0), kAlbedo * kIsotropic * std::exp(-kSigma) * (1 - std::exp(-kSigma * kWidth / 2)), 2e-3 * kAlbedo * kIsotropic);
  lit.volumes[0].worldFromLocal = glm::scale(lit.volumes[0].worldFromLocal, dvec3(-1, 1, -1));
  const auto mirrored = look(lit, lit.byMap, {0, 0, 0}, {1, 0, 0});
  EXPECT_NEAR(centre(mirrored, 0), centre(outside, 0), 1e-6);
}

TEST(SingleScattering, JitteredSamplesAgreeWithTheMidpoint) {
  const Lit lit = slab();
  EXPECT_NEAR(centre(look(lit, lit.byMap, {3, 50, 0}, {0, 0, 0}, 64), 0), centre(look(lit, lit.byMap, {3, 50, 0}, {0, 0, 0}, 1), 0), 2e-3 * kAlbedo * kIsotropic);
}

TEST(SingleScattering, OverlapIsTheSumOfExtinctions) {
  const auto light = test::sunFrom({0, 1, 0});
  view::RenderOptions o;
  o.size = ivec2(33, 33);
  o.samples = 1;
  o.camera = {{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 1};
  for (const int copies : {2, 5, 9}) {  // more than are kept in registers, too
    volume::InstanceList many;
    for (int i = 0; i < copies; ++i) many.push_back(test::box({0.001 * i, 0, 0}, {1, 1, 1}, 0.2));
    const volume::InstanceList one{test::box({0, 0, 0}, {1, 1, 1}, 0.2 * copies)};
    const auto shadowOf = [&](const volume::InstanceList& v) { return test::buildMap(v, light, {shadow::Metric::Interval, 4, 4, 128}, {shadow::Basis::Cosine, 8, 128}); };
    const auto a = test::render(o, many, {{light, shadowOf(many)}}), b = test::render(o, one, {{light, shadowOf(one)}});
    EXPECT_NEAR(centre(a, 0), centre(b, 0), 2e-3 * centre(b, 0)) << copies;
    EXPECT_NEAR(centre(a, 3), centre(b, 3), 1e-4) << copies;
  }
}

TEST(SingleScattering, NothingLinkedIsBlackAndTransparent) {
  view::RenderOptions o;
  o.size = ivec2(20, 10);
  o.samples = 2;
  const auto nothing = test::render(o, {}, {});
  for (const float v : nothing.layers[0].pixels) ASSERT_EQ(v, 0.0f);
  const auto unlit = test::render(o, {test::box({0, 0, 0}, {1, 1, 1}, 1)}, {});
  EXPECT_EQ(unlit.layers[0].pixels[(5 * 20 + 10) * 4], 0.0f);
  EXPECT_NEAR(unlit.layers[0].pixels[(5 * 20 + 10) * 4 + 3], 1 - std::exp(-1.0), 2e-2);
}

}  // namespace
}  // namespace pileus
