// What the curve of defaults is made of: points as a camera meets them, its front, its picture.
#include <gtest/gtest.h>

#include <cmath>

#include "editor/cli/curve/plot.h"
#include "tests/support/support.h"

namespace pileus::cli {
namespace {

/// A box of one metre, sigma_t 4, looked at along -Z, the sun behind the camera.
view::RenderScene boxScene() {
  view::RenderScene scene;
  volume::Instance box;
  box.shape = volume::Shape::Box;
  box.medium.extinction = 4;
  scene.volumes = {box};
  scene::Light sun;
  sun.towards = dvec3(0, 0, 1);
  scene.lights = {{sun, nullptr}};
  scene.options.camera = {{0, 0, 50}, {0, 0, 0}, {0, 1, 0}, 0.1};
  scene.options.size = ivec2(64, 64);
  return scene;
}

TEST(Curve, PointsLieAsCameraRaysScatter) {
  const truth::ShadowSamples seen = seenSamples(boxScene(), 20000, 3);
  ASSERT_EQ(seen.positions.size(), 20000u);
  double mean = 0;
  for (std::size_t i = 0; i < seen.positions.size(); ++i) {
    const double depth = 0.5 - double(seen.positions[i].z);
    ASSERT_NEAR(seen.transmittance[i], std::exp(-4 * depth), 1e-5) << "as deep for the sun as for the eye";
    mean += seen.transmittance[i] / 20000;
  }
  // Depths have the density sigma exp(-sigma d) / (1 - exp(-sigma)); the standard error is 0.002.
  EXPECT_NEAR(mean, 0.5 * (1 - std::exp(-8.0)) / (1 - std::exp(-4.0)), 0.008);
  EXPECT_EQ(seenSamples(boxScene(), 20000, 3).positions, seen.positions);
}

TEST(Curve, NothingIsSeenBesideTheMedia) {
  view::RenderScene scene = boxScene();
  scene.options.camera.eye = {0, 30, 50};
  scene.options.camera.target = {0, 30, 0};
  EXPECT_TRUE(seenSamples(scene, 100, 1).positions.empty());
}

TEST(Curve, RelativeRmsIsOverWhatTheReferenceCovers) {
  const auto image = [](std::vector<float> pixels) {
    image::Image out;
    out.size = ivec2(int(pixels.size() / 4), 1);
    out.layers = {{"", 4, std::move(pixels)}};
    return out;
  };
  const image::Image b = image({1, 2, 3, 1, 4, 4, 4, 0.5f, 9, 9, 9, 0.01f}),
                     a = image({2, 2, 3, 1, 4, 4, 2, 0.5f, 0, 0, 0, 0});
  // Squares sum up to 5 over six values with a sum of 18.
  EXPECT_NEAR(relativeRms(a, b), std::sqrt(5.0 / 6) / (18.0 / 6), 1e-7);
  EXPECT_EQ(relativeRms(b, b), 0);
  EXPECT_EQ(relativeRms(image({1, 1, 1, 1}), image({0, 0, 0, 0})), 0);
}

TEST(Curve, TheFrontHoldsWhatNoneBeatsInBoth) {
  EXPECT_EQ(paretoFront({{4, 1}, {1, 5}, {2, 5}, {2, 3}, {3, 3}, {5, 2}}),
            (std::vector<std::size_t>{1, 3, 0}));
  EXPECT_EQ(paretoFront({{1, 1}, {1, 1}}).size(), 1u);
  EXPECT_TRUE(paretoFront({}).empty());
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Curve, ThePlotShowsEveryMapInEveryScene) {
  std::vector<CurveRow> rows(3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].name = "map " + std::to_string(i);
    for (const double scale : {1.0, 2.0}) {
      CurveMeasure m;
      m.radiance = 0.06 * scale / double(i + 1);
      m.scattered = 2 * m.radiance;
      m.bytes = (i + 1) << 20;
      m.mapMs = 100 * double(i + 1), m.pictureMs = 300;
      rows[i].measures.push_back(m);
    }
  }
  rows[0].before = rows[2].present = true;
  const std::string svg = curvePlot({"smoke", "clouds"}, rows);
  EXPECT_TRUE(svg.starts_with("<svg ")) << svg.substr(0, 80);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  constexpr std::size_t kPanels = 2 * 3;
  for (const char* name : {"map 0: ", "map 1: ", "map 2: "}) EXPECT_EQ(countOf(svg, name), kPanels) << name;
  EXPECT_EQ(countOf(svg, ">smoke</text>") + countOf(svg, ": smoke</text>"), kPanels / 2);
  EXPECT_EQ(countOf(svg, ">clouds</text>"), kPanels / 2);
  // Both defaults are marked in each, and once in the legend.
  EXPECT_EQ(countOf(svg, "fill=\"#c8372d\""), kPanels + 1);
  EXPECT_EQ(countOf(svg, "fill=\"#1d8a4a\""), kPanels + 1);
  for (const char* bad : {"nan", "inf"}) EXPECT_EQ(countOf(svg, bad), 0u) << bad;
}

}  // namespace
}  // namespace pileus::cli
