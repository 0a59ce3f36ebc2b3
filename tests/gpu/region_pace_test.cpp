// Passes as a GPU runs them, in regions and pauses that follow the time: no bit of a result knows of it.
#include "tests/support/gl_faults.h"
#include "tests/support/lit.h"
#include "tests/support/noise_grid.h"

#include "renderer/truth/compare.h"

namespace pileus {
namespace {

struct Devices {
  gl::DeviceInfo software = test::renderer().device(), gpu = software;
  Devices() { gpu.software = false; }
};

shadow::Gpu on(const gl::DeviceInfo& device) {
  const shadow::Gpu shared = test::renderer().gpu();
  return {device, shared.shaders, shared.bricks, shared.store};
}

volume::InstanceList media() {
  return {test::gridInstance(test::gridOf(80, test::blobs), 80, 3), test::ball({0.2, 0.1, 0.2}, 0.3, 0.7),
          test::box({0, -0.1, 0}, {0.5, 0.4, 0.6}, 0.4, {20, 30, 0})};
}

view::RenderScene scene() {
  view::RenderScene s;
  s.options.size = ivec2(200, 136);
  s.options.samples = 2;
  s.options.camera = {{0.4, 0.5, 2.2}, {0, 0, 0}, {0, 1, 0}, 40};
  s.volumes = media();
  shadow::ShadowSpec marched;
  marched.kind = shadow::ShadowSpec::Kind::RayMarch;
  s.lights = {test::shadowed(test::sunFrom({0.4, 1, 0.3}, 2), marched, s.volumes)};
  return s;
}

template <class Pass>
void finish(Pass& pass, const shadow::Gpu& gpu) {
  for (double done = 0; done < 1;) {
    const auto step = pass.step(gpu, 1e12);
    ASSERT_TRUE(step) << step.error().message;
    ASSERT_GE(*step, done);
    done = *step;
  }
}

TEST(RegionPace, PicturesAreTheSameInAnyRegions) {
  const Devices devices;
  const auto draw = [&](const gl::DeviceInfo& device) {
    view::VolumeRenderPass pass(scene());
    pass.pauseAfter(residency::MarchBudget::kNever);
    finish(pass, on(device));
    return view::readBack(*pass.picture())->layers[0].pixels;
  };
  EXPECT_EQ(draw(devices.software), draw(devices.gpu));
}

TEST(RegionPace, MapsAreTheSameInAnyRegions) {
  const Devices devices;
  const volume::InstanceList volumes = media();
  const std::vector<vec3> at{{0, 0.3f, 0}, {0.1f, -0.2f, 0.2f}, {-0.3f, -0.45f, -0.1f}, {0.3f, 0.1f, 0}};
  for (const auto kind : {shadow::ShadowSpec::Kind::Extinction, shadow::ShadowSpec::Kind::FourierOpacity,
                          shadow::ShadowSpec::Kind::TransmittanceFunction, shadow::ShadowSpec::Kind::Deep})
    for (const bool point : {false, true}) {
      shadow::ShadowSpec spec;
      spec.kind = kind;
      spec.resolution = 160;
      spec.metric = {shadow::Metric::Interval, 4, 4, 160};
      spec.extinction = {shadow::Basis::Cosine, 8, 160};
      const auto light = point ? test::pointAt({0.3, 2, 0.2}) : test::sunFrom({0.2, 1, 0.1});
      const auto tau = [&](const gl::DeviceInfo& device) {
        const auto map = shadow::buildShadow(on(device), spec, light, volumes);
        EXPECT_TRUE(map) << (map ? "" : map.error().message);
        return map ? test::lookupTau(**map, light, at) : std::vector<float>{};
      };
      EXPECT_EQ(tau(devices.software), tau(devices.gpu)) << int(kind) << (point ? " point" : " sun");
    }
}

TEST(RegionPace, ACostlyMarchPausesOnEveryDevice) {
  const Devices devices;
  residency::MarchCost cost;
  cost.pixel = 10 * residency::MarchBudget::kOneDispatch;
  for (const gl::DeviceInfo& device : {devices.software, devices.gpu}) {
    residency::MarchBudget budget;
    budget.plan(cost, device);
    EXPECT_TRUE(budget.resumes());
    budget.plan({}, device);
    EXPECT_FALSE(budget.resumes());
  }
}

TEST(RegionPace, BothSidesOfAComparisonEndTheirSamplesTogether) {
  const Devices devices;
  const auto figures = [&](const gl::DeviceInfo& device) {
    view::RenderScene s = scene();
    s.options.size = ivec2(100, 70);
    shadow::ShadowSpec spec;
    spec.metric = {shadow::Metric::Interval, 4, 4, 64};
    spec.extinction = {shadow::Basis::Cosine, 8, 64};
    s.lights = {test::shadowed(test::sunFrom({0.4, 1, 0.3}, 2), spec, s.volumes)};
    truth::ComparePass pass(s);
    finish(pass, on(device));
    EXPECT_EQ(pass.mapped()->samples, pass.truth()->samples);
    EXPECT_EQ(pass.mapped()->fraction, 1);
    EXPECT_EQ(pass.truth()->fraction, 1);
    return pass.figures();
  };
  const auto a = figures(devices.software), b = figures(devices.gpu);
  EXPECT_EQ(a.relMse, b.relMse);
  EXPECT_EQ(a.radiance.mean, b.radiance.mean);
  EXPECT_EQ(a.samples, b.samples);
}

TEST(RegionPace, LightsWhoseBricksComeLateAreCountedOnce) {
  // Two lights, a dispatch each; the second one's shadow is that of a grid which the first does not have.
  view::RenderScene s = scene();
  s.options.size = ivec2(24, 16);
  s.options.samples = 1;
  s.volumes = {test::ball({0, 0, 0}, 0.5, 2)};
  shadow::ShadowSpec spec;
  spec.metric = {shadow::Metric::Interval, 2, 4, 32};
  spec.extinction = {shadow::Basis::Cosine, 4, 32};
  const volume::InstanceList other{test::gridInstance(test::gridOf(48, test::blobs), 48, 2)};
  s.lights = {test::shadowed(test::sunFrom({0.4, 1, 0.3}, 2), spec, s.volumes),
              test::shadowed(test::sunFrom({-0.4, 1, 0.3}, 2), spec, other)};
  const auto measure = [&](double ms) {
    residency::BrickPool bricks(test::renderer().device(), std::size_t(64) << 20);
    const shadow::Gpu shared = test::renderer().gpu();
    const shadow::Gpu gpu{shared.device, shared.shaders, bricks, shared.store};
    truth::ShadowErrorPass pass(s, truth::truthOf(s), 1);
    int steps = 0;
    for (double done = 0; done < 1; ++steps) {
      const auto step = pass.step(gpu, ms);
      EXPECT_TRUE(step) << (step ? "" : step.error().message);
      if (!step) break;
      done = *step;
    }
    EXPECT_TRUE(ms > 0 || steps > 8) << "bricks came a few at a time";
    return std::pair(pass.samples(), pass.mean());
  };
  const auto atOnce = measure(1e12), late = measure(0);
  EXPECT_GT(atOnce.first, 1000);
  EXPECT_EQ(late.first, atOnce.first);
  EXPECT_NEAR(late.second, atOnce.second, 1e-9);
}

}  // namespace
}  // namespace pileus
