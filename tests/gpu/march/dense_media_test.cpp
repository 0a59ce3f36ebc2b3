// Boxes of any extinction against the closed form of single scattering in a slab, and against quadrature.
#include <fmt/format.h>

#include <cmath>

#include "editor/cli/bench_scenes.h"
#include "tests/support/exact_scattering.h"
#include "tests/support/noise_grid.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

using shadow::ShadowSpec;

constexpr double kWide = 60;  // metres, far more than light travels sideways at 85 degrees
constexpr double kSigmas[] = {1, 10, 100, 1000, 1e4};
constexpr double kOff[] = {0, 60, 85};  // degrees off the normal of the face that is looked at
const dvec3 kEye(0, 0, 2.5);            // near: in floats a place ten metres away is known to a micrometre

volume::Instance slab(double sigma, double z = 0) { return test::box({0, 0, z}, {kWide, kWide, 1}, sigma); }

/// The same as voxels of an eighth of a metre; densities rise over one voxel at its faces.
volume::Instance gridSlab(double sigma) {
  static const volume::GridPtr grid = [] {
    volume::VoxelSource source;
    source.name = "slab";
    source.activeMin = ivec3(0);
    source.activeMax = ivec3(int(kWide) * 8 - 1, int(kWide) * 8 - 1, 7);
    source.fill = [](ivec3, float* out) {
      std::fill(out, out + volume::kStoredVoxels, 1.0f);
      return volume::Fill::Voxels;
    };
    JobControl control;
    return volume::buildBricks(source, control).value().grid;
  }();
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = grid;
  i.worldFromLocal =
      glm::scale(dmat4(1.0), dvec3(1.0 / 8)) * glm::translate(dmat4(1.0), dvec3(-239.5, -239.5, -3.5));
  i.medium.extinction = sigma;
  return i;
}

scene::Light sunOff(double degrees) {
  const double a = glm::radians(degrees);
  return test::sunFrom({std::sin(a) * 0.8, std::sin(a) * 0.6, std::cos(a)});
}

/// Of any profile that is the same across, in units of E.
double slabRadiance(double tau, double mu, double mu0) {
  return mu0 / (mu0 + mu) * -std::expm1(-tau * (1 / mu + 1 / mu0)) / (4 * kPi);
}

ShadowSpec marched() {
  ShadowSpec s;
  s.kind = ShadowSpec::Kind::RayMarch;
  return s;
}
ShadowSpec defaultMap(int resolution = 128) { return test::improved(4, 8, resolution); }

view::RenderScene sceneOf(const volume::InstanceList& volumes, const shadow::ShadowedLight& light) {
  view::RenderScene scene;
  scene.volumes = volumes;
  scene.lights = {light};
  return scene;
}

/// 1 %, but for maps of 128 texels under light that grazes what is dense: there a float's step across the map
/// is some tenths of optical depth along the light.
double allowed(const ShadowSpec& spec, double sigma, double off, bool grid) {
  if (spec.kind == ShadowSpec::Kind::RayMarch) return 0.01;
  if (off > 80) return grid ? (sigma >= 100 ? 0.045 : 0.01) : sigma >= 1e4 ? 0.1 : 0.01;
  return sigma >= 1e4 ? 0.015 : 0.01;
}

void compareSlab(const char* table, const std::function<volume::Instance(double)>& make,
                 const ShadowSpec& spec) {
  test::renderer();
  test::Rows rows(table);
  for (const double sigma : kSigmas)
    for (const double off : kOff) {
      const volume::InstanceList volumes{make(sigma)};
      const scene::Light sun = sunOff(off);
      const double tau = shadow::opticalDepth(volumes, kEye, -kEye);
      const double right = slabRadiance(tau, 1, std::cos(glm::radians(off)));
      const auto light = test::shadowed(sun, spec, volumes);
      for (const double step : {0.5, 1.0, 4.0})
        for (const int samples : {1, 16}) {
          const dvec4 seen = test::onTheAxis(sceneOf(volumes, light), kEye, dvec3(0), samples, step);
          const std::string what =
              fmt::format("sigma {}, sun {} degrees off, step {}, {} samples", sigma, off, step, samples);
          rows.check(what, seen.x, right, allowed(spec, sigma, off, volumes[0].shape == volume::Shape::Grid));
          rows.check(what + ", alpha", seen.w, -std::expm1(-tau), 0, 2e-3);
        }
    }
}

TEST(DenseMedia, TheQuadratureAgreesWithTheClosedForm) {
  test::Rows rows("quadrature");
  for (const double sigma : kSigmas)
    for (const double off : kOff)
      for (const bool grid : {false, true}) {
        const volume::InstanceList volumes{grid ? gridSlab(sigma) : slab(sigma)};
        const double tau = shadow::opticalDepth(volumes, kEye, -kEye);
        const test::Exact exact =
            test::exactAlong(volumes, {test::exactly(volumes, sunOff(off))}, kEye, {0, 0, -1});
        // At sigma 1 and 85 degrees light that reaches the far side is that of a wide box still: 11.5 m.
        rows.check(fmt::format("sigma {}, sun {} degrees off, grid {}", sigma, off, grid), exact.radiance.x,
                   slabRadiance(tau, 1, std::cos(glm::radians(off))), 1e-3);
      }
}

TEST(DenseMedia, BoxUnderMarchedShadows) {
  compareSlab(
      "box, marched shadows", [](double s) { return slab(s); }, marched());
}
TEST(DenseMedia, BoxUnderTheDefaultMap) {
  compareSlab(
      "box, default map", [](double s) { return slab(s); }, defaultMap());
}
TEST(DenseMedia, GridUnderMarchedShadows) { compareSlab("grid, marched shadows", gridSlab, marched()); }
TEST(DenseMedia, GridUnderTheDefaultMap) { compareSlab("grid, default map", gridSlab, defaultMap()); }

/// A metre across as well, under the map that nodes begin with. The quadrature knows the light from the
/// sides.
TEST(DenseMedia, ACubeOfAMetreUnderTheMapNodesBeginWith) {
  test::renderer();
  test::Rows rows("cube of a metre");
  ShadowSpec spec = test::improved(4, 32, 384);
  spec.extinction.storage = shadow::Storage::Half;
  for (const double sigma : kSigmas)
    for (const double off : kOff) {
      const volume::InstanceList volumes{test::box({0, 0, 0}, {1, 1, 1}, sigma)};
      const scene::Light sun = sunOff(off);
      const double right =
          test::exactAlong(volumes, {test::exactly(volumes, sun)}, kEye, {0, 0, -1}).radiance.x;
      const auto light = test::shadowed(sun, spec, volumes);
      for (const double step : {1.0, 4.0})
        for (const int samples : {1, 16})
          rows.check(
              fmt::format("sigma {}, sun {} degrees off, step {}, {} samples", sigma, off, step, samples),
              test::onTheAxis(sceneOf(volumes, light), kEye, dvec3(0), samples, step).x, right, 0.01);
    }
}

TEST(DenseMedia, SeenAtASlant) {
  test::renderer();
  test::Rows rows("box, seen at a slant");
  for (const double sigma : kSigmas)
    for (const double off : kOff)
      for (const ShadowSpec& spec : {marched(), defaultMap()}) {
        const volume::InstanceList volumes{slab(sigma)};
        const auto light = test::shadowed(sunOff(off), spec, volumes);
        for (const double view : {40.0, 75.0}) {
          const double a = glm::radians(view);
          const dvec3 target(0, 0, 0.5), eye = target + 2.0 * dvec3(-std::sin(a), 0, std::cos(a));
          const double right = slabRadiance(sigma, std::cos(a), std::cos(glm::radians(off)));
          rows.check(fmt::format("sigma {}, seen {} and lit {} degrees off, {}", sigma, view, off,
                                 shadow::describe(spec)),
                     test::onTheAxis(sceneOf(volumes, light), eye, target, 1, 1).x, right,
                     allowed(spec, sigma, off, false));
        }
      }
}

/// Whatever stands before or behind it.
void compareWith(const char* table, double sigmaOther, double zOther) {
  test::renderer();
  test::Rows rows(table);
  for (const double sigma : kSigmas)
    for (const double off : {0.0, 60.0})
      for (const ShadowSpec& spec : {marched(), defaultMap()}) {
        const volume::InstanceList volumes{slab(sigma), slab(sigmaOther < 0 ? sigma : sigmaOther, zOther)};
        const dvec3 eye(0, 0, std::max(zOther, 0.0) + 10.5);
        const scene::Light sun = sunOff(off);
        const double right =
            test::exactAlong(volumes, {test::exactly(volumes, sun)}, eye, {0, 0, -1}).radiance.x;
        const auto light = test::shadowed(sun, spec, volumes);
        for (const int samples : {1, 16})
          rows.check(fmt::format("sigma {}, sun {} degrees off, {}, {} samples", sigma, off,
                                 shadow::describe(spec), samples),
                     test::onTheAxis(sceneOf(volumes, light), eye, dvec3(0), samples, 1).x, right,
                     // A map knows places 100 m away to a float: a tenth of optical depth.
                     std::abs(zOther) > 50 && sigma >= 1e4 && spec.kind != ShadowSpec::Kind::RayMarch
                         ? 0.06
                         : allowed(spec, sigma, off, false));
      }
}

TEST(DenseMedia, BehindAThinBox) { compareWith("behind a thin box", 0.3, 4); }
TEST(DenseMedia, BeforeASecondBox100MetresBehind) { compareWith("a second box 100 m behind", -1, -100); }
TEST(DenseMedia, BehindAThinBox100MetresBefore) { compareWith("a thin box 100 m before", 0.5, 100); }

/// Every other representation: what the picture makes of its own lookups.
std::vector<ShadowSpec> representations() {
  constexpr int kTexels = 64;
  ShadowSpec slabs = test::improved(4, 8, kTexels);
  slabs.extinction.basis = shadow::Basis::Slab;
  ShadowSpec series = test::improved(4, 8, kTexels, false);
  series.metric.metric = shadow::Metric::Cosine;
  ShadowSpec none = series;
  none.metric.metric = shadow::Metric::None;
  return {test::improved(4, 8, kTexels),
          test::improved(4, 8, kTexels, true, shadow::Storage::Half),
          test::improved(4, 16, kTexels, false),
          slabs,
          series,
          none,
          cli::improved32(kTexels),
          cli::piecewise32(kTexels),
          cli::improved40(kTexels),
          test::fourier(7, kTexels),
          test::fourier(15, kTexels, true),
          test::transmittance(7, shadow::Basis::Fourier, kTexels),
          test::transmittance(15, shadow::Basis::Cosine, kTexels),
          test::deep(0.01, kTexels)};
}

TEST(DenseMedia, EveryRepresentationGivesTheIntegralOfItsOwnLookups) {
  test::renderer();
  test::Rows rows("own lookups");
  for (const ShadowSpec& spec : representations())
    for (const double sigma : {3.0, 100.0, 1e4})
      for (const double off : {0.0, 60.0}) {
        const volume::InstanceList volumes{test::box({0, 0, 0}, {4, 4, 1}, sigma)};
        const auto light = test::shadowed(sunOff(off), spec, volumes);
        // Away from where texels meet: there a map's own step would be looked at.
        const dvec3 eye = kEye + dvec3(0.011, 0.007, 0);
        const double right = test::exactAlong(volumes, {test::asLookedUp(light)}, eye, {0, 0, -1}).radiance.x;
        for (const double step : {1.0, 4.0})
          rows.check(fmt::format("{}, sigma {}, sun {} degrees off, step {}", shadow::describe(spec), sigma,
                                 off, step),
                     test::onTheAxis(sceneOf(volumes, light), eye, eye - dvec3(0, 0, 1), 1, step).x, right,
                     // Ends in 8 or 16 bits make T a stair where that is a part of a mean free path.
                     spec.metric.storage == shadow::Storage::Half || spec.metric.compact ? 0.06 : 0.01,
                     1e-3 / (8 * kPi));
      }
}

TEST(DenseMedia, DeepMapsKeepTheirBoundOnAnalyticShapes) {
  test::renderer();
  test::Rows rows("deep maps' bound");
  for (const double bound : {0.003, 0.03})
    for (const double sigma : {1.0, 100.0, 1e4})
      for (const double off : kOff) {
        const volume::InstanceList volumes{test::box({0, 0, 0}, {4, 4, 1}, sigma),
                                           test::ball({0, 0, -3}, 1.2, sigma)};
        const scene::Light sun = sunOff(off);
        const auto map = test::build(test::deep(bound, 64), volumes, sun);
        std::vector<vec3> at;
        for (const ivec2 texel : {ivec2(32, 32), ivec2(30, 35), ivec2(35, 30)}) {
          const auto ray = shadow::mapSegment(map->frustum, 0, (dvec2(texel) + 0.5) / 64.0, 64);
          for (int i = 0; i < 1000; ++i) at.emplace_back(glm::mix(ray.from, ray.to, (i + 0.5) / 1000));
          // And where T falls.
          const dvec3 d = glm::normalize(ray.to - ray.from);
          const double length = glm::length(ray.to - ray.from);
          for (const volume::Instance& v : volumes) {
            const dmat4 local = glm::inverse(v.worldFromLocal);
            const dvec3 o(local * dvec4(ray.from, 1)), ld(local * dvec4(d, 0));
            const auto hit = v.shape == volume::Shape::Ball ? intersectBall(o, ld)
                                                            : intersectBox(o, ld, dvec3(-0.5), dvec3(0.5));
            for (int i = 0; hit && i < 100; ++i) {
              const double t = hit->x + 0.06 * i / sigma;
              if (t > 0 && t < std::min(hit->y, length)) at.emplace_back(ray.from + t * d);
            }
          }
        }
        const auto tau = test::lookupTau(*map, sun, at);
        double worst = 0;
        for (std::size_t i = 0; i < at.size(); ++i)
          worst = std::max(worst, std::abs(std::exp(-double(tau[i])) - std::exp(-shadow::opticalDepthToLight(
                                                                           volumes, sun, dvec3(at[i])))));
        // Places along the light are floats: a few 1e-7 of its five metres.
        rows.check(fmt::format("bound {}, sigma {}, sun {} degrees off", bound, sigma, off), worst, 0, 0,
                   bound + 1e-3 + 4e-7 * sigma);
      }
}

TEST(DenseMedia, FromInsideAndFromAFace) {
  test::renderer();
  test::Rows rows("camera inside, on a face");
  const scene::Light sun = sunOff(30);
  for (const double sigma : {1.0, 100.0, 1e4})
    for (const bool grid : {false, true})
      for (const ShadowSpec& spec : {marched(), defaultMap()}) {
        const volume::InstanceList volumes{grid ? gridSlab(sigma) : slab(sigma)};
        const auto light = test::shadowed(sun, spec, volumes);
        for (const double z : {0.5, 0.5 - 1e-4, 0.4, -0.4, -0.5})
          for (const dvec3& d : {dvec3(0, 0, -1), dvec3(0, 0, 1), dvec3(0.6, 0, -0.8)}) {
            const dvec3 eye(0, 0, z);
            const test::Exact right = test::exactAlong(volumes, {test::exactly(volumes, sun)}, eye, d);
            // What is dark is not looked at by its ratio.
            if (right.radiance.x < 1e-4) continue;
            const std::string what =
                fmt::format("{}, sigma {}, z {}, direction ({}, {}), {}", grid ? "grid" : "box", sigma, z,
                            d.x, d.z, shadow::describe(spec));
            const dvec4 seen = test::onTheAxis(sceneOf(volumes, light), eye, eye + d, 1, 1);
            // From within the voxel over which a grid's face rises the first step takes more than that part.
            rows.check(what, seen.x, right.radiance.x, grid ? 0.03 : 0.01, 1e-4);
            rows.check(what + ", alpha", seen.w, right.alpha, 0, grid ? 7e-3 : 2e-3);
          }
      }
}

TEST(DenseMedia, BallUnderSlantedLight) {
  test::renderer();
  test::Rows rows("ball");
  for (const double sigma : kSigmas)
    for (const ShadowSpec& spec : {marched(), test::improved(4, 8, 512)}) {
      const volume::InstanceList volumes{test::ball({0, 0, 0}, 1, sigma)};
      const scene::Light sun = sunOff(60);
      const auto light = test::shadowed(sun, spec, volumes);
      for (const dvec3& target : {dvec3(0), dvec3(0.31, 0.2, 0.4), dvec3(0.1, 0.77, 0)}) {
        const double right =
            test::exactAlong(volumes, {test::exactly(volumes, sun)}, kEye, glm::normalize(target - kEye))
                .radiance.x;
        rows.check(
            fmt::format("sigma {}, target {} {}, {}", sigma, target.x, target.y, shadow::describe(spec)),
            test::onTheAxis(sceneOf(volumes, light), kEye, target, 1, 1).x, right,
            spec.kind == ShadowSpec::Kind::RayMarch ? 0.01
            : sigma >= 1e4                          ? 0.25
                                                    : 0.02,
            1e-4);
      }
    }
}

}  // namespace
}  // namespace pileus
