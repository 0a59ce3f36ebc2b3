// Transmittance with exact answers, through the real metric and extinction passes and the shader's own
// lookup.
#include <cmath>
#include <random>

#include "renderer/shadow/metric.h"
#include "renderer/volume/brick_builder.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

using shadow::Basis;
using shadow::Metric;
using shadow::Storage;
using test::box;

const dvec3 kUp(0, 1, 0);
const shadow::MetricOptions kInterval{Metric::Interval, 4, 4, 128};
shadow::ExtinctionOptions cosine(int n) { return {Basis::Cosine, n, 128}; }

double T(float tau) { return std::exp(-double(tau)); }

/// The texel of a world point and its centre's world xz.
ivec2 texelOf(const shadow::LightFrustum& f, const dvec3& p, int resolution) {
  const dvec3 q(glm::inverse(f.worldFromLight) * dvec4(p, 1));
  return ivec2(glm::floor(dvec2(q) * double(resolution)));
}

TEST(ClosedForms, HomogeneousBoxIsExact) {
  const auto light = test::sunFrom(kUp);
  const volume::InstanceList volumes{box({0, 0, 0}, {1, 2, 1}, 1.3)};
  const auto map = test::buildMap(volumes, light, kInterval, cosine(8));
  std::vector<vec3> at;
  for (int i = 0; i <= 20; ++i) at.push_back(vec3(0.1f, 1.0f - 0.1f * float(i), -0.2f));
  const auto tau = test::lookupTau(*map, light, at);
  for (std::size_t i = 0; i < at.size(); ++i)
    EXPECT_NEAR(T(tau[i]), std::exp(-1.3 * (1.0 - double(at[i].y))), 1e-5);
  const auto c = test::texel(*map->block, texelOf(map->frustum, {0.1, 0, -0.2}, 128));
  EXPECT_NEAR(c[0], 2.6, 2.6e-5);
  for (std::size_t k = 1; k < 8; ++k) EXPECT_LT(std::abs(c[k]), 1e-5f * c[0]) << "k = " << k;
}

TEST(ClosedForms, TwoBoxesHaveTheirSeries) {
  const auto light = test::sunFrom(kUp);
  const double L1 = 0.7, L2 = 1.9, s1 = 0.4, s2 = 1.7, q = L1 / (L1 + L2);
  const volume::InstanceList volumes{box({0, 5 - L1 / 2, 0}, {1, L1, 1}, s1),
                                     box({0, -3 - L2 / 2, 0}, {1, L2, 1}, s2)};
  const auto map = test::buildMap(volumes, light, kInterval, cosine(8));
  const auto c = test::texel(*map->block, texelOf(map->frustum, dvec3(0), 128));
  const double c0 = s1 * L1 + s2 * L2;
  EXPECT_NEAR(c[0], c0, 1e-5 * c0);
  for (int k = 1; k < 8; ++k)
    EXPECT_NEAR(c[std::size_t(k)], 2 * (s1 - s2) * (L1 + L2) * std::sin(kPi * k * q) / (kPi * k), 1e-5 * c0)
        << "k = " << k;
}

TEST(ClosedForms, EndOfTheRayIsExactForEveryMetricAndBasis) {
  const auto light = test::sunFrom({0.3, 1, 0.2});
  const volume::InstanceList volumes{box({0, 2, 0}, {1, 0.5, 1}, 1.1),
                                     box({0.1, 0, 0}, {1, 0.7, 1}, 0.6, {0, 30, 10}),
                                     test::ball({0, -2, 0}, 0.6, 1.4)};
  // Behind everything, on rays through the middles of texels.
  for (const Metric metric : {Metric::Interval, Metric::Fourier, Metric::Cosine, Metric::None})
    for (const Basis basis : {Basis::Cosine, Basis::Fourier, Basis::Slab})
      for (const Storage storage : {Storage::Float, Storage::Half}) {
        const shadow::MetricOptions m{metric, 4, 4, 128, storage};
        const auto map = test::buildMap(volumes, light, m, {basis, 8, 128, storage});
        std::vector<vec3> at;
        std::vector<double> expected;
        for (int y = 8; y < 128; y += 16)
          for (int x = 8; x < 128; x += 16) {
            const dvec4 uv((x + 0.5) / 128, (y + 0.5) / 128, 1, 1);
            const dvec3 end(map->frustum.worldFromLight * uv),
                begin(map->frustum.worldFromLight * dvec4(uv.x, uv.y, 0, 1));
            double tau = 0;
            for (const volume::Instance& i : volumes) {
              const dmat4 inverse = glm::inverse(i.worldFromLocal);
              const dvec3 o(inverse * dvec4(begin, 1)), d(inverse * dvec4(end - begin, 0));
              const auto hit = i.shape == volume::Shape::Ball ? intersectBall(o, d)
                                                              : intersectBox(o, d, dvec3(-0.5), dvec3(0.5));
              if (hit) tau += i.medium.extinction * (hit->y - hit->x) * glm::length(end - begin);
            }
            at.push_back(vec3(end));
            expected.push_back(std::exp(-tau));
          }
        const auto tau = test::lookupTau(*map, light, at);
        for (std::size_t i = 0; i < at.size(); ++i)
          EXPECT_NEAR(T(tau[i]), expected[i], 1e-3)
              << enumId(metric) << " " << enumId(basis) << " " << enumId(storage) << " ray " << i;
      }
}

TEST(ClosedForms, LinearRamp) {
  constexpr int kVoxels = 256;
  constexpr double a = 1.0 / kVoxels;  // sigma = a y at depth y
  volume::VoxelSource source;
  source.name = "ramp";
  source.worldFromIndex =
      glm::scale(glm::translate(dmat4(1), dvec3(0, 0.5, 0)), dvec3(1.0, -1.0 / kVoxels, 1.0));
  source.activeMin = ivec3(-8, 0, -8);
  source.activeMax = ivec3(8, kVoxels - 1, 8);
  source.fill = [](ivec3 lo, float* out) {
    for (int z = 0; z < volume::kStoredSize; ++z)
      for (int y = 0; y < volume::kStoredSize; ++y)
        for (int x = 0; x < volume::kStoredSize; ++x) *out++ = float(a * 4 * std::max(0, lo.y + y));
    return volume::Fill::Voxels;
  };
  JobControl control;
  auto built = volume::buildBricks(source, control);
  ASSERT_TRUE(built);
  volume::Instance ramp;
  ramp.shape = volume::Shape::Grid;
  ramp.grid = built->grid;
  ramp.worldFromLocal = ramp.grid->worldFromIndex;
  const auto light = test::sunFrom(kUp);
  // One texel a voxel along the light would be the matching mip; the frustum is narrow, so the finest level
  // is used.
  shadow::LightFrustum f;
  f.worldFromLight =
      dmat4(dvec4(0.2, 0, 0, 0), dvec4(0, 0, 0.2, 0), dvec4(0, -1.2, 0, 0), dvec4(-0.1, 0.6, -0.1, 1));
  const auto map = test::buildMap({ramp}, light, kInterval, {Basis::Cosine, 16, 128}, &f);
  std::vector<vec3> at;
  for (int i = 0; i <= 50; ++i) at.push_back(vec3(0.01f, 0.5f - 0.0195f * float(i), 0.01f));
  const auto tau = test::lookupTau(*map, light, at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double depth = 0.5 - double(at[i].y);
    EXPECT_NEAR(T(tau[i]), std::exp(-4 * depth * depth / 2), 3e-3) << "depth " << depth;
  }
}

TEST(ClosedForms, SphereChord) {
  const auto light = test::sunFrom({0.2, 1, -0.4});
  const double r = 1.5, sigma = 0.9;
  const auto map = test::buildMap({test::ball({0.3, 0, 0.1}, r, sigma)}, light, {Metric::Interval, 4, 4, 512},
                                  {Basis::Cosine, 8, 512});
  const dvec3 along = -light.towards, side = glm::normalize(glm::cross(along, dvec3(1, 0, 0))),
              up = glm::cross(along, side);
  std::vector<vec3> at;
  std::vector<double> expected;
  for (int i = 0; i < 200; ++i) {
    const double rho = 0.95 * r * i / 200, angle = 2.4 * i;
    at.push_back(
        vec3(dvec3(0.3, 0, 0.1) + rho * (std::cos(angle) * side + std::sin(angle) * up) + 1.45 * along));
    const double half = std::sqrt(r * r - rho * rho);
    expected.push_back(std::exp(-sigma * (half + std::min(1.45, half))));
  }
  const auto tau = test::lookupTau(*map, light, at);
  for (std::size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(T(tau[i]), expected[i], 2e-3) << i;
}

TEST(ClosedForms, SampleOrderChangesNoBit) {
  const auto light = test::sunFrom({0.3, 1, 0.2});
  volume::InstanceList volumes;
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 12; ++i)
    volumes.push_back(
        box({u(rng), u(rng), u(rng)}, {0.5, 0.4, 0.6}, 1 + u(rng), {90 * u(rng), 90 * u(rng), 0}));
  view::RenderOptions o;
  o.size = ivec2(64, 48);
  o.samples = 2;
  o.camera = scene::frameBounds(volume::worldBounds(volumes), 64.0 / 48);
  const auto everything = [&] {
    std::vector<float> out;
    const auto map = test::buildMap(volumes, light, kInterval, cosine(8));
    for (int y = 0; y < 128; y += 7)
      for (int x = 0; x < 128; x += 7)
        for (const float c : test::texel(*map->block, {x, y})) out.push_back(c);
    const auto picture = test::render(o, volumes, {{light, map}});
    out.insert(out.end(), picture.layers[0].pixels.begin(), picture.layers[0].pixels.end());
    return out;
  };
  const std::vector<float> before = everything();
  std::shuffle(volumes.begin(), volumes.end(), rng);
  EXPECT_EQ(before, everything());
}

TEST(ClosedForms, InvariantUnderSplittingScaleAndMotion) {
  const auto light = test::sunFrom({0.3, 1, 0.2});
  const auto transmittances = [&](const volume::InstanceList& volumes, const scene::Light& sun,
                                  const std::vector<vec3>& at) {
    std::vector<double> out;
    const auto map = test::buildMap(volumes, sun, {Metric::Interval, 8, 4, 256}, {Basis::Cosine, 8, 256});
    for (const float tau : test::lookupTau(*map, sun, at)) out.push_back(T(tau));
    return out;
  };
  std::vector<vec3> at;
  for (int i = 0; i < 30; ++i)
    at.push_back(vec3(0.01f * float(i % 7), 0.9f - 0.06f * float(i), 0.013f * float(i % 5)));
  const volume::InstanceList whole{box({0, 0, 0}, {1, 2, 1}, 1.2)};
  const auto reference = transmittances(whole, light, at);
  const auto halves =
      transmittances({box({0, 0.5, 0}, {1, 1, 1}, 1.2), box({0, -0.5, 0}, {1, 1, 1}, 1.2)}, light, at);
  // Positions times s, sigma over s.
  auto scaledAt = at;
  for (vec3& p : scaledAt) p *= 10.0f;
  const auto scaled = transmittances({box({0, 0, 0}, {10, 20, 10}, 0.12)}, light, scaledAt);
  const dmat4 motion = composeTransform({3, -2, 5}, {20, 50, -35}, dvec3(1));
  auto movedAt = at;
  for (vec3& p : movedAt) p = vec3(motion * dvec4(dvec3(p), 1));
  auto moved = whole;
  moved[0].worldFromLocal = motion * moved[0].worldFromLocal;
  const auto rigid = transmittances(moved, test::sunFrom(dvec3(motion * dvec4(light.towards, 0))), movedAt);
  for (std::size_t i = 0; i < at.size(); ++i) {
    EXPECT_NEAR(halves[i], reference[i], 1e-3);
    EXPECT_NEAR(scaled[i], reference[i], 1e-3);
    EXPECT_NEAR(rigid[i], reference[i], 1e-3);
  }
}

TEST(ClosedForms, FaceParityOfCutAndOverlappingBoxes) {
  const auto light = test::sunFrom(kUp);
  volume::InstanceList volumes;
  std::mt19937 rng(8);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 8; ++i)
    volumes.push_back(box({0.8 * u(rng), 1.5 * u(rng), 0.8 * u(rng)}, {0.7 + 0.3 * u(rng), 0.8, 0.6}, 1,
                          {90 * u(rng), 90 * u(rng), 90 * u(rng)}));
  volumes[0].worldFromLocal =
      composeTransform({0, 2, 0}, {10, 20, 30}, {1, 1.4, 1});  // through the near plane
  volumes[1].worldFromLocal =
      composeTransform({0, -2, 0}, {30, 10, 5}, {-1, 1.2, 1});  // through the far plane, mirrored
  shadow::LightFrustum f;
  f.worldFromLight = dmat4(dvec4(3, 0, 0, 0), dvec4(0, 0, 3, 0), dvec4(0, -4, 0, 0), dvec4(-1.5, 2, -1.5, 1));
  for (const Metric metric : {Metric::Cosine, Metric::Fourier})
    for (const Storage storage : {Storage::Float, Storage::Half}) {
      shadow::PseudometricPass pass({metric, 4, 4, 256, storage}, light, volumes, f);
      while (*pass.step(test::renderer().gpu(), 1e12) < 1) {
      }
      double worst = 0;
      int compared = 0;
      for (int y = 0; y < 256; y += 5)
        for (int x = 0; x < 256; x += 5) {
          const dvec3 begin(f.worldFromLight * dvec4((x + 0.5) / 256, (y + 0.5) / 256, 0, 1)), d(0, -4, 0);
          double expected[4] = {};
          bool grazing = false;
          for (const volume::Instance& i : volumes) {
            const dmat4 inverse = glm::inverse(i.worldFromLocal);
            const dvec3 o(inverse * dvec4(begin, 1)), ld(inverse * dvec4(d, 0));
            const auto hit = intersectBox(o, ld, dvec3(-0.5), dvec3(0.5));
            // Whether a ray within float rounding of an edge hits is the rasteriser's choice.
            grazing |= hit && hit->y - hit->x < 1e-3;
            if (!hit) continue;
            for (int k = 0; k < 4; ++k)
              expected[k] += shadow::metricFace(metric, k, std::clamp(hit->y, 0.0, 1.0)) -
                             shadow::metricFace(metric, k, std::clamp(hit->x, 0.0, 1.0));
          }
          if (grazing) continue;
          ++compared;
          const auto c = test::texel(*pass.map()->block, {x, y});
          for (std::size_t k = 0; k < 4; ++k) worst = std::max(worst, std::abs(double(c[k]) - expected[k]));
        }
      EXPECT_GT(compared, 2000);
      EXPECT_LT(worst, storage == Storage::Float ? 1e-4 : 5e-3) << enumId(metric) << " " << enumId(storage);
    }
}

TEST(ClosedForms, TransmittanceIsBoundedAndFalls) {
  const auto light = test::sunFrom({0.1, 1, 0.15});
  volume::InstanceList volumes;
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> u(0, 1);
  for (int i = 0; i < 4; ++i)
    volumes.push_back(
        test::ball({0.3 * u(rng), 3.0 * i, 0.3 * u(rng)}, 0.5 + 0.4 * u(rng), 0.4 + 0.5 * u(rng)));
  for (const Basis basis : {Basis::Cosine, Basis::Slab}) {
    const auto map = test::buildMap(volumes, light, {Metric::Interval, 4, 4, 256}, {basis, 8, 256});
    for (int ray = 0; ray < 40; ++ray) {
      std::vector<vec3> at;
      const dvec3 begin(map->frustum.worldFromLight *
                        dvec4((20 + 5 * ray + 0.5) / 256, (128 + ray + 0.5) / 256, 0, 1));
      for (int i = 0; i <= 400; ++i)
        at.push_back(vec3(begin + dvec3(map->frustum.worldFromLight[2]) * (i / 400.0)));
      const auto tau = test::lookupTau(*map, light, at);
      double lowest = 1;
      for (std::size_t i = 0; i < at.size(); ++i) {
        EXPECT_GE(T(tau[i]), 0.0);
        EXPECT_LE(T(tau[i]), 1.0);
        EXPECT_LE(T(tau[i]), lowest + (basis == Basis::Slab ? 1e-6 : 0.05));
        lowest = std::min(lowest, T(tau[i]));
      }
    }
  }
}

}  // namespace
}  // namespace pileus
