// Black bodies against what is tabulated of them, and against the colours lights have.
#include "renderer/scene/black_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/scene/light.h"

namespace pileus::scene {
namespace {

dvec2 xy(double kelvin) {
  const dvec3 c = blackBodyXyz(kelvin);
  return dvec2(c) / (c.x + c.y + c.z);
}

TEST(BlackBody, ChromaticitiesAreThoseOfThePlanckianLocus) {
  const std::pair<double, dvec2> known[] = {
      {1000, {0.6528, 0.3444}}, {1500, {0.5857, 0.3931}}, {2000, {0.5267, 0.4133}}, {2856, {0.4476, 0.4074}},
      {5000, {0.3451, 0.3516}}, {6500, {0.3135, 0.3237}}, {10000, {0.2807, 0.2884}}};
  for (const auto& [kelvin, want] : known) {
    const double close = kelvin < 1500 ? 0.012 : 0.005;  // the fits' own error in the far red
    EXPECT_NEAR(xy(kelvin).x, want.x, close) << kelvin;
    EXPECT_NEAR(xy(kelvin).y, want.y, close) << kelvin;
  }
}

TEST(BlackBody, RadianceIsThatOfPlanck) {
  // The candela once was this: a black body at the freezing point of platinum has 60 cd/cm^2.
  EXPECT_NEAR(683 * blackBodyXyz(2041.4).y, 6e5, 0.02 * 6e5);
  // In the far blue tail of cool bodies luminance goes as exp(-h c / (lambda k T)) at some wavelength seen.
  const double slope = std::log(blackBodyXyz(2000).y / blackBodyXyz(1000).y) / (1 / 1000.0 - 1 / 2000.0);
  EXPECT_GT(slope, 1.4388e-2 / 700e-9);
  EXPECT_LT(slope, 1.4388e-2 / 555e-9);
}

TEST(BlackBody, ColoursAreThoseOfLights) {
  for (const double kelvin : {1800.0, 2500.0, 4000.0, 6500.0, 12000.0}) {
    const dvec3 color = blackBodyColor(kelvin, kelvin), light(temperatureColor(kelvin));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], light[c], 0.03 * std::max(light[c], 0.3)) << kelvin;
  }
  const dvec3 white = blackBodyColor(6500, 6500);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1, 1e-9);
}

TEST(BlackBody, RisesSteeplyAndStaysFinite) {
  double before = 0;
  for (double kelvin = 500; kelvin <= 20000; kelvin *= 1.05) {
    const dvec3 c = blackBodyColor(kelvin, 2200);
    const double luminance = glm::dot(c, dvec3(0.2722287168, 0.6740817658, 0.0536895174));
    EXPECT_TRUE(std::isfinite(luminance));
    EXPECT_GT(luminance, before) << kelvin;
    EXPECT_GE(std::min({c.r, c.g, c.b}), 0) << kelvin;
    before = luminance;
  }
  const dvec3 ember = blackBodyColor(1000, 1000);
  EXPECT_GT(ember.r, 4 * ember.g) << "red";
  EXPECT_LT(blackBodyXyz(1000).y / blackBodyXyz(2200).y, 1e-4);
}

}  // namespace
}  // namespace pileus::scene
