// Pictures with exact answers: single scattering in a homogeneous slab, lit along its normal, by map and by
// march.
#include <cmath>

#include "tests/support/lit.h"

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
  lit.byMap = {{lit.light, test::buildMap(lit.volumes, lit.light, {shadow::Metric::Interval, 4, 4, 128},
                                          {shadow::Basis::Cosine, 8, 128})}};
  auto march = std::make_shared<shadow::ShadowMap>();
  march->kind = shadow::ShadowMap::Kind::RayMarch;
  march->volumes = lit.volumes;
  lit.byMarch = {{lit.light, march}};
  return lit;
}

image::Image look(const Lit& lit, const std::vector<shadow::ShadowedLight>& lights, const dvec3& eye,
                  const dvec3& target, int samples = 1) {
  view::RenderOptions o;
  o.size = ivec2(33, 33);
  o.samples = samples;
  o.camera.eye = eye;
  o.camera.target = target;
  o.camera.up = std::abs(glm::normalize(target - eye).y) > 0.9 ? dvec3(0, 0, 1) : dvec3(0, 1, 0);
  o.camera.fov = 0.5;
  return test::render(o, lit.volumes, lights);
}

double centre(const image::Image& image, std::size_t channel) {
  return double(image.layers[0].pixels[(16 * 33 + 16) * 4 + channel]);
}

TEST(SingleScattering, SlabFromTheLitSide) {
  const Lit lit = slab();
  for (const auto& lights : {lit.byMap, lit.byMarch}) {
    const auto image = look(lit, lights, {0, 50, 0}, {0, 0, 0});
    EXPECT_NEAR(centre(image, 0), kAlbedo * kIsotropic * (1 - std::exp(-2 * kSigma * kDepth)) / 2,
                2e-3 * kAlbedo * kIsotropic);
    EXPECT_NEAR(centre(image, 3), 1 - std::exp(-kSigma * kDepth), 1e-4);
  }
}

TEST(SingleScattering, SlabAgainstTheLight) {
  const Lit lit = slab();
  for (const auto& lights : {lit.byMap, lit.byMarch})
    EXPECT_NEAR(centre(look(lit, lights, {0, -50, 0}, {0, 0, 0}), 0),
                kAlbedo * kIsotropic * kSigma * kDepth * std::exp(-kSigma * kDepth),
                2e-3 * kAlbedo * kIsotropic);
}

TEST(SingleScattering, SlabAcrossTheLight) {
  const Lit lit = slab();
  for (const double y : {0.3, 1.0, 1.7})
    for (const auto& lights : {lit.byMap, lit.byMarch})
      EXPECT_NEAR(centre(look(lit, lights, {100, kDepth / 2 - y, 0}, {0, kDepth / 2 - y, 0}), 0),
                  kAlbedo * kIsotropic * std::exp(-kSigma * y) * (1 - std::exp(-kSigma * kWidth)),
                  2e-3 * kAlbedo * kIsotropic);
}

TEST(SingleScattering, CameraInsideAndMirroredVolume) {
  Lit lit = slab();
  const auto outside = look(lit, lit.byMap, {0, 0, 0}, {1, 0, 0});
  EXPECT_NEAR(centre(outside, 0),
              kAlbedo * kIsotropic * std::exp(-kSigma) * (1 - std::exp(-kSigma * kWidth / 2)),
              2e-3 * kAlbedo * kIsotropic);
  lit.volumes[0].worldFromLocal = glm::scale(lit.volumes[0].worldFromLocal, dvec3(-1, 1, -1));
  const auto mirrored = look(lit, lit.byMap, {0, 0, 0}, {1, 0, 0});
  EXPECT_NEAR(centre(mirrored, 0), centre(outside, 0), 1e-6);
}

TEST(SingleScattering, JitteredSamplesAgreeWithTheMidpoint) {
  const Lit lit = slab();
  EXPECT_NEAR(centre(look(lit, lit.byMap, {3, 50, 0}, {0, 0, 0}, 64), 0),
              centre(look(lit, lit.byMap, {3, 50, 0}, {0, 0, 0}, 1), 0), 2e-3 * kAlbedo * kIsotropic);
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
    const auto shadowOf = [&](const volume::InstanceList& v) {
      return test::buildMap(v, light, {shadow::Metric::Interval, 4, 4, 128}, {shadow::Basis::Cosine, 8, 128});
    };
    const auto a = test::render(o, many, {{light, shadowOf(many)}}),
               b = test::render(o, one, {{light, shadowOf(one)}});
    EXPECT_NEAR(centre(a, 0), centre(b, 0), 2e-3 * centre(b, 0)) << copies;
    EXPECT_NEAR(centre(a, 3), centre(b, 3), 1e-4) << copies;
  }
}

/// L of one camera ray through a homogeneous box under a point or spot light, by a fine midpoint rule in
/// double precision.
double scatteredTowards(const volume::Instance& medium, const scene::Light& light, const dvec3& eye,
                        const dvec3& d) {
  const dmat4 local = glm::inverse(medium.worldFromLocal);
  const auto inside = [&](const dvec3& o, const dvec3& along) {
    const auto hit =
        intersectBox(dvec3(local * dvec4(o, 1)), dvec3(local * dvec4(along, 0)), dvec3(-0.5), dvec3(0.5));
    return hit ? dvec2(std::max(hit->x, 0.0), std::max(hit->y, 0.0)) : dvec2(0);
  };
  const dvec2 span = inside(eye, d);
  const double sigma = medium.medium.extinction, g = medium.medium.phase.first.g;
  const int n = 200000;
  const double ds = (span.y - span.x) / n;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double t = span.x + (i + 0.5) * ds;
    const dvec3 p = eye + t * d;
    const scene::Incidence e = scene::incidence(light, p);
    const dvec2 way = inside(p, e.towards);
    const double tau = sigma * (std::min(way.y, e.distance) - std::min(way.x, e.distance) + t - span.x);
    const double cosine = glm::dot(e.towards, d), q = 1 + g * g - 2 * g * cosine;
    sum += e.falloff * std::exp(-tau) * (1 - g * g) / (4 * kPi * q * std::sqrt(q));
  }
  return sum * ds * sigma * double(medium.medium.albedo.x) * double(light.emitted.x);
}

TEST(SingleScattering, PointAndSpotLightsAgreeWithTheIntegral) {
  volume::Instance medium = test::box({0, 0, 0}, {4, 3, 5}, 0.6);
  medium.medium.albedo = vec3(float(kAlbedo));
  medium.medium.phase = scene::henyeyGreenstein(0.4);
  const volume::InstanceList volumes{medium};
  const struct {
    const char* what;
    scene::Light light;
  } lights[] = {{"inside", test::pointAt({0.6, 0.4, 0.3}, 30)},
                {"outside", test::pointAt({-3, 2.5, 1}, 100)},
                {"on a face", test::pointAt({2, 0, 0}, 30)},
                {"spot", test::spotAt({0.5, 4, 0.2}, {0, 0, 0}, 40, 0.6)}};
  const dvec3 eyes[] = {{0, 0.2, 12}, {9, 3, -7}, {-0.5, -0.7, 0.2}};  // the last one in the medium
  for (const auto& l : lights)
    for (const auto kind : {shadow::ShadowSpec::Kind::RayMarch, shadow::ShadowSpec::Kind::Extinction}) {
      shadow::ShadowSpec spec;
      spec.kind = kind;
      const auto light = test::shadowed(l.light, shadow::withResolution(spec, 128), volumes);
      double worst = 0;
      for (const dvec3& eye : eyes)
        for (const dvec3& target : {dvec3(0, 0, 0), dvec3(0.9, -0.2, 1), dvec3(-1, 0.6, -1)}) {
          view::RenderOptions o;
          o.size = ivec2(33, 33);
          o.samples = 1;
          o.stepScale = 0.25;
          o.camera = {eye, target, {0, 1, 0}, 0.01};
          const double have = centre(test::render(o, volumes, {light}), 0);
          const double want = scatteredTowards(medium, l.light, eye, glm::normalize(target - eye));
          if (want == 0) {  // past the cone
            EXPECT_EQ(have, 0) << l.what;
            continue;
          }
          worst = std::max(worst, std::abs(have / want - 1));
          EXPECT_NEAR(have / want, 1, kind == shadow::ShadowSpec::Kind::RayMarch ? 3e-4 : 1.5e-3)
              << l.what << ", eye " << eye.x << ", target " << target.x;
        }
      std::printf("light %s, %s: off by at most %.5f of the integral\n", l.what,
                  shadow::describe(spec).c_str(), worst);
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
