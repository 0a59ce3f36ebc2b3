// What interval maps take for covered, against a walk over the bricks in double precision: voxels of any
// shape, size and distance. And what they keep where there is nothing.
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/lit.h"
#include "tests/support/shadow_specs.h"

namespace pileus {
namespace {

/// A lattice of which a third of the bricks hold something, each all of its voxels.
volume::GridPtr scattered(ivec3 bricks, unsigned seed) {
  volume::VoxelSource source;
  source.name = "scattered";
  source.activeMin = ivec3(0);
  source.activeMax = bricks * volume::kBrickSize - 1;
  std::mt19937 rng(seed);
  std::bernoulli_distribution holds(0.3);
  std::vector<float> of(std::size_t(bricks.x) * std::size_t(bricks.y) * std::size_t(bricks.z));
  for (float& density : of) density = holds(rng) ? 1.0f : 0.0f;
  source.fill = [of, bricks](ivec3 lo, float* out) {
    for (int z = 0; z < volume::kStoredSize; ++z)
      for (int y = 0; y < volume::kStoredSize; ++y)
        for (int x = 0; x < volume::kStoredSize; ++x) {
          const ivec3 b = (lo + ivec3(x, y, z) + volume::kBrickSize) / volume::kBrickSize - 1;
          const bool inside =
              glm::all(glm::greaterThanEqual(b, ivec3(0))) && glm::all(glm::lessThan(b, bricks));
          *out++ = inside ? of[std::size_t((b.z * bricks.y + b.y) * bricks.x + b.x)] : 0.0f;
        }
    return volume::Fill::Voxels;
  };
  JobControl control;
  return volume::buildBricks(source, control).value().grid;
}

volume::Instance placed(const volume::GridPtr& grid, const dvec3& voxel, const dvec3& center) {
  volume::Instance i;
  i.shape = volume::Shape::Grid;
  i.grid = grid;
  const dvec3 middle = grid->indexBounds.center();
  i.worldFromLocal = glm::translate(dmat4(1.0), center) * glm::scale(dmat4(1.0), voxel) *
                     glm::translate(dmat4(1.0), -middle);
  i.medium.extinction = 1e-3 / std::min({voxel.x, voxel.y, voxel.z});
  return i;
}

/// Share of [from, to] in bricks that may hold something, by trying many places.
double coveredShare(const volume::Instance& i, const dvec3& from, const dvec3& to) {
  const dmat4 localFromWorld = glm::inverse(i.worldFromLocal);
  const dvec3 o = dvec3(localFromWorld * dvec4(from, 1)) - dvec3(i.grid->origin),
              d = dvec3(localFromWorld * dvec4(to - from, 0));
  const volume::Level& level = i.grid->levels.front();
  const Box3 bounds{i.grid->indexBounds.min - dvec3(i.grid->origin),
                    i.grid->indexBounds.max - dvec3(i.grid->origin)};
  const auto hit = intersectBox(o, d, bounds.min, bounds.max);
  if (!hit) return 0;
  const double begin = std::max(hit->x, 0.0), end = std::min(hit->y, 1.0);
  constexpr int kPlaces = 4000;
  int in = 0;
  for (int k = 0; k < kPlaces && begin < end; ++k) {
    const ivec3 b(
        glm::floor((o + d * glm::mix(begin, end, (k + 0.5) / kPlaces)) / double(volume::kBrickSize)));
    const bool inside =
        glm::all(glm::greaterThanEqual(b, ivec3(0))) && glm::all(glm::lessThan(b, level.bricks));
    in += inside && volume::occupied(i, level.at(b)) ? 1 : 0;
  }
  return std::max(end - begin, 0.0) * in / kPlaces;
}

struct Coverage {
  int rays = 0, lost = 0;  ///< that meet a medium; of which the map has none
  double worst = 0;        ///< |covered - expected|, in bricks' lengths
};

/// Eight intervals are enough for the rays of these lattices only where gaps may be closed: what a map covers
/// is then at least what it should, never less.
Coverage coverage(const volume::Instance& instance, const scene::Light& light, int resolution) {
  const shadow::MetricOptions options{shadow::Metric::Interval, 8, 4, resolution};
  const shadow::LightFrustum f = shadow::fitLight(light, {instance}, resolution);
  shadow::PseudometricPass pass(options, light, {instance}, f);
  while (*pass.step(test::renderer().gpu(), 1e12) < 1) {
  }
  Coverage c;
  for (int y = 0; y < resolution; ++y)
    for (int x = 0; x < resolution; ++x) {
      const auto segment = shadow::mapSegment(f, 0, (dvec2(x, y) + 0.5) / double(resolution), resolution);
      const double expected = coveredShare(instance, segment.from, segment.to);
      const std::vector<float> m = test::texel(*pass.map()->block, {x, y});
      double covered = 0;
      for (std::size_t j = 0; j < 16; j += 2) covered += double(m[j + 1] - m[j]);
      if (expected < 1e-3) continue;
      ++c.rays;
      c.lost += covered < 1e-4 ? 1 : 0;
      c.worst = std::max(c.worst, expected - covered);
    }
  return c;
}

void expectWhole(const char* what, const volume::Instance& instance, const scene::Light& light) {
  const Coverage c = coverage(instance, light, 64);
  std::printf("%s: %d rays through media, %d lost, covered at most %.5f too little\n", what, c.rays, c.lost,
              c.worst);
  EXPECT_GT(c.rays, 500) << what;
  EXPECT_EQ(c.lost, 0) << what;
  EXPECT_LT(c.worst, 2e-3) << what;
}

TEST(IntervalCoverage, FlatVoxelsKeepTheirMedium) {
  const auto grid = scattered({25, 3, 25}, 1);
  const auto light = test::sunFrom({0.3, 1, 0.2});
  expectWhole("voxels of 2000 x 100 x 2000 m", placed(grid, {2000, 100, 2000}, dvec3(0)), light);
  expectWhole("voxels of 2000 x 10 x 2000 m", placed(grid, {2000, 10, 2000}, dvec3(0)), light);
  expectWhole("the same, the sun low", placed(grid, {2000, 10, 2000}, dvec3(0)),
              test::sunFrom({1, 0.05, 0.2}));
}

TEST(IntervalCoverage, SmallVoxelsFarDownTheRayKeepTheirMedium) {
  const auto grid = scattered({8, 8, 8}, 2);
  // A spot, so that x begins at the light: 1 cm, 300 m away.
  expectWhole("voxels of 1 cm, 300 m down a ray", placed(grid, dvec3(0.01), {0, 0, -300}),
              test::spotAt({0.1, 0.2, 0}, {0, 0, -300}, 0.2));
}

TEST(IntervalCoverage, VoxelsFarFromTheOriginKeepTheirMedium) {
  const auto grid = scattered({8, 8, 8}, 3);
  expectWhole("voxels of 1 m, 100 km away", placed(grid, dvec3(1), {1e5, 0, 1e5}),
              test::sunFrom({0.3, 1, 0.2}));
  // No ray along a wall between bricks: it is either side of it by rounding.
  expectWhole("along an axis", placed(grid, dvec3(1), dvec3(0)), test::sunFrom({1e-4, 1, 2e-4}));
}

TEST(IntervalCoverage, WeightsOfEmptyRaysAreOne) {
  const auto light = test::sunFrom({0, 1, 0});
  shadow::MetricOptions options{shadow::Metric::Interval, 4, 4, 64};
  options.weighting = shadow::Weighting::Root;
  const auto build = [&](const volume::InstanceList& volumes) {
    shadow::PseudometricPass pass(options, light, volumes, test::narrow());
    while (*pass.step(test::renderer().gpu(), 1e12) < 1) {
    }
    return pass.map();
  };
  // What a map finds in its block: another one's weights, two intervals everywhere. They are kept as fourth
  // roots of the root of extinction: 5000 times thinner is 0.34.
  ivec3 place;
  {
    const auto before =
        build({test::box({0, 0.3, 0}, {1, 0.1, 1}, 1), test::box({0, -0.3, 0}, {1, 0.1, 1}, 5000)});
    place = ivec3(before->weights->record().place.x, before->weights->record().place.y,
                  before->weights->record().place.w);
    EXPECT_LT(test::texel(*before->weights, {32, 32})[0], 0.5f);
  }
  const auto after = build({test::box({0, 0, 50}, {1, 1, 1}, 1)});
  const gpu::BlockRecord r = after->weights->record();
  ASSERT_EQ(ivec3(r.place.x, r.place.y, r.place.w), place) << "another place: nothing is left over there";
  for (int i = 0; i < 64; i += 7)
    for (const float w : test::texel(*after->weights, {i, 63 - i})) EXPECT_EQ(w, 1.0f) << i;
}

}  // namespace
}  // namespace pileus
