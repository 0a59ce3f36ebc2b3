// Transmittance of the default map where media are dense: a surface behind which everything happens within
// a small part of a texel. What counts is what a camera sees of it: the light scattered back from behind the
// face, integral of exp(-sigma z) T(z) dz, whose exact value has a closed form.
#include <cmath>

#include <fmt/core.h>

#include "nodes/shadows/shadow_inputs.h"
#include "renderer/shadow/reference.h"
#include "tests/support/lit.h"
#include "tests/support/noise_grid.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

shadow::ShadowSpec usual(int resolution) {
  shadow::ShadowSpec spec;
  spec.metric = nodes::MetricIn{}.metric;
  return shadow::withResolution(spec, resolution);
}

/// A light at `degrees` off the normal +z of the face that is looked at.
scene::Light slanted(double degrees) {
  const double a = glm::radians(degrees);
  return test::sunFrom(dvec3(std::sin(a), 0.3 * std::sin(a), std::cos(a)));
}

double cosineOf(const scene::Light& light) { return light.towards.z / glm::length(light.towards); }

struct Error {
  double radiance = 0;  ///< of what the camera sees, relative, the worst of several places
  double largest = 0;   ///< |dT|
  double mean = 0;      ///< |dT|
};

/// Behind points of the face z = 0.5 of a medium of sigma: from the map, and from the exact optical depth at
/// the very same positions. `mu0`: cosine of the light on the face.
Error behindTheFace(const shadow::ShadowMap& map, const volume::InstanceList& volumes, double sigma,
                    double mu0, double top = 0.5) {
  constexpr int kPlaces = 9, kDepths = 160;
  std::vector<vec3> at;
  std::vector<double> weight;
  for (int place = 0; place < kPlaces; ++place)
    for (int k = 0; k < kDepths; ++k) {
      // Even in the optical depth of the way in and out, up to 8, or the end of the box.
      const double most = std::min(8.0, 0.98 * sigma * (1 + 1 / mu0)), tau = (k + 0.5) / kDepths * most;
      const double z = tau / (sigma * (1 + 1 / mu0));
      at.push_back(vec3(dvec3(0.021 * (place % 3) - 0.0171, 0.017 * (place / 3) - 0.0133, top - z)));
      weight.push_back(std::exp(-sigma * z));
    }
  const std::vector<float> tau = test::lookupTau(map, map.light, at);
  Error e;
  for (int place = 0; place < kPlaces; ++place) {
    double seen = 0, truth = 0;
    for (int k = 0; k < kDepths; ++k) {
      const auto i = std::size_t(place * kDepths + k);
      const double want = std::exp(-shadow::opticalDepthToLight(volumes, map.light, dvec3(at[i])));
      const double is = std::exp(-double(tau[i]));
      seen += weight[i] * is, truth += weight[i] * want;
      e.largest = std::max(e.largest, std::abs(is - want));
      e.mean += std::abs(is - want) / (kPlaces * kDepths);
    }
    e.radiance = std::max(e.radiance, std::abs(seen / truth - 1));
  }
  return e;
}

void expectRight(const std::string& what, const volume::InstanceList& volumes, const scene::Light& light,
                 double sigma, int resolution, double bound = 0.01) {
  const auto map = test::build(usual(resolution), volumes, light);
  const Error e = behindTheFace(*map, volumes, sigma, cosineOf(light));
  std::printf("%s, sigma %g: radiance %.5f, |dT| mean %.6f, largest %.5f\n", what.c_str(), sigma, e.radiance,
              e.mean, e.largest);
  EXPECT_LT(e.radiance, bound) << what << ", sigma " << sigma;
}

volume::Instance gridBox(double sigma) {
  static const volume::GridPtr grid = test::gridOf(66, [](ivec3 p) {
    return glm::all(glm::greaterThanEqual(p, ivec3(1))) && glm::all(glm::lessThan(p, ivec3(65))) ? 1.0f
                                                                                                 : 0.0f;
  });
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = grid;
  // Voxels 1 .. 64 are full: their middles span 63/64 m, and half a voxel of ramp reaches beyond.
  i.worldFromLocal = glm::scale(dmat4(1.0), dvec3(1.0 / 64)) * glm::translate(dmat4(1.0), dvec3(-32.5));
  i.medium.extinction = sigma;
  return i;
}

constexpr double kAngles[] = {0, 60, 85};
constexpr double kSigmas[] = {1, 30, 1e3, 1e4};

TEST(DenseMaps, BoxBehindItsFace) {
  for (const double degrees : kAngles)
    for (const double sigma : kSigmas)
      expectRight(fmt::format("box, sun at {:g}", degrees), {test::box(dvec3(0), dvec3(1), sigma)},
                  slanted(degrees), sigma, 256);
}

TEST(DenseMaps, BoxAtTheDefaultResolution) {
  expectRight("box, sun at 85, 1024 texels", {test::box(dvec3(0), dvec3(1), 1e4)}, slanted(85), 1e4, 1024);
}

TEST(DenseMaps, ThinBoxInFront) {
  for (const double degrees : {0.0, 85.0})
    for (const double sigma : {1.0, 100.0, 1e4})
      expectRight(fmt::format("behind a thin box, sun at {:g}", degrees),
                  {test::box(dvec3(0), dvec3(1), sigma), test::box({0, 0, 0.8}, {4, 4, 0.01}, 10)},
                  slanted(degrees), sigma, 256);
}

TEST(DenseMaps, SecondBoxFarBehind) {
  // The map spans them both: at 60 degrees a texel is 9 cm wide.
  for (const double degrees : {0.0, 60.0})
    for (const double sigma : {1.0, 100.0, 1e4})
      expectRight(fmt::format("another box 100 m behind, sun at {:g}", degrees),
                  {test::box(dvec3(0), dvec3(1), sigma), test::box({0, 0, -100}, dvec3(1), sigma)},
                  slanted(degrees), sigma, degrees > 0 ? 1024 : 256);
}

TEST(DenseMaps, GridWhoseBorderRampsOverAVoxel) {
  for (const double degrees : kAngles)
    for (const double sigma : {10.0, 100.0, 1e4}) {
      const volume::InstanceList volumes{gridBox(sigma)};
      const auto light = slanted(degrees);
      const auto map = test::build(usual(256), volumes, light);
      // The medium begins at z = 0.5 + 1/128 and is full half a voxel behind the face; depths are by what a
      // ramp holds: 160 steps of up to 8 on the way in and out.
      const double mu0 = cosineOf(light), perMetre = sigma * (1 + 1 / mu0), voxel = 1.0 / 64;
      std::vector<vec3> at;
      std::vector<double> weight;
      for (int k = 0; k < 160; ++k) {
        const double tau = (k + 0.5) / 160 * std::min(8.0, 0.9 * perMetre), ramp = 0.5 * perMetre * voxel;
        const double z = tau < ramp ? std::sqrt(2 * tau * voxel / perMetre) : voxel + (tau - ramp) / perMetre;
        at.push_back(vec3(dvec3(0.0117, -0.0093, 0.5 + 0.5 * voxel - z)));
        // Of equal steps in tau: exp(-tau of the way out) times what scatters there is 1 for all of them.
        weight.push_back(std::exp(-tau / (1 + 1 / mu0)));
      }
      const std::vector<float> tau = test::lookupTau(*map, light, at);
      double seen = 0, truth = 0;
      for (std::size_t i = 0; i < at.size(); ++i) {
        seen += weight[i] * std::exp(-double(tau[i]));
        truth += weight[i] * std::exp(-shadow::opticalDepthToLight(volumes, light, dvec3(at[i])));
      }
      std::printf("grid, sun at %g, sigma %g: radiance %.5f\n", degrees, sigma, seen / truth - 1);
      // Not dense yet, at 10 / m the ramp is a fortieth of the part in front of the horizon, which is less
      // than eight cosines resolve.
      EXPECT_NEAR(seen / truth, 1, sigma > 10 ? 0.01 : 0.015) << degrees << " degrees, sigma " << sigma;
    }
}

TEST(DenseMaps, PointAndSpotLights) {
  // Here distance is no linear function of a texel's place: between texels it bends by r (texel / r)^2 / 8.
  for (const double sigma : {10.0, 1e3, 1e4}) {
    const volume::InstanceList volumes{test::box(dvec3(0), dvec3(1), sigma)};
    for (const bool spot : {false, true}) {
      const scene::Light light =
          spot ? test::spotAt({1, 0.3, 2}, {0, 0, 0.5}, 40) : test::pointAt({1, 0.3, 2});
      const auto map = test::build(usual(512), volumes, light);
      const Error e =
          behindTheFace(*map, volumes, sigma, 1.5 / glm::length(light.position - dvec3(0, 0, 0.5)));
      std::printf("%s, sigma %g: radiance %.5f, |dT| mean %.6f, largest %.5f\n", spot ? "spot" : "point",
                  sigma, e.radiance, e.mean, e.largest);
      EXPECT_LT(e.radiance, sigma > 5e3 ? 0.04 : 0.01) << spot << ", sigma " << sigma;
    }
  }
}

TEST(DenseMaps, AnySize) {
  // The same picture a millionth and a million times as large. Where the plate in front ends 8 cosines ring.
  std::vector<double> first;
  for (const double size : {1.0, 1e-6, 1e6}) {
    const volume::InstanceList volumes{test::box(dvec3(0), dvec3(size), 100 / size),
                                       test::box({0, 0, 0.8 * size}, dvec3(2, 2, 0.01) * size, 10 / size)};
    const auto light = slanted(60);
    const auto map = test::build(usual(128), volumes, light);
    std::vector<vec3> at;
    for (int k = 0; k < 60; ++k) at.push_back(vec3(dvec3(0.0117, -0.0093, 0.5 - k / 60.0 * 5 / 200) * size));
    std::vector<double> is;
    for (const float tau : test::lookupTau(*map, light, at)) is.push_back(std::exp(-double(tau)));
    for (std::size_t i = 0; i < at.size(); ++i) {
      EXPECT_NEAR(is[i], std::exp(-shadow::opticalDepthToLight(volumes, light, dvec3(at[i]))), 0.08) << size;
      EXPECT_NEAR(is[i], first.empty() ? is[i] : first[i], 2e-3) << size;
    }
    first = is;
  }
}

TEST(DenseMaps, SilhouettesOfDenseMediaDoNotLeak) {
  // A slanted face is one surface; the edge of a plate over another is two, however dense.
  const volume::InstanceList volumes{test::box({-0.5, 0, 0.6}, {1, 2, 0.05}, 1e4),
                                     test::box({0, 0, -0.5}, {2, 2, 0.5}, 3)};
  const auto light = slanted(20);
  const auto map = test::build(usual(256), volumes, light);
  std::vector<vec3> at;
  for (int i = 0; i < 2000; ++i)
    at.push_back(vec3(dvec3(-0.5 + i / 2000.0, 0.013, -0.3 - 0.4 * ((i * 7) % 11) / 11.0)));
  const std::vector<float> tau = test::lookupTau(*map, light, at);
  int wrong = 0;
  double outside = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double want = std::exp(-shadow::opticalDepthToLight(volumes, light, dvec3(at[i]))),
                 is = std::exp(-double(tau[i]));
    // Within a texel of the edge anything between lit and dark is right.
    if (std::abs(is - want) > 0.02) ++wrong, outside = std::max(outside, std::abs(is - want));
  }
  std::printf("plate over a box: %d of %zu off by more than 0.02, at most %.3f\n", wrong, at.size(), outside);
  EXPECT_LT(wrong, 60);
}

}  // namespace
}  // namespace pileus
