// Point and spot lights by every shadow representation: exact answers in and beside boxes, cube seams, C++
// twins.
#include <cmath>
#include <random>

#include "renderer/shadow/reference.h"
#include "tests/support/lit.h"

namespace pileus {
namespace {

using Kind = shadow::ShadowSpec::Kind;

shadow::ShadowSpec specOf(Kind kind, int resolution = 128) {
  shadow::ShadowSpec spec;
  spec.kind = kind;
  spec.range = kind == Kind::FourierOpacity;
  spec.storage = shadow::Storage::Float;
  spec.coefficients = 15;
  spec.basis = kind == Kind::TransmittanceFunction ? shadow::Basis::Cosine : shadow::Basis::Fourier;
  return shadow::withResolution(spec, resolution);
}

/// Largest |dT| allowed: where a series is exact, where transmittance itself is cut at 15 cosines, where
/// compression may err by 0.01.
double bound(Kind kind, double exact, double series, double deep = 0.0115) {
  switch (kind) {
    case Kind::RayMarch:
      return 3e-6;
    case Kind::Extinction:
    case Kind::FourierOpacity:
      return exact;
    case Kind::TransmittanceFunction:
      return series;
    case Kind::Deep:
      break;
  }
  return deep;
}

constexpr Kind kKinds[] = {Kind::RayMarch, Kind::Extinction, Kind::FourierOpacity,
                           Kind::TransmittanceFunction, Kind::Deep};

std::vector<dvec3> directions(int count, unsigned seed) {
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> n;
  std::vector<dvec3> out;
  for (int i = 0; i < count; ++i) out.push_back(glm::normalize(dvec3(n(rng), n(rng), n(rng))));
  return out;
}

struct Error {
  double mean = 0, worst = 0;
  dvec3 where{0};
};

/// |dT| of the GPU's shadow against the double-precision reference.
Error errorOf(const shadow::ShadowedLight& light, const volume::InstanceList& volumes,
              const std::vector<dvec3>& points) {
  const std::vector<test::Lit> lit = test::lit(light, points);
  Error e;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = std::abs(lit[i].transmittance -
                              std::exp(-shadow::opticalDepthToLight(volumes, light.light, points[i])));
    e.mean += d / double(points.size());
    if (d > e.worst) e.worst = d, e.where = points[i];
  }
  return e;
}

void print(const char* what, Kind kind, const Error& e) {
  std::printf("%s, %s: mean |dT| %.7f, max %.7f at %.3f %.3f %.3f\n", what,
              shadow::describe(specOf(kind)).c_str(), e.mean, e.worst, e.where.x, e.where.y, e.where.z);
}

TEST(Lights, IncidenceIsThatOfTheCpu) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 60; ++i) {
    scene::Light light;
    light.kind = scene::LightKind(i % 3);
    light.emitted = vec3(3, 2, 1);
    light.position = {5 * u(rng), 5 * u(rng), 5 * u(rng)};
    light.towards = glm::normalize(dvec3(u(rng), u(rng), u(rng)));
    light.radius = i % 2 ? 0.5 : 0.001;
    light.cone = 90 + 80 * u(rng);
    light.softness = i % 5 == 0 ? 0 : 0.5 + 0.5 * u(rng);
    std::vector<dvec3> points{light.position};
    for (int k = 0; k < 100; ++k)
      points.push_back(dvec3(vec3(light.position + dvec3(3 * u(rng), 3 * u(rng), 3 * u(rng)))));
    const auto lit = test::lit({light, nullptr}, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const scene::Incidence want = scene::incidence(light, points[k]);
      const bool sun = light.kind == scene::LightKind::Sun;
      // At the light itself only rounding decides where it lies.
      if (k > 0) {
        EXPECT_LT(glm::length(lit[k].towards - want.towards), 2e-5 / std::min(1.0, want.distance))
            << i << " " << k;
      }
      if (!sun) {
        EXPECT_NEAR(lit[k].distance, want.distance, 2e-6) << i << " " << k;
      }
      // A hard edge is wherever rounding of the cosine puts it.
      const double away =
          std::abs(glm::dot(want.towards, light.towards) - std::cos(glm::radians(light.cone) / 2));
      if (light.kind == scene::LightKind::Spot && (light.softness == 0 || k == 0) && away < 1e-4) continue;
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(lit[k].irradiance[c] / (want.falloff * double(light.emitted[c]) + 1e-9),
                    want.falloff > 0 ? 1 : 0, k > 0 ? 1e-3 : 2)
            << i << " " << k;
      EXPECT_EQ(lit[k].transmittance, 1);
      EXPECT_EQ(lit[k].arriving, lit[k].irradiance);
    }
  }
}

TEST(Lights, PointInsideABoxIsExponentialInEveryDirection) {
  const double sigma = 0.7;
  const volume::InstanceList volumes{test::box({0.3, -0.2, 0.1}, {4, 4, 4}, sigma)};
  const scene::Light light = test::pointAt({0.5, 0.1, -0.3});
  std::vector<dvec3> points;
  for (const dvec3& d : directions(1500, 11))
    points.push_back(light.position + (0.02 + 1.4 * double(points.size()) / 1500) * d);
  for (const Kind kind : kKinds) {
    const shadow::ShadowedLight map = test::shadowed(light, specOf(kind), volumes);
    const auto lit = test::lit(map, points);
    double worst = 0, mean = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d =
          std::abs(lit[i].transmittance - std::exp(-sigma * glm::length(points[i] - light.position)));
      worst = std::max(worst, d), mean += d / double(points.size());
    }
    std::printf("point in a box, %s: mean |dT| %.7f, max %.7f\n", shadow::describe(specOf(kind)).c_str(),
                mean, worst);
    EXPECT_LT(worst, bound(kind, 3e-6, 0.035)) << shadow::describe(specOf(kind));
  }
}

TEST(Lights, WhatLiesBehindAPointLightCastsNoShadow) {
  const volume::InstanceList volumes{test::box({-3, 0, 0}, {1, 1, 1}, 5),
                                     test::box({3, 0, 0}, {1, 1, 1}, 0.5)};
  const scene::Light light = test::pointAt({0, 0, 0});
  const std::vector<dvec3> points{{2.6, 0, 0}, {3.4, 0.1, 0.2}, {5, 0, 0}, {1, 0, 0}};
  for (const Kind kind : kKinds) {
    const Error e = errorOf(test::shadowed(light, specOf(kind), volumes), volumes, points);
    print("between two boxes", kind, e);
    EXPECT_LT(e.worst, bound(kind, 2e-4, 2e-3));
  }
}

TEST(Lights, PointBetweenTwoClouds) {
  const volume::InstanceList volumes{test::ball({-2, 0.2, 0}, 1.2, 1.1),
                                     test::ball({2.2, -0.3, 0.4}, 1.0, 0.6),
                                     test::ball({0.2, 2.0, 0.1}, 0.8, 2.0)};
  const scene::Light light = test::pointAt({0.1, 0, 0.05});
  std::vector<dvec3> points;
  for (const dvec3& d : directions(1200, 12)) {
    const volume::Instance& v = volumes[points.size() % 3];
    points.push_back(dvec3(v.worldFromLocal * dvec4(0.9 * std::cbrt(double(points.size()) / 1200) * d, 1)));
  }
  for (const Kind kind : kKinds) {
    const Error e = errorOf(test::shadowed(light, specOf(kind), volumes), volumes, points);
    print("between clouds", kind, e);
    EXPECT_LT(e.worst, bound(kind, 3e-3, 0.025));
    EXPECT_LT(e.mean, bound(kind, 2e-4, 3e-3, 8e-3));
  }
}

TEST(Lights, SpotGrazingABox) {
  // A millimetre off the face y = 0.5 and parallel to it: most light rays meet the box at a glancing angle or
  // not at all.
  const volume::InstanceList volumes{test::box({0, 0, 0}, {4, 1, 2}, 1.5)};
  const scene::Light light = test::spotAt({-4, 0.501, 0}, {0, 0.501, 0}, 50);
  std::mt19937_64 rng(9);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<dvec3> points;
  for (int i = 0; i < 1500; ++i)
    points.push_back({-1.9 + 3.8 * u(rng), 0.49 - 0.5 * u(rng) * u(rng), 0.8 * (u(rng) - 0.5)});
  for (const Kind kind : kKinds) {
    const Error e = errorOf(test::shadowed(light, specOf(kind, 256), volumes), volumes, points);
    print("grazing spot", kind, e);
    EXPECT_LT(e.worst, bound(kind, 5e-5, 0.04, 0.015));
    EXPECT_LT(e.mean, bound(kind, 5e-6, 6e-3, 8e-3));
  }
}

TEST(Lights, CubeFacesMeetWithoutASeam) {
  const volume::InstanceList volumes{test::ball({1.5, 1.5, 0.2}, 1.0, 0.8),
                                     test::ball({-1.4, 0.3, -1.5}, 0.9, 1.2),
                                     test::ball({0.1, -1.6, 1.5}, 1.1, 0.9)};
  const scene::Light light = test::pointAt({0.05, -0.02, 0.03});
  // Pairs of points on both sides of the twelve edges, as near as floats allow to tell them apart.
  std::mt19937_64 rng(21);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<dvec3> points;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 400; ++i) {
      const double a = i & 1 ? 1 : -1, b = i & 2 ? 1 : -1, along = u(rng), r = 1.2 + 1.2 * std::abs(u(rng));
      for (const double off : {1e-4, -1e-4}) {
        dvec3 q;
        q[axis] = along, q[(axis + 1) % 3] = a * (1 + off), q[(axis + 2) % 3] = b * (1 - off);
        points.push_back(light.position + r * glm::normalize(q));
      }
    }
  for (const Kind kind : kKinds) {
    const auto lit = test::lit(test::shadowed(light, specOf(kind), volumes), points);
    double worst = 0;
    int shadowed = 0;
    for (std::size_t i = 0; i < points.size(); i += 2) {
      worst = std::max(worst, std::abs(lit[i].transmittance - lit[i + 1].transmittance));
      shadowed += lit[i].transmittance < 0.95;
    }
    std::printf("seams, %s: max |dT| across an edge %.6f, %d of %zu pairs in shadow\n",
                shadow::describe(specOf(kind)).c_str(), worst, shadowed, points.size() / 2);
    EXPECT_GT(shadowed, 150);
    EXPECT_LT(worst, kind == Kind::RayMarch ? 3e-4 : 3e-3) << shadow::describe(specOf(kind));
  }
}

}  // namespace
}  // namespace pileus
