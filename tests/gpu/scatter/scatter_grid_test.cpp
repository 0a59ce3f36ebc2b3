// Light that was scattered more than once, as pictures get it from a lattice: against unbiased paths, and
// against what must be so.
#include <cmath>

#include "renderer/image/metrics.h"
#include "tests/support/noise_grid.h"
#include "tests/support/traced.h"

namespace pileus {
namespace {

view::RenderScene sceneOf(const volume::InstanceList& volumes, ivec2 size, int samples) {
  view::RenderScene scene;
  scene.options.size = size;
  scene.options.samples = samples;
  scene.options.camera = {{0, 0.2, 2.4}, {0, 0, 0}, {0, 1, 0}, 28};
  scene.options.scatter.kind = view::Scattering::Grid;
  scene.volumes = volumes;
  return scene;
}

void light(view::RenderScene& scene, const dvec3& towards, float irradiance = 10) {
  const scene::Light sun = test::sunFrom(towards, irradiance);
  scene.lights.push_back({sun, shadow::marchedShadow(sun, scene.volumes, scene.solids)});
}

volume::Instance cloud(double extinction, double g, float albedo = 0.99f) {
  volume::Instance i = test::gridInstance(test::gridOf(80, test::blobs), 80, extinction);
  i.medium.albedo = vec3(albedo);
  i.medium.phase = scene::henyeyGreenstein(g);
  return i;
}

/// Means of 4 x 4 pixels against all orders by paths.
image::ScaledRelMse judged(const view::RenderScene& scene, int samples, const std::string& what) {
  const image::Image picture = test::render(scene);
  view::RenderScene paths = scene;
  paths.options.samples = samples;
  view::PathTracePass judge(paths, {});
  test::runToEnd(judge);
  EXPECT_EQ(judge.statistics().violations, 0);
  const auto halves = judge.halves().value();
  const auto blocks = [](const image::Image& i) { return image::blocksOf(i, 4); };
  const auto f = image::scaledRelMse(blocks(picture), blocks(halves[0]), blocks(halves[1])).value();
  std::printf("  %-40s scaled relMSE %.4f +- %.4f, ratio %.4f\n", what.c_str(), f.value, f.standardError,
              f.ratio);
  return f;
}

TEST(ScatterGrid, ACloudIsAsPathsHaveIt) {
  for (const double g : {0.0, 0.6, 0.85})
    for (const dvec3& towards : {dvec3(0.2, 0.4, 1), dvec3(1, 0.4, 0.1), dvec3(-0.3, 0.4, -1)}) {
      view::RenderScene scene = sceneOf({cloud(40, g)}, {48, 28}, 16);
      light(scene, towards);
      const auto f = judged(scene, g == 0 ? 128 : 512,
                            fmt::format("g {}, sun from ({}, {}, {})", g, towards.x, towards.y, towards.z));
      EXPECT_NEAR(f.ratio, 1, 0.06);
      EXPECT_LT(f.value, (g < 0.8 ? 0.01 : 0.02) + 2 * f.standardError);
    }
}

vec3 meanOf(const image::Image& picture) {
  const std::vector<float>& p = picture.layers[0].pixels;
  dvec3 sum(0);
  for (std::size_t i = 0; i < p.size(); i += 4) sum += dvec3(p[i], p[i + 1], p[i + 2]);
  return vec3(sum / (double(p.size()) / 4));
}

/// White media under the same light from everywhere are as bright as it.
TEST(ScatterGrid, Furnace) {
  for (const double g : {0.0, 0.6, 0.85}) {
    volume::Instance ball = test::ball({0, 0, 0}, 0.5, 10);
    ball.medium.albedo = vec3(1);
    ball.medium.phase = scene::henyeyGreenstein(g);
    view::RenderScene scene = sceneOf({ball}, {64, 36}, 4);
    scene.options.camera = {{0, 0.2, 3}, {0, 0, 0}, {0, 1, 0}, 24};
    // From directions all around, of a spiral.
    constexpr int kSuns = 48;
    for (int i = 0; i < kSuns; ++i) {
      const double z = 1 - (2 * i + 1.0) / kSuns, a = i * kPi * (3 - std::sqrt(5.0));
      light(scene, {std::sqrt(1 - z * z) * std::cos(a), z, std::sqrt(1 - z * z) * std::sin(a)},
            float(4 * kPi / kSuns));
      scene.lights.back().light.narrow = 0.9;
    }
    const image::Image picture = test::render(scene);
    const std::vector<float>& p = picture.layers[0].pixels;
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < p.size(); i += 4) {
      if (p[i + 3] < 0.9f) continue;
      sum += double(p[i]), weight += 1;
      // What is seen through it is the light itself.
    }
    std::printf("  furnace g %g: %.4f of %g pixels\n", g, sum / weight, weight);
    EXPECT_GT(weight, 100);
    EXPECT_NEAR(sum / weight, 1, 0.02) << g;
  }
}

TEST(ScatterGrid, TheSameSolutionServesForEveryCamera) {
  view::RenderScene scene = sceneOf({cloud(20, 0.5)}, {32, 18}, 1);
  light(scene, {0.3, 1, 0.2});
  auto cache = std::make_shared<view::ScatterCache>();
  const auto shown = [&](const view::RenderScene& s) {
    view::VolumeRenderPass pass(s);
    pass.keepScatterIn(cache);
    test::runToEnd(pass);
    return view::readBack(*pass.picture()).value();
  };
  const image::Image first = shown(scene);
  EXPECT_EQ(cache->solved(), 1);
  scene.options.camera.eye = {1, 1, 2}, scene.options.samples = 3, scene.options.size = {48, 27};
  shown(scene);
  EXPECT_EQ(cache->solved(), 1) << "an orbit, samples and sizes cost no sweep";
  light(scene, {-1, 1, 0});
  shown(scene);
  EXPECT_EQ(cache->solved(), 2);
  scene.lights.pop_back();
  shown(scene);
  EXPECT_EQ(cache->solved(), 2) << "what was there before is kept";
}

TEST(ScatterGrid, IsTheSameHoweverItsWorkIsCut) {
  view::RenderScene scene = sceneOf({cloud(20, 0.5), test::ball({0.1, 0.1, 0.2}, 0.2, 5)}, {32, 18}, 2);
  scene.solids = {test::solidPlane({0, -0.5, 0}, {3, 1, 3})};
  light(scene, {0.3, 1, 0.2});
  const image::Image whole = test::render(scene);
  view::VolumeRenderPass pass(scene);
  pass.pauseAfter(300);
  test::runToEnd(pass);
  const image::Image cut = view::readBack(*pass.picture()).value();
  EXPECT_LT(test::largestDifference(whole, cut), 1e-5 * double(meanOf(whole).x));
}

TEST(ScatterGrid, LayersOfLightsAddUp) {
  volume::Instance smoke = cloud(15, 0.4, 0.9f);
  smoke.medium.albedo = vec3(0.95f, 0.8f, 0.6f);
  volume::Instance fire = test::ball({0.1, 0, 0}, 0.15, 1);
  fire.emission = test::table(0, 1, [](double x) { return x; });
  view::RenderScene scene = sceneOf({smoke, fire}, {32, 18}, 2);
  scene.options.scatter.residual = 1e-6;
  light(scene, {0.3, 1, 0.2});
  scene.lights.push_back({test::pointAt({-0.6, 0.2, 0.3}, 2), nullptr});
  const image::Image beauty = test::render(scene);
  std::vector<float> sum(beauty.layers[0].pixels.size(), 0.0f);
  using Kind = view::PictureLayer::Kind;
  for (const view::PictureLayer layer :
       {view::PictureLayer{Kind::Light, 0}, view::PictureLayer{Kind::Light, 1},
        view::PictureLayer{Kind::Emission, 0}}) {
    view::RenderScene one = scene;
    one.options.layer = layer;
    const image::Image part = test::render(one);
    EXPECT_GT(meanOf(part).x, 0) << int(layer.kind) << " " << layer.light;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part.layers[0].pixels[i];
  }
  const float mean = meanOf(beauty).x;
  for (std::size_t i = 0; i < sum.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(sum[i + c], beauty.layers[0].pixels[i + c],
                  1e-3f * (mean + beauty.layers[0].pixels[i + c]));
}

/// What was scattered once, and what the picture has beside it: of media that differ, fire, solids and what
/// is seen of an environment.
TEST(ScatterLayers, OrdersAddUp) {
  volume::Instance smoke = cloud(15, 0.6, 0.9f);
  smoke.medium.albedo = vec3(0.95f, 0.8f, 0.6f);
  volume::Instance fire = test::ball({0.1, 0, 0}, 0.15, 1);
  fire.emission = test::table(0, 1, [](double x) { return x; });
  view::RenderScene scene = sceneOf({smoke, fire}, {32, 18}, 2);
  scene.solids = {test::solidPlane({0, -0.5, 0}, {2, 1, 2})};
  light(scene, {0.3, 1, 0.2});
  scene.lights.push_back({test::pointAt({-0.6, 0.2, 0.3}, 2), nullptr});
  using Kind = view::PictureLayer::Kind;
  const auto layer = [&](Kind kind) {
    view::RenderScene one = scene;
    one.options.layer.kind = kind;
    return test::render(one);
  };
  for (const view::Scattering how :
       {view::Scattering::Single, view::Scattering::Octaves, view::Scattering::Grid}) {
    scene.options.scatter.kind = how;
    const image::Image beauty = layer(Kind::Beauty), single = layer(Kind::Single),
                       multiple = layer(Kind::Multiple);
    const float mean = meanOf(beauty).x;
    double off = 0;
    for (std::size_t i = 0; i < beauty.layers[0].pixels.size(); ++i) {
      const double all = double(beauty.layers[0].pixels[i]),
                   sum = double(single.layers[0].pixels[i]) + double(multiple.layers[0].pixels[i]);
      if (i % 4 == 3) continue;
      off = std::max(off, std::abs(all - sum) / (double(mean) + all));
    }
    std::printf("  %s: beauty %.4f = single %.4f + multiple %.4f, off by %.1e\n",
                std::string(enumId(how)).c_str(), double(mean), double(meanOf(single).x),
                double(meanOf(multiple).x), off);
    EXPECT_LT(off, 3e-4);
    const bool none = how == view::Scattering::Single;
    EXPECT_TRUE(none ? std::abs(meanOf(multiple).x) < 1e-6f * mean : meanOf(multiple).x > 0.1f * mean);
    scene.options.scatter.kind = view::Scattering::Single;
    EXPECT_LT(test::largestDifference(single, layer(Kind::Beauty)), 1e-6 * double(mean));
  }
}

TEST(ScatterGrid, NothingToScatterIsBlackAndFinite) {
  volume::Instance black = cloud(20, 0.3, 0);
  for (const volume::InstanceList& volumes :
       {volume::InstanceList{}, volume::InstanceList{black}, volume::InstanceList{cloud(1e-6, 0)}}) {
    view::RenderScene scene = sceneOf(volumes, {16, 9}, 1);
    light(scene, {0, 1, 0});
    const image::Image picture = test::render(scene);
    for (const float v : picture.layers[0].pixels) EXPECT_TRUE(std::isfinite(v));
    EXPECT_LT(meanOf(picture).x, 1e-5f);
  }
  view::RenderScene dark = sceneOf({cloud(20, 0.3)}, {16, 9}, 1);
  EXPECT_EQ(meanOf(test::render(dark)), vec3(0)) << "no light";
}

/// Far from the world's origin everything is as it is there.
TEST(ScatterGrid, AMillionMetresAwayIsTheSame) {
  const auto shown = [](const dvec3& at) {
    view::RenderScene scene = sceneOf({test::box(at, {1, 1, 1}, 10)}, {32, 18}, 1);
    scene.options.camera.eye += at, scene.options.camera.target += at;
    light(scene, {0.3, 1, 0.5});
    return test::render(scene);
  };
  const image::Image here = shown(dvec3(0)), far = shown(dvec3(1e6));
  EXPECT_LT(test::largestDifference(here, far), 1e-4 * double(meanOf(here).x));
}

/// From all but nothing to all but a wall, from straight on to straight back.
TEST(ScatterGrid, EndsAreFinite) {
  for (const double density : {1e-6, 1.0, 1e4})
    for (const double g : {-0.9, 0.0, 0.9999}) {
      volume::Instance box = test::box({0, 0, 0}, {1, 1, 1}, density);
      box.medium.albedo = vec3(1, 0.8f, 0.3f);
      box.medium.phase = scene::henyeyGreenstein(g);
      view::RenderScene scene = sceneOf({box}, {16, 9}, 1);
      light(scene, {0.3, 1, 0.5});
      const image::Image picture = test::render(scene);
      for (const float v : picture.layers[0].pixels) {
        ASSERT_TRUE(std::isfinite(v)) << density << " " << g;
        ASSERT_GE(v, 0) << density << " " << g;
      }
    }
}

/// Where next to nothing is scattered twice both ways are one, also next to a lamp, whose light turns
/// quickly.
TEST(ScatterGrid, InThinHazeItIsSingleScattering) {
  for (const double g : {0.0, 0.8}) {
    volume::Instance haze = test::box({0, 0, 0}, {1, 1, 1}, 1e-3);
    haze.medium.phase = scene::henyeyGreenstein(g);
    view::RenderScene scene = sceneOf({haze}, {32, 18}, 4);
    scene.lights.push_back({test::pointAt({0.05, 0.02, 0.1}), nullptr});
    const image::Image grid = test::render(scene);
    scene.options.scatter = {};
    const image::Image single = test::render(scene);
    const double mean = double(meanOf(single).x);
    double off = 0;  // of a pixel next to it, or next to the mean where it is dark
    for (std::size_t i = 0; i < grid.layers[0].pixels.size(); i += 4) {
      const double a = double(grid.layers[0].pixels[i]), b = double(single.layers[0].pixels[i]);
      off = std::max(off, std::abs(a - b) / (b + mean));
    }
    std::printf("  g %g: largest difference %.5f\n", g, off);
    EXPECT_NEAR(meanOf(grid).x / meanOf(single).x, 1, 3e-3);
    EXPECT_LT(off, 5e-3);
  }
}

/// However dense: what is sent back is decided in a skin far thinner than a cell.
TEST(ScatterGrid, DenseMediaAreAsPathsHaveThem) {
  for (const double extinction : {40.0, 400.0, 1e4})
    for (const bool ball : {true, false})
      for (const double g : {0.0, 0.8}) {
        volume::Instance dense =
            ball ? test::ball({0, 0, 0}, 0.5, extinction) : test::box({0, 0, 0}, {0.8, 0.6, 0.5}, extinction);
        dense.medium.albedo = vec3(0.99f, 0.9f, 0.6f);
        dense.medium.phase = scene::henyeyGreenstein(g);
        view::RenderScene scene = sceneOf({dense}, {48, 28}, 4);
        light(scene, {0.6, 0.5, 0.7});
        const auto f =
            judged(scene, 32, fmt::format("{} of {} /m, g {}", ball ? "ball" : "box", extinction, g));
        EXPECT_NEAR(f.ratio, 1, 0.09);
      }
}

TEST(ScatterGrid, ManySunsAreAsOne) {
  const auto shown = [](int count) {
    view::RenderScene scene = sceneOf({cloud(20, 0.5)}, {24, 14}, 1);
    scene.solids = {test::solidPlane({0, -0.5, 0}, {2, 1, 2})};
    for (int i = 0; i < count; ++i) light(scene, {0.3, 1, 0.5}, 60.0f / float(count));
    return test::render(scene);
  };
  const image::Image one = shown(1), many = shown(60);
  EXPECT_LT(test::largestDifference(one, many), 1e-3 * double(meanOf(one).x));
}

TEST(ScatterGrid, SolidsReflectIntoMedia) {
  const auto shown = [](float albedo) {
    view::RenderScene scene = sceneOf({cloud(20, 0)}, {32, 18}, 2);
    scene.solids = {test::solidPlane({0, -0.4, 0}, {4, 1, 4}, dvec3(0), vec3(albedo))};
    light(scene, {0.2, 1, 0.1});
    scene.options.camera.eye = {0, -0.1, 2.4};
    return scene;
  };
  const float dark = meanOf(test::render(shown(0))).x, bright = meanOf(test::render(shown(0.8f))).x;
  EXPECT_GT(bright, dark);
  // What lies further off than the cloud is large is missing.
  const auto f = judged(shown(0.8f), 256, "above a white ground");
  EXPECT_NEAR(f.ratio, 1, 0.05);
}

}  // namespace
}  // namespace pileus
