// Passes whose loops run far more often than llvmpipe lets them (65535 times an invocation, then all of them
// end in silence).
#include <cmath>

#include "renderer/shaders/shared/resume.h"
#include "renderer/shadow/metric.h"
#include "renderer/shadow/reference.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/compare.h"
#include "renderer/truth/shadow_error.h"
#include "renderer/volume/brick_builder.h"
#include "tests/support/lit.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

/// A homogeneous block of voxels, density 1, `depth` metres high and `voxels` voxels; 48 voxels wide.
volume::Instance block(int voxels, double depth, double sigma, double width = 0.5) {
  volume::VoxelSource source;
  source.name = "block";
  source.worldFromIndex = glm::scale(glm::translate(dmat4(1), dvec3(0, -depth / 2, 0)),
                                     dvec3(width / 48, depth / voxels, width / 48));
  source.activeMin = ivec3(-24, 0, -24);
  source.activeMax = ivec3(23, voxels - 1, 23);
  source.fill = [](ivec3, float* out) {
    out[0] = 1;
    return volume::Fill::Constant;
  };
  JobControl control;
  auto built = volume::buildBricks(source, control);
  EXPECT_TRUE(built);
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = built->grid;
  i.worldFromLocal = i.grid->worldFromIndex;
  i.medium.extinction = sigma;
  i.medium.albedo = vec3(0.7f);
  return i;
}

ShadowSpec marched(double stepScale) {
  ShadowSpec spec;
  spec.kind = ShadowSpec::Kind::RayMarch;
  spec.stepScale = stepScale;
  return spec;
}

ShadowSpec mapped() {
  ShadowSpec spec;
  spec.metric = {shadow::Metric::Interval, 4, 4, 128};
  spec.extinction = {shadow::Basis::Cosine, 8, 128};
  return spec;
}

TEST(LoopLimit, MarchedSlabOfManySteps) {
  constexpr int kVoxels = 512;
  constexpr double kSigma = 0.8, kDepth = 2, kPhase = 0.7 / (4 * kPi);
  const volume::InstanceList volumes{block(kVoxels, kDepth, kSigma)};
  const auto sun = test::sunFrom({0, 1, 0});
  constexpr double kShadowStep = 0.2;
  view::RenderScene scene;
  scene.options.stepScale = 0.25;
  scene.volumes = volumes;
  scene.lights = {test::shadowed(sun, marched(kShadowStep), volumes)};
  const double n = kVoxels / scene.options.stepScale,
               iterations = n * (kVoxels / kShadowStep) / 2 / MARCH_UNROLL;
  EXPECT_GT(iterations, 200000);
  const vec4 lit = test::along({0, 50, 0}, {0, 0, 0}, scene),
             against = test::along({0, -50, 0}, {0, 0, 0}, scene);
  const double wantLit = kPhase * (1 - std::exp(-2 * kSigma * kDepth)) / 2,
               wantAgainst = kPhase * kSigma * kDepth * std::exp(-kSigma * kDepth);
  std::printf("%.0f iterations: %.3g and %.3g off\n", iterations, double(lit.x) / wantLit - 1,
              double(against.x) / wantAgainst - 1);
  EXPECT_NEAR(lit.x, wantLit, 2e-3 * kPhase);
  EXPECT_NEAR(against.x, wantAgainst, 2e-3 * kPhase);
  EXPECT_NEAR(lit.w, 1 - std::exp(-kSigma * kDepth), 1e-3);
}

/// Grids and exact shapes that overlap, more than are kept in registers, solids, and lights of all kinds.
view::RenderScene mixedScene(int lights) {
  view::RenderScene scene;
  scene.options.size = ivec2(48, 40);
  scene.options.samples = 2;
  scene.options.stepScale = 2;  // without pauses it has to be within the limit
  scene.options.camera = {{1.5, 0.6, 4}, {0, -0.2, 0}, {0, 1, 0}, 40};
  for (int i = 0; i < 3; ++i) {
    volume::Instance v = block(48, 1, 0.5 + 0.3 * i, 1);
    v.worldFromLocal = glm::translate(dmat4(1), dvec3(0.35 * i - 0.4, 0.2 * i, 0.1 * i)) * v.worldFromLocal;
    scene.volumes.push_back(v);
  }
  scene.volumes.push_back(test::ball({0.2, 0.1, 0.2}, 0.5, 0.7));
  scene.volumes.push_back(test::box({0, 0, 0}, {0.8, 0.6, 1.2}, 0.4, {20, 30, 0}));
  scene.volumes.push_back(test::box({-0.1, 0.3, 0}, {0.7, 0.6, 0.9}, 0.3));
  scene.solids = {test::solidPlane({0, -1, 0}, {8, 1, 8}), test::solidBox({0.9, 0, -0.5}, {0.4, 0.5, 0.3})};
  const auto sun = test::sunFrom({0.4, 1, 0.3}, 2);
  scene.lights = {test::shadowed(sun, marched(0.5), scene.volumes, scene.solids),
                  test::shadowed(test::pointAt({-1.5, 2, 1}, 20), mapped(), scene.volumes, scene.solids),
                  test::shadowed(test::spotAt({1, 3, 1}, {0, 0, 0}, 40), marched(0.25), scene.volumes),
                  {test::sunFrom({-1, 0.4, 0}, 0.3f), nullptr}};
  scene.lights.resize(std::size_t(lights));
  return scene;
}

struct Drawn {
  image::Image image;
  int dispatches = 0;
};

Drawn draw(const view::RenderScene& scene, int pauseAfter) {
  view::VolumeRenderPass pass(scene);
  pass.pauseAfter(pauseAfter);
  Drawn out;
  for (double done = 0; done < 1;) {
    const auto step = pass.step(test::renderer().gpu(), 0);
    if (!step) {
      ADD_FAILURE() << step.error().message;
      return out;
    }
    done = *step;
  }
  out.image = view::readBack(*pass.picture()).value();
  out.dispatches = pass.dispatches();
  return out;
}

TEST(LoopLimit, PausesLeaveNoTraceInAPicture) {
  for (const int lights : {4, 1}) {
    const view::RenderScene scene = mixedScene(lights);
    const Drawn whole = draw(scene, residency::MarchBudget::kNever);
    for (const int pauseAfter : {1, 300, 1000}) {
      const Drawn cut = draw(scene, pauseAfter);
      double worst = 0, largest = 0;
      const auto &a = whole.image.layers[0].pixels, &b = cut.image.layers[0].pixels;
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, std::abs(double(a[i]) - double(b[i]))),
        largest = std::max(largest, double(a[i]));
      std::printf("%d lights, pause after %d: %d dispatches (%d without), %.2g of %.2g\n", lights, pauseAfter,
                  cut.dispatches, whole.dispatches, worst, largest);
      EXPECT_GT(cut.dispatches, whole.dispatches);
      EXPECT_GT(largest, 0.1);
      EXPECT_LE(worst, 1e-5);
    }
    EXPECT_EQ(whole.dispatches, scene.options.samples);  // one region
  }
}

TEST(LoopLimit, NothingIsCutWithoutNeed) {
  view::RenderScene scene;
  scene.options.size = ivec2(64, 64);
  scene.options.samples = 1;
  scene.options.camera = {{1.5, 0.6, 4}, {0, 0, 0}, {0, 1, 0}, 40};
  scene.volumes = {block(128, 1, 0.8, 1)};
  scene.lights = {test::shadowed(test::sunFrom({0.4, 1, 0.3}), mapped(), scene.volumes)};
  EXPECT_EQ(draw(scene, 0).dispatches, 1);
  scene.lights = {test::shadowed(test::sunFrom({0.4, 1, 0.3}), marched(0.5), scene.volumes)};
  EXPECT_EQ(draw(scene, 0).dispatches, 1);
}

TEST(LoopLimit, PausesLeaveNoTraceInShadowErrors) {
  std::array<double, 6> whole{};
  for (const int lights : {1, 4}) {
    view::RenderScene scene = mixedScene(lights);
    if (lights == 1) scene.lights = {mixedScene(2).lights[1]};
    const auto measure = [&](int pauseAfter) {
      truth::ShadowErrorPass pass(scene, truth::truthOf(scene, 0.4));
      pass.pauseAfter(pauseAfter);
      while (pass.step(test::renderer().gpu(), 1e9).value() < 1) {
      }
      return std::array<double, 6>{pass.samples(),      pass.mean(), pass.maximum(),
                                   pass.quantile(0.95), pass.leak(), pass.dark()};
    };
    // Three marched lights and their truths are too much for one dispatch on llvmpipe.
    whole = measure(0);
    for (const int pauseAfter : {1, 500}) {
      const auto cut = measure(pauseAfter);
      for (std::size_t i = 0; i < cut.size(); ++i)
        EXPECT_NEAR(cut[i], whole[i], 1e-5 * std::abs(whole[i]) + 1e-7) << lights << " lights, figure " << i;
    }
  }
  std::printf("%.0f samples, mean %.3g, largest %.3g\n", whole[0], whole[1], whole[2]);
  EXPECT_GT(whole[0], 10000);
}

TEST(LoopLimit, ShadowErrorOfManySteps) {
  // A map of a homogeneous slab is exact, so that whatever truth loses is an error.
  const volume::InstanceList volumes{block(512, 2, 0.8)};
  view::RenderScene scene;
  scene.options.size = ivec2(9, 9);
  scene.options.stepScale = 0.25;
  scene.options.camera = {{0, -50, 0}, {0, 0, 0}, {0, 0, 1}, 0.01};
  scene.volumes = volumes;
  scene.lights = {test::shadowed(test::sunFrom({0, 1, 0}), mapped(), volumes)};
  truth::ShadowErrorPass pass(scene, truth::truthOf(scene, 0.1));
  while (pass.step(test::renderer().gpu(), 1e9).value() < 1) {
  }
  std::printf("%.0f samples, mean %.3g, largest %.3g\n", pass.samples(), pass.mean(), pass.maximum());
  EXPECT_NEAR(pass.samples() / 81, 2048, 40);
  EXPECT_LT(pass.mean(), 1e-3);
  EXPECT_LT(std::abs(pass.maximum()), 5e-3);
}

TEST(LoopLimit, ExtinctionMapOverManyFineGrids) {
  for (const int count : {8, 40, 80}) {
    volume::InstanceList volumes;
    volume::Instance one = block(1024, 2, 0.02);
    for (int i = 0; i < count; ++i) {
      one.worldFromLocal =
          glm::translate(one.grid->worldFromIndex, dvec3(0, 3 * i, 0));  // by 3 voxels each: no two the same
      volumes.push_back(one);
    }
    const auto light = test::sunFrom({0, 1, 0});
    shadow::LightFrustum f;  // narrower than a voxel to a texel: the finest level
    f.worldFromLight =
        dmat4(dvec4(0.02, 0, 0, 0), dvec4(0, 0, 0.02, 0), dvec4(0, -4, 0, 0), dvec4(-0.01, 2, -0.01, 1));
    const double want = shadow::opticalDepth(volumes, {0, 3, 0}, {0, -3, 0});
    for (const shadow::Metric metric : {shadow::Metric::Interval}) {
      const auto map = test::buildMap(volumes, light, {metric, 4, 4, 32}, {shadow::Basis::Cosine, 8, 32}, &f);
      const auto c = test::texel(*map->block, ivec2(16));
      std::printf("%d grids: c_0 %.6f of %.6f\n", count, double(c[0]), want);
      EXPECT_NEAR(c[0], want, 1e-3 * want) << count << " grids, metric " << enumId(metric);
    }
  }
}

TEST(LoopLimit, OrderedMapsOverManyFineGrids) {
  for (const int count : {8, 40, 80}) {
    volume::InstanceList volumes;
    volume::Instance one = block(1024, 2, 0.02);
    for (int i = 0; i < count; ++i) {
      one.worldFromLocal = glm::translate(one.grid->worldFromIndex, dvec3(0, 3 * i, 0));
      volumes.push_back(one);
    }
    shadow::LightFrustum f;
    f.worldFromLight =
        dmat4(dvec4(0.02, 0, 0, 0), dvec4(0, 0, 0.02, 0), dvec4(0, -4, 0, 0), dvec4(-0.01, 2, -0.01, 1));
    const auto light = test::sunFrom({0, 1, 0});
    const std::vector<vec3> at{{0.001f, 0.5f, 0.001f}, {0.001f, -0.5f, 0.001f}, {0.001f, -1.9f, 0.001f}};
    for (const auto kind :
         {shadow::ShadowSpec::Kind::Deep, shadow::ShadowSpec::Kind::TransmittanceFunction}) {
      shadow::ShadowSpec spec;
      spec.kind = kind;
      spec.coefficients = 31;
      spec.basis = shadow::Basis::Cosine;
      spec.storage = shadow::Storage::Float;
      spec.errorBound = 0.002;
      shadow::ShadowPass pass(shadow::withResolution(spec, 32), light, volumes, {}, &f);
      for (double done = 0; done < 1;) {
        const auto step = pass.step(test::renderer().gpu(), 1e12);
        ASSERT_TRUE(step) << step.error().message;
        done = *step;
      }
      const auto tau = test::lookupTau(*pass.map(), light, at);
      for (std::size_t i = 0; i < at.size(); ++i) {
        const double want = std::exp(-shadow::opticalDepthToLight(volumes, light, dvec3(at[i]))),
                     got = std::exp(-double(tau[i]));
        std::printf("%d grids, %s: T %.4f of %.4f\n", count, shadow::describe(spec).c_str(), got, want);
        EXPECT_NEAR(got, want, 0.01) << count;
      }
    }
  }
}

}  // namespace
}  // namespace pileus
