// The comparison with marched truth: nothing where there is nothing, and a wrong map's error as a CPU adds it
// up.
#include "renderer/truth/compare.h"

#include <algorithm>
#include <cmath>

#include "renderer/shadow/reference.h"
#include "renderer/shadow/shadow_pass.h"
#include "renderer/truth/shadow_probe.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

volume::InstanceList twoBoxes() {
  return {test::box(dvec3(0, 1.2, 0), dvec3(1.6, 0.5, 1.2), 1.5),
          test::box(dvec3(0.2, -1, 0.1), dvec3(1.2, 0.7, 1), 2)};
}

view::RenderScene sceneOf(const ShadowSpec& spec, ivec2 size, int samples) {
  view::RenderScene scene;
  scene.options.size = size;
  scene.options.samples = samples;
  scene.options.camera = {dvec3(1.5, 0.6, 6), dvec3(0), dvec3(0, 1, 0), 40};
  scene.volumes = twoBoxes();
  const scene::Light sun = test::sunFrom(dvec3(0.3, 1, 0.2), 3);
  const auto map = shadow::buildShadow(test::renderer().gpu(), spec, sun, scene.volumes);
  EXPECT_TRUE(map) << map.error().message;
  scene.lights = {{sun, *map}};
  return scene;
}

void finish(truth::ComparePass& pass) {
  for (int i = 0; i < 100000; ++i) {
    const auto done = pass.step(test::renderer().gpu(), 1e9);
    ASSERT_TRUE(done) << done.error().message;
    if (*done >= 1) return;
  }
  FAIL() << "never done";
}

/// Every sample in media of the pictures' rays at pixel centres, and how much of each is seen.
struct Seen {
  std::vector<vec4> positions;
  std::vector<double> weights;
};

Seen samplesOf(const view::RenderScene& scene) {
  const view::RenderOptions& o = scene.options;
  Seen seen;
  for (int y = 0; y < o.size.y; ++y)
    for (int x = 0; x < o.size.x; ++x) {
      const dvec3 d =
          scene::rayDirection(o.camera, double(o.size.x) / o.size.y, (dvec2(x, y) + 0.5) / dvec2(o.size));
      struct Part {
        dvec2 range;
        double sigma, detail;
      };
      std::vector<Part> parts;
      for (const volume::Instance& i : scene.volumes) {
        const dmat4 m = glm::inverse(i.worldFromLocal);
        if (const auto hit = intersectBox(dvec3(m * dvec4(o.camera.eye, 1)), dvec3(m * dvec4(d, 0)),
                                          dvec3(-0.5), dvec3(0.5)))
          parts.push_back({*hit, volume::majorant(i), volume::detailSize(i)});
      }
      std::sort(parts.begin(), parts.end(),
                [](const Part& a, const Part& b) { return a.range.x < b.range.x; });
      double T = 1;
      for (const Part& p : parts) {  // disjoint along these rays
        const int n = std::max(1, int(std::ceil((p.range.y - p.range.x) / (p.detail * o.stepScale))));
        const double ds = (p.range.y - p.range.x) / n, step = std::exp(-p.sigma * ds);
        for (int k = 0; k < n && T >= 1e-4; ++k) {
          seen.positions.push_back(vec4(vec3(o.camera.eye + (p.range.x + (k + 0.5) * ds) * d), 0));
          seen.weights.push_back(T * (1 - step));
          T *= step;
        }
      }
    }
  return seen;
}

TEST(Compare, MarchedAgainstMarchedIsNothing) {
  ShadowSpec spec;
  spec.kind = ShadowSpec::Kind::RayMarch;
  truth::ComparePass pass(sceneOf(spec, {40, 30}, 2));
  finish(pass);
  const truth::CompareFigures& f = pass.figures();
  EXPECT_GT(f.samples, 1000);
  EXPECT_EQ(f.pictureSamples, 2);
  for (const double e : {f.shadow.mean, f.shadow.p95, f.shadow.maximum, f.leak, f.dark, f.radiance.mean,
                         f.radiance.p95, f.radiance.maximum, f.relMse})
    EXPECT_LT(e, 1e-5);
}

TEST(Compare, AWrongMapsErrorIsWhatACpuAddsUp) {
  ShadowSpec spec;
  spec.kind = ShadowSpec::Kind::FourierOpacity;
  spec.coefficients = 3;
  spec.resolution = 64;
  const view::RenderScene scene = sceneOf(spec, {40, 30}, 1);
  truth::ComparePass pass(scene);
  finish(pass);

  const Seen seen = samplesOf(scene);
  const auto mapped =
      truth::lookupTransmittance(test::renderer().gpu(), *scene.lights[0].shadow, seen.positions);
  ASSERT_TRUE(mapped) << mapped.error().message;
  std::vector<double> errors;
  double mean = 0, leakMinusDark = 0, weights = 0;
  for (std::size_t i = 0; i < seen.positions.size(); ++i) {
    const double truth = std::exp(
        -shadow::opticalDepthToLight(scene.volumes, scene.lights[0].light, dvec3(seen.positions[i])));
    const double e = double((*mapped)[i]) - truth;
    errors.push_back(std::abs(e));
    mean += std::abs(e) / double(seen.positions.size());
    leakMinusDark += seen.weights[i] * e;
    weights += seen.weights[i];
  }
  std::sort(errors.begin(), errors.end());
  const double p95 = errors[std::size_t(0.95 * double(errors.size()))];
  const truth::CompareFigures& f = pass.figures();
  std::printf(
      "|dT| mean %.5f (CPU %.5f), p95 %.5f (%.5f), max %.5f (%.5f); leak %.5f, dark %.5f; relMSE %.2e\n",
      f.shadow.mean, mean, f.shadow.p95, p95, f.shadow.maximum, errors.back(), f.leak, f.dark, f.relMse);
  EXPECT_NEAR(f.samples, double(errors.size()), 0.002 * double(errors.size()))
      << "steps at the edges of rays may round differently";
  EXPECT_GT(mean, 0.01) << "the map is wrong on purpose";
  EXPECT_NEAR(f.shadow.mean, mean, 2e-3 * mean);
  EXPECT_NEAR(f.shadow.p95, p95, 0.02 * p95) << "bins are 1.4 % wide";
  EXPECT_NEAR(f.shadow.maximum, errors.back(), 1e-3);
  EXPECT_NEAR(f.leak - f.dark, leakMinusDark / weights, 2e-4);
  EXPECT_GT(f.relMse, 1e-5);
  EXPECT_GT(f.radiance.maximum, f.radiance.p95);
}

TEST(Compare, FalseColoursTellTheSign) {
  const vec3 leak = truth::falseColour(0.5), dark = truth::falseColour(-0.5), none = truth::falseColour(0);
  EXPECT_GT(leak.r, leak.b);
  EXPECT_GT(dark.b, dark.r);
  EXPECT_LT(std::max({none.r, none.g, none.b}), 0.15f);
  for (double e = 0; e < 1; e += 0.01) {
    const auto light = [](vec3 c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; };
    EXPECT_LT(light(truth::falseColour(e)), light(truth::falseColour(e + 0.01)))
        << "larger is lighter: " << e;
    EXPECT_LT(light(truth::falseColour(-e)), light(truth::falseColour(-e - 0.01))) << e;
  }
}

/// Samples of the drawn error picture against the sums it was drawn from.
TEST(Compare, TheDrawnErrorIsTheMeasuredOne) {
  ShadowSpec spec;
  spec.kind = ShadowSpec::Kind::FourierOpacity;
  spec.coefficients = 3;
  spec.resolution = 64;
  const view::RenderScene scene = sceneOf(spec, {40, 30}, 1);
  truth::ComparePass pass(scene);
  finish(pass);
  truth::CompareDisplay display;
  const double scale = 0.1;
  const auto texture =
      display.draw(test::renderer().shaders(), pass, truth::CompareDisplay::Show::ShadowError, scale);
  ASSERT_TRUE(texture) << texture.error().message;
  std::vector<vec4> sums(1200), seen(1200), shown(1200);
  const auto read = [](unsigned id, std::vector<vec4>& into) {
    glGetTextureImage(id, 0, GL_RGBA, GL_FLOAT, GLsizei(into.size() * sizeof(vec4)), into.data());
  };
  read(pass.shadowError().errors().id(), sums);
  read(pass.shadowError().transmittances().id(), seen);
  read(*texture, shown);
  int leaks = 0, darks = 0;
  for (std::size_t i = 0; i < 1200; ++i) {
    if (seen[i].z < 0.05f) continue;
    const double mean = double(sums[i].x) / double(seen[i].z);
    EXPECT_NEAR(sums[i].x, seen[i].x - seen[i].y, 1e-5);
    const vec3 expected = truth::falseColour(mean / scale);
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(shown[i][c], expected[c], 0.02) << "pixel " << i;
    leaks += mean > 0.01 ? 1 : 0;
    darks += mean < -0.01 ? 1 : 0;
  }
  EXPECT_GT(leaks, 5);
  EXPECT_GT(darks, 5);
}

// The judge finds nothing in marched shadows, and what the march finds in a map that is another light's.
TEST(Compare, TheJudgeAgreesWithTheMarch) {
  ShadowSpec marched, map;
  marched.kind = ShadowSpec::Kind::RayMarch;
  double byMarch[2], byJudge[2];
  for (const bool wrong : {false, true}) {
    view::RenderScene scene = sceneOf(wrong ? map : marched, {32, 18}, 16);
    if (wrong) scene.lights[0].light.towards = glm::normalize(dvec3(-0.9, 0.4, -0.3));
    truth::ComparePass march(scene), judge(scene, truth::TruthKind::Judge);
    finish(march);
    finish(judge);
    byMarch[wrong] = march.figures().relMse, byJudge[wrong] = judge.figures().relMse;
    std::printf("  %s: judge %.3g, march %.3g\n", wrong ? "another light's map" : "marched", byJudge[wrong],
                byMarch[wrong]);
    EXPECT_EQ(judge.truth()->samples, truth::judgeSamples(scene));
  }
  EXPECT_EQ(byMarch[0], 0);
  EXPECT_LT(std::abs(byJudge[0]), 0.1 * byJudge[1]);
  EXPECT_GT(byJudge[1], 0.3 * byMarch[1]);  // measures that weigh dark pixels differently
}

// A picture of paths is compared with other paths, as many orders as it claims: nothing is wrong with it.
TEST(Compare, APictureOfPathsIsComparedAsOne) {
  ShadowSpec marched;
  marched.kind = ShadowSpec::Kind::RayMarch;
  view::RenderScene scene = sceneOf(marched, {48, 27}, 256);
  for (volume::Instance& i : scene.volumes) i.medium.albedo = vec3(0.95f);
  view::RenderScene single = scene;
  scene.bounces = -1;
  truth::ComparePass paths(scene, truth::TruthKind::Judge);
  finish(paths);
  EXPECT_NE(paths.mapped()->metadata.at("pathTrace:bounces"), "0");
  double mean = 0, all = 0;
  const image::Image a = view::readBack(*paths.mapped()).value(), b = view::readBack(*paths.truth()).value();
  for (std::size_t i = 0; i < a.layers[0].pixels.size(); i += 4)
    mean += double(a.layers[0].pixels[i]), all += double(b.layers[0].pixels[i]);
  EXPECT_NEAR(mean, all, 0.02 * all);
  truth::ComparePass one(single, truth::TruthKind::Judge);
  finish(one);
  const image::Image c = view::readBack(*one.mapped()).value();
  double once = 0;
  for (std::size_t i = 0; i < c.layers[0].pixels.size(); i += 4) once += double(c.layers[0].pixels[i]);
  EXPECT_LT(once, 0.9 * mean) << "a march holds one order alone";
}

TEST(Compare, ATruthThatGoesFirstEndsWithTheSameFigures) {
  ShadowSpec spec;
  spec.kind = ShadowSpec::Kind::FourierOpacity;
  spec.resolution = 64;
  const view::RenderScene scene = sceneOf(spec, {48, 32}, 1);
  truth::ComparePass first(scene, truth::TruthKind::Marched, truth::CompareOrder::TruthFirst),
      together(scene);
  for (int i = 0; i < 10000 && !first.truthWhole(); ++i) {
    ASSERT_FALSE(first.mapped());
    ASSERT_TRUE(first.step(test::renderer().gpu(), 0));
  }
  ASSERT_TRUE(first.truthWhole());
  finish(first);
  finish(together);
  EXPECT_TRUE(first.pictureWhole() && first.shadowWhole());
  EXPECT_EQ(first.figures().relMse, together.figures().relMse);
  EXPECT_EQ(first.figures().radiance.mean, together.figures().radiance.mean);
  EXPECT_EQ(first.figures().shadow.mean, together.figures().shadow.mean);
}

}  // namespace
}  // namespace pileus
