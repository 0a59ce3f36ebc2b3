// Lights on the CPU: what arrives of them, and the suns a soft one is split into.
#include "renderer/scene/light.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pileus::scene {
namespace {

TEST(Incidence, OfASunIsTheSameEverywhere) {
  Light sun;
  sun.towards = sunDirection(40, 25);
  for (const dvec3& p : {dvec3(0), dvec3(1e5, -3, 7)}) {
    const Incidence i = incidence(sun, p);
    EXPECT_EQ(i.towards, sun.towards);
    EXPECT_EQ(i.falloff, 1);
    EXPECT_TRUE(std::isinf(i.distance));
  }
}

TEST(Incidence, OfAPointFallsWithTheSquareAndStopsAtItsRadius) {
  Light lamp;
  lamp.kind = LightKind::Point;
  lamp.position = {1, 2, 3};
  lamp.radius = 0.25;
  for (const double r : {0.25, 0.5, 3.0, 100.0}) {
    const Incidence i = incidence(lamp, lamp.position + r * glm::normalize(dvec3(1, -2, 2)));
    EXPECT_NEAR(i.distance, r, 1e-12 * r);
    EXPECT_NEAR(i.falloff * r * r, 1, 1e-12);
    EXPECT_NEAR(glm::length(i.towards - glm::normalize(dvec3(-1, 2, -2))), 0, 1e-13);
  }
  EXPECT_NEAR(incidence(lamp, lamp.position + dvec3(0.1, 0, 0)).falloff, 16, 1e-12);
  const Incidence at = incidence(lamp, lamp.position);
  EXPECT_EQ(at.falloff, 16);
  EXPECT_NEAR(glm::length(at.towards), 1, 1e-12);
}

TEST(Incidence, OfASpotFadesFromTheInnerToTheOuterCone) {
  Light spot;
  spot.kind = LightKind::Spot;
  spot.position = {0, 10, 0};
  spot.towards = {0, 1, 0};
  spot.cone = 60;
  spot.softness = 0.5;
  const auto atAngle = [&](double degrees) {
    const double a = glm::radians(degrees);
    return incidence(spot, spot.position + 4.0 * dvec3(std::sin(a), -std::cos(a), 0)).falloff * 16;
  };
  EXPECT_NEAR(atAngle(0), 1, 1e-12);
  EXPECT_NEAR(atAngle(14.99), 1, 1e-12);
  EXPECT_EQ(atAngle(30.01), 0);
  EXPECT_EQ(atAngle(180), 0);
  const double half = (std::cos(glm::radians(15.0)) + std::cos(glm::radians(30.0))) / 2;
  EXPECT_NEAR(atAngle(glm::degrees(std::acos(half))), 0.5, 1e-12);
  spot.softness = 0;
  EXPECT_NEAR(atAngle(29.99), 1, 1e-12);
  EXPECT_EQ(atAngle(30.01), 0);
}

TEST(SplitDisc, PartsShareTheLightAndLieEvenlyInTheDisc) {
  Light sun;
  sun.emitted = {9, 8, 7};
  for (const double angle : {0.53, 10.0, 60.0})
    for (const dvec3& axis : {sunDirection(30, 40), dvec3(0, 1, 0), dvec3(1, 0, 0)})
      for (const int count : {2, 8, 32}) {
        sun.angle = angle;
        sun.towards = axis;
        const std::vector<Light> parts = splitDisc(sun, count);
        ASSERT_EQ(parts.size(), std::size_t(count));
        dvec3 mean(0);
        double squares = 0;
        const double edge = std::sin(glm::radians(angle) / 2);
        for (const Light& part : parts) {
          EXPECT_EQ(part.emitted, sun.emitted / float(count));
          EXPECT_NEAR(glm::length(part.towards), 1, 1e-12);
          const double off = glm::length(glm::cross(axis, part.towards)) / edge;
          EXPECT_LT(off, 1);
          EXPECT_GT(glm::dot(axis, part.towards), 0);
          squares += off * off / count;
          mean += part.towards / double(count);
        }
        // Of a uniform disc the mean square of the distance from its centre is half that of its edge.
        EXPECT_NEAR(squares, 0.5, 1e-9) << angle << " " << count;
        const double offset = glm::length(glm::cross(axis, glm::normalize(mean))) / edge;
        EXPECT_LT(offset, count == 2 ? 0.33 : count == 8 ? 0.065 : 0.02) << angle << " " << count;
        if (axis.y == 1)
          std::printf("angle %.2f, %d parts: the mean is off the middle by %.4f of the radius\n", angle,
                      count, offset);
      }
}

TEST(SplitDisc, LeavesAloneWhatHasNoDisc) {
  Light sun;
  EXPECT_EQ(splitDisc(sun, 8), std::vector<Light>{sun});
  sun.angle = 3;
  EXPECT_EQ(splitDisc(sun, 1), std::vector<Light>{sun});
  sun.kind = LightKind::Point;
  EXPECT_EQ(splitDisc(sun, 8), std::vector<Light>{sun});
}

}  // namespace
}  // namespace pileus::scene
