// Remapped densities on the GPU: against the CPU's, against closed forms, and what is skipped as empty.
#include <algorithm>
#include <random>

#include "renderer/shadow/reference.h"
#include "tests/support/gpu.h"
#include "tests/support/grid_samples.h"
#include "tests/support/noise_grid.h"

namespace pileus {
namespace {

using test::table;

constexpr int kEdge = 80;

volume::Instance blobs(double extinction) {
  static const volume::GridPtr grid = test::gridOf(kEdge, test::blobs);
  return test::gridInstance(grid, kEdge, extinction);
}

constexpr int kSize = 64;  // pixels no larger than voxels: the finest level is seen

image::Image look(const volume::InstanceList& volumes,
                  const std::vector<shadow::ShadowedLight>& lights = {}) {
  view::RenderOptions o;
  o.size = ivec2(kSize);
  o.samples = 1;
  o.stepScale = 0.25;
  o.camera.eye = {0.3, 0.2, 6};
  o.camera.target = {0, 0, 0};
  o.camera.fov = 12;
  return test::render(o, volumes, lights);
}

std::vector<shadow::ShadowedLight> marched(const volume::InstanceList& volumes) {
  auto map = std::make_shared<shadow::ShadowMap>();
  map->kind = shadow::ShadowMap::Kind::RayMarch;
  map->volumes = volumes;
  return {{test::sunFrom({0.3, 1, 0.4}, 5), map}};
}

TEST(Remap, SamplesAreThoseOfTheCpu) {
  const auto curves = {table(0.1, 0.9, [](double u) { return 2 * u * u; }),
                       table(0, 1, [](double u) { return 1 - u; }),
                       table(0, 1, [](double u) { return u < 0.4 ? 0 : u; })};
  std::mt19937_64 rng(7);
  std::uniform_real_distribution<float> u(0, kEdge);
  std::vector<vec4> at;
  for (int i = 0; i < 20000; ++i) at.push_back(vec4(u(rng), u(rng), u(rng), 0));
  const volume::Instance plain = blobs(1);
  const auto densities = test::sampledOnGpu(plain, at);
  for (const volume::RemapPtr& remap : curves) {
    volume::Instance i = plain;
    i.remap = remap;
    const auto values = test::sampledOnGpu(i, at);
    double worst = 0;
    // Of the density the GPU itself sees: an edge of the table would magnify what its filter rounds.
    for (std::size_t k = 0; k < at.size(); ++k)
      worst = std::max(worst, std::abs(double(values[k]) - remap->density(double(densities[k]))));
    EXPECT_LT(worst, 2e-4);
    const double perMetre =
        volume::sigmaAt(i, dvec3(i.worldFromLocal * dvec4(dvec3(at[0]) + dvec3(i.grid->origin), 1)));
    EXPECT_NEAR(perMetre, double(values[0]), 0.02);
  }
}

TEST(Remap, AnIdentityTableGivesTheSamePicture) {
  const volume::Instance plain = blobs(30);
  volume::Instance same = plain;
  same.remap =
      table(0, double(plain.grid->maximum), [&](double u) { return u * double(plain.grid->maximum); });
  EXPECT_LT(test::largestDifference(look({plain}, marched({plain})), look({same}, marched({same}))), 2e-5);
}

TEST(Remap, PicturesShowWhatTheReferenceSays) {
  const std::pair<const char*, volume::RemapPtr> cases[] = {
      {"threshold", table(0, 1, [](double u) { return u < 0.5 ? 0 : 1; })},
      {"inverted", table(0, 1, [](double u) { return 0.3 * (1 - u); })},
      {"raised", table(0, 1, [](double u) { return std::sqrt(u); })}};
  for (const auto& [name, remap] : cases) {
    volume::Instance i = blobs(3);
    i.remap = remap;
    const auto picture = look({i});
    double worst = 0, most = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const dvec3 eye{0.3, 0.2, 6}, forward = glm::normalize(-eye),
                                      right = glm::normalize(glm::cross(forward, dvec3(0, 1, 0)));
        const double tangent = std::tan(glm::radians(6.0));
        const dvec2 ndc = (dvec2(x, y) + 0.5) / double(kSize) * 2.0 - 1.0;
        const dvec3 d = forward + tangent * (ndc.x * right - ndc.y * glm::cross(right, forward));
        const double want = 1 - std::exp(-shadow::opticalDepth({i}, eye, eye + 2.0 * d * 6.0));
        worst = std::max(
            worst, std::abs(want - double(picture.layers[0].pixels[std::size_t(y * kSize + x) * 4 + 3])));
        most = std::max(most, want);
      }
    EXPECT_LT(worst, 0.02) << name;
    EXPECT_GT(most, 0.3) << name;
  }
}

TEST(Remap, ShadowsCastWhatTheReferenceSays) {
  for (const double floor : {0.0, 0.2}) {
    volume::Instance i = blobs(4);
    i.remap = table(0, 1, [floor](double u) { return std::max(floor, u < 0.5 ? 0 : u); });
    const scene::Light light = test::sunFrom({0.2, 1, 0.1});
    const auto map =
        test::buildMap({i}, light, {shadow::Metric::Interval, 4, 4, 128}, {shadow::Basis::Cosine, 16, 128});
    std::vector<vec3> below;
    for (int k = 0; k < 100; ++k)
      below.push_back(vec3(-0.35f + 0.07f * float(k % 10), -0.6f, -0.35f + 0.07f * float(k / 10)));
    const auto tau = test::lookupTau(*map, light, below);
    double worst = 0;
    for (std::size_t k = 0; k < below.size(); ++k)
      worst = std::max(worst, std::abs(std::exp(-double(tau[k])) -
                                       std::exp(-shadow::opticalDepthToLight({i}, light, dvec3(below[k])))));
    EXPECT_LT(worst, 0.06) << floor;
  }
}

TEST(Remap, ConstantDensityHasItsClosedForm) {
  const volume::GridPtr grid = test::gridOf(48, [](ivec3) { return 0.5f; });
  volume::Instance i = test::gridInstance(grid, 48, 2);
  i.remap = table(0, 1, [](double u) { return u * u; });
  const dvec3 from(0, 0.2, 0.1), up(0, 0.4, 0.1);  // well inside: its rim fades
  const double want = std::exp(-2 * 0.25 * 0.2);
  EXPECT_NEAR(std::exp(-shadow::opticalDepth({i}, from, up)), want, 1e-5);
  const scene::Light light = test::sunFrom({0, 1, 0});
  const auto map =
      test::buildMap({i}, light, {shadow::Metric::Interval, 4, 4, 128}, {shadow::Basis::Cosine, 16, 128});
  const auto tau = test::lookupTau(*map, light, {vec3(from), vec3(up)});
  EXPECT_NEAR(std::exp(-double(tau[0] - tau[1])), want, 2e-3);
}

TEST(Remap, ColoursScatterByDensity) {
  volume::Instance white = blobs(20), red = white;
  const auto grey = table(0, 1, [](double u) { return u; });
  white.remap = grey;
  std::vector<vec4> entries = grey->entries;
  for (vec4& e : entries) e = vec4(1, 0.5f, 0, e.a);
  red.remap = volume::makeRemap(0, 1, entries);
  const auto a = look({white}, marched({white})), b = look({red}, marched({red}));
  double lit = 0;
  for (std::size_t p = 0; p < a.layers[0].pixels.size(); p += 4) {
    const float* w = &a.layers[0].pixels[p];
    const float* r = &b.layers[0].pixels[p];
    lit = std::max(lit, double(w[0]));
    ASSERT_NEAR(r[0], w[0], 1e-6);
    ASSERT_NEAR(r[1], 0.5f * w[1], 1e-6);
    ASSERT_EQ(r[2], 0);
    ASSERT_NEAR(r[3], w[3], 1e-6) << "extinction stays";
  }
  EXPECT_GT(lit, 0.05);
}

TEST(Remap, PausesAndOverlapsLeaveNoTrace) {
  // Tables of their own, one of them a colour, and a shape and a plain grid among them: more than march
  // together.
  volume::InstanceList volumes;
  for (int k = 0; k < 7; ++k) {
    volume::Instance i = blobs(2);
    i.worldFromLocal = glm::translate(dmat4(1.0), dvec3(0.02 * k, 0, 0.01 * k)) * i.worldFromLocal;
    if (k > 0) i.remap = table(0, 1, [k](double u) { return k % 2 ? 1 - u : u * u; });
    volumes.push_back(i);
  }
  volumes.push_back(test::box({0, 0, 0}, {0.5, 0.5, 0.5}, 0.4));
  view::RenderOptions o;
  o.size = ivec2(24);
  o.samples = 1;
  o.camera.eye = {0.3, 0.2, 4};
  const auto picture = [&](int pauseAfter) {
    view::VolumeRenderPass pass(o, volumes, marched(volumes));
    pass.pauseAfter(pauseAfter);
    while (pass.step(test::renderer().gpu(), 1e12).value() < 1) {
    }
    return view::readBack(*pass.picture()).value();
  };
  test::renderer();
  const image::Image whole = picture(residency::MarchBudget::kNever);
  EXPECT_LT(test::largestDifference(whole, picture(300)), 1e-5);
  EXPECT_GT(*std::max_element(whole.layers[0].pixels.begin(), whole.layers[0].pixels.end()), 0.3f);
}

TEST(Remap, AnotherCurveUploadsNoBricks) {
  volume::Instance i = blobs(1);
  residency::VolumeSet set;
  residency::BrickPool& pool = test::renderer().bricks();
  i.remap = table(0, 1, [](double u) { return u; });
  while (set.prepare(pool, {i}, 1e12)->fraction < 1) {
  }
  const auto generation = pool.generation();
  i.remap = table(0, 1, [](double u) { return 1 - u; });
  EXPECT_EQ(set.prepare(pool, {i}, 1e12)->fraction, 1);
  EXPECT_EQ(pool.generation(), generation);
  EXPECT_EQ(set.shapes(), 5);
}

}  // namespace
}  // namespace pileus
