// Opaque solids: C++ twins, exact radiance of planes below and in media, shadows that solids cast into
// volumes.
#include <cmath>
#include <random>

#include "tests/support/lit.h"

namespace pileus {
namespace {

using Kind = shadow::ShadowSpec::Kind;

shadow::ShadowSpec specOf(Kind kind) {
  shadow::ShadowSpec spec;
  spec.kind = kind;
  if (kind == Kind::TransmittanceFunction)
    spec.basis = shadow::Basis::Cosine, spec.coefficients = 15;  // a periodic one wraps at the end
  return shadow::withResolution(spec, 128);
}

TEST(Solids, HitsAreThoseOfTheCpu) {
  std::mt19937_64 rng(31);
  std::uniform_real_distribution<double> u(-1, 1);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    scene::SolidList solids;
    for (int k = 0; k < 4; ++k) {
      const dvec3 center(2 * u(rng), 2 * u(rng), 2 * u(rng)), size(1.1 + u(rng), 1.1 + u(rng), 1.1 + u(rng)),
          rotate(180 * u(rng), 180 * u(rng), 180 * u(rng));
      solids.push_back(k % 2 ? test::solidPlane(center, size, rotate) : test::solidBox(center, size, rotate));
    }
    std::vector<dvec3> points, directions;
    for (int k = 0; k < 100; ++k) {
      points.push_back(dvec3(vec3(4 * u(rng), 4 * u(rng), 4 * u(rng))));
      directions.push_back(dvec3(vec3(glm::normalize(dvec3(u(rng), u(rng), u(rng)) * 2.0 - points.back()))));
    }
    auto light = test::pointAt({3 * u(rng), 3 * u(rng), 3 * u(rng)});
    if (i % 2) light = test::sunFrom({u(rng), u(rng), u(rng)});
    const auto lit =
        test::lit(test::shadowed(light, specOf(Kind::RayMarch), {}, solids), points, solids, directions);
    for (std::size_t k = 0; k < points.size(); ++k) {
      int nearest = -1;
      scene::SolidHit best{1e30, {}};
      bool edge = false;  // a hit that hangs on rounding
      for (int s = 0; s < 4; ++s) {
        const auto a = scene::intersect(solids[std::size_t(s)], points[k], directions[k]);
        if (a && a->t < best.t) best = *a, nearest = s;
        for (const dvec3& off : {dvec3(1e-4, 0, 0), dvec3(0, 1e-4, 0), dvec3(0, 0, 1e-4), dvec3(-1e-4, 0, 0),
                                 dvec3(0, -1e-4, 0), dvec3(0, 0, -1e-4)}) {
          const auto b = scene::intersect(solids[std::size_t(s)], points[k] + off, directions[k]);
          edge = edge || bool(a) != bool(b) || (a && glm::dot(a->normal, b->normal) < 0.999);
        }
      }
      if (!edge) {
        compared += nearest >= 0;
        EXPECT_EQ(lit[k].solid, nearest < 0 ? 0 : nearest);
        if (nearest < 0) {
          EXPECT_GT(lit[k].hit, 1e29);
        } else {
          EXPECT_NEAR(lit[k].hit, best.t,
                      2e-5 * std::max(1.0, best.t) / std::max(0.02, -glm::dot(best.normal, directions[k])));
          EXPECT_LT(glm::length(lit[k].normal - best.normal), 1e-5);
        }
      }
      const bool sun = light.kind == scene::LightKind::Sun;
      const auto shadowAt = [&](const dvec3& p) {
        return scene::blocked(solids, p, sun ? p + 100.0 * light.towards : light.position);
      };
      const bool want = shadowAt(points[k]);
      bool sure = true;
      for (const dvec3& off : {dvec3(1e-4, 0, 0), dvec3(0, 1e-4, 0), dvec3(0, 0, 1e-4), dvec3(-1e-4, 0, 0),
                               dvec3(0, -1e-4, 0), dvec3(0, 0, -1e-4)})
        sure = sure && shadowAt(points[k] + off) == want;
      if (sure) {
        EXPECT_EQ(lit[k].visibility, want ? 0 : 1) << i << " " << k;
      }
    }
  }
  std::printf("%d hits compared\n", compared);
  EXPECT_GT(compared, 900);
}

TEST(Solids, PlaneBelowAMediumCatchesItsTransmittance) {
  const double sigma = 0.6, height = 1.5, elevation = 50;
  const volume::InstanceList media{test::box({0, 3, 0}, {40, height, 40}, sigma)};
  const scene::Light sun = test::sunFrom(scene::sunDirection(20, elevation), 7);
  const scene::SolidList ground{test::solidPlane({0, 0, 0}, {60, 1, 60}, dvec3(0), {0.8f, 0.4f, 0.1f})};
  const double sine = std::sin(glm::radians(elevation)), tau = sigma * height / sine;
  for (const Kind kind :
       {Kind::RayMarch, Kind::Extinction, Kind::FourierOpacity, Kind::TransmittanceFunction, Kind::Deep}) {
    const shadow::ShadowedLight light = test::shadowed(sun, specOf(kind), media, ground);
    // From between the two: nothing in front of the plane.
    const vec4 c = test::along({2, 1, 3}, {0.3, 0, -0.2}, {{}, media, {light}, ground});
    const double want = std::exp(-tau) * 7 / kPi * sine;
    std::printf("plane below a slab, %s: %.7f, exact %.7f\n", shadow::describe(specOf(kind)).c_str(),
                double(c.x) / 0.8, want);
    const double tolerance = kind == Kind::RayMarch                ? 1e-5
                             : kind == Kind::Deep                  ? 0.011 / std::exp(-tau)
                             : kind == Kind::TransmittanceFunction ? 0.07
                                                                   : 2e-3;
    EXPECT_NEAR(double(c.x) / 0.8 / want, 1, tolerance) << shadow::describe(specOf(kind));
    EXPECT_NEAR(double(c.y), double(c.x) / 2, 1e-6);
    EXPECT_NEAR(double(c.z), double(c.x) / 8, 1e-6);
    EXPECT_EQ(c.w, 1.0f);
    // From above: seen through the medium, which glows itself.
    const vec4 through = test::along({0, 50, 0}, {0, 0, 0}, {{}, media, {light}, ground});
    auto dark = media;
    dark[0].medium.albedo = vec3(0);
    const vec4 unlit = test::along({0, 50, 0}, {0, 0, 0}, {{}, dark, {light}, ground});
    EXPECT_NEAR(double(unlit.x), 0.8 * want * std::exp(-sigma * height), 2e-5 + 0.8 * want * tolerance);
    EXPECT_NEAR(double(through.x - unlit.x),
                double(test::along({0, 50, 0}, {0, 0, 0}, {{}, media, {light}, {}}).x), 1e-5);
  }
}

TEST(Solids, VolumesEndAtTheSolidInThem) {
  const double sigma = 0.5;
  const volume::InstanceList media{test::box({0, 0, 0}, {8, 8, 8}, sigma)};
  const scene::Light sun = test::sunFrom({0, 1, 0}, 3);
  const scene::SolidList floor{test::solidPlane({0, -1, 0}, {6, 1, 6})};
  const shadow::ShadowedLight light = test::shadowed(sun, specOf(Kind::RayMarch), media, floor);
  view::RenderScene scene{{}, media, {light}, floor};
  scene.options.stepScale = 0.1;
  // Straight down: depth 5 above the floor, of which each metre is lit through what is above it.
  const vec4 c = test::along({0, 20, 0}, {0, -1, 0}, scene);
  const double scattered = 3 / (4 * kPi) * (1 - std::exp(-2 * sigma * 5)) / 2,
               reflected = 3 * 0.5 / kPi * std::exp(-2 * sigma * 5);
  EXPECT_NEAR(double(c.x) / (scattered + reflected), 1, 1e-4);
  EXPECT_EQ(c.w, 1.0f);
  // Straight up at it from below: its lower side is dark, and so is the medium in its shadow.
  const vec4 below = test::along({0, -20, 0}, {0, -1, 0}, scene);
  EXPECT_EQ(below.x, 0.0f);
  EXPECT_EQ(below.w, 1.0f);
}

TEST(Solids, BoxCastsAHardShadowIntoAVolume) {
  const double sigma = 0.4, albedo = 0.9;
  volume::InstanceList media{test::box({0, 0, 0}, {4, 4, 4}, sigma)};
  media[0].medium.albedo = vec3(float(albedo));
  const scene::Light sun = test::sunFrom({0, 1, 0}, 2);
  const scene::SolidList lid{test::solidBox({1, 3, 0}, {2, 0.5, 4})};  // above x in [0, 2]
  for (const Kind kind : {Kind::RayMarch, Kind::Extinction}) {
    const shadow::ShadowedLight light = test::shadowed(sun, specOf(kind), media, lid);
    for (const double y : {1.5, 0.0, -1.2}) {
      // Along x from the lit side: lit over the first two of four metres.
      const double want = albedo * 2 / (4 * kPi) * std::exp(-sigma * (2 - y)) * (1 - std::exp(-sigma * 2));
      EXPECT_NEAR(double(test::along({-20, y, 0}, {0, y, 0}, {{}, media, {light}, lid}).x) / want, 1, 2e-3)
          << y;
      EXPECT_NEAR(double(test::along({20, y, 0}, {0, y, 0}, {{}, media, {light}, lid}).x) / want,
                  std::exp(-sigma * 2), 2e-3)
          << y;
      // Across it, in the light and in the shadow.
      const double whole = albedo * 2 / (4 * kPi) * std::exp(-sigma * (2 - y)) * (1 - std::exp(-sigma * 4));
      EXPECT_NEAR(double(test::along({-0.01, y, 20}, {-0.01, y, 0}, {{}, media, {light}, lid}).x) / whole, 1,
                  2e-3)
          << y;
      EXPECT_EQ(test::along({0.01, y, 20}, {0.01, y, 0}, {{}, media, {light}, lid}).x, 0.0f) << y;
    }
    // Drawn but not linked to the shadow, it blocks nothing.
    const shadow::ShadowedLight free = test::shadowed(sun, specOf(kind), media);
    EXPECT_GT(test::along({0.01, 0, 20}, {0.01, 0, 0}, {{}, media, {free}, lid}).x, 0.01f);
  }
}

TEST(Solids, LitFacesNeverShadowThemselves) {
  // Huge, tiny, tilted and far from the origin: where rounding is worst.
  const scene::Light sun = test::sunFrom({0.3, 1, 0.2}, 1);
  const struct {
    scene::Solid solid;
    dvec3 eye, target;
  } cases[] = {
      {test::solidBox({0, -5000, 0}, {10000, 10000, 10000}), {0, 1.7, 0}, {300, 0, 40}},
      {test::solidPlane({0, 0, 0}, {1e6, 1, 1e6}, {17, 5, 9}), {0, 40, 0}, {30, 0, 10}},
      {test::solidBox({40000, 30, -25000}, {3, 3, 3}, {20, 30, 40}),
       {40007, 42, -25004},
       {40000, 30, -25000}},
      {test::solidBox({0, 0, 0}, {1e-3, 1e-3, 1e-3}, {20, 30, 40}), {0.004, 0.007, 0.003}, {0, 0, 0}},
      {test::solidPlane({1e5, 0, 1e5}, {2e5, 1, 2e5}, {3, 0, 2}), {0, 2e4, 0}, {1e4, 0, 1e4}},
  };
  for (const auto& c : cases) {
    const scene::SolidList solids{c.solid};
    view::RenderScene scene{{}, {}, {test::shadowed(sun, specOf(Kind::RayMarch), {}, solids)}, solids};
    scene.options.size = ivec2(48, 48);
    scene.options.samples = 1;
    scene.options.camera = {c.eye, c.target, {0, 1, 0}, 30};
    const image::Image image = test::render(scene);
    int lit = 0;
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const float* p = &image.layers[0].pixels[std::size_t(y * 48 + x) * 4];
        const dvec3 d = scene::rayDirection(scene.options.camera, 1, dvec2(x + 0.5, y + 0.5) / 48.0);
        const auto hit = scene::intersect(c.solid, c.eye, d);
        if (!hit) continue;
        const double want = std::max(glm::dot(hit->normal, sun.towards), 0.0) * 0.5 / kPi;
        // Pixels on an edge between faces may be on either.
        const auto near = scene::intersect(
            c.solid, c.eye, scene::rayDirection(scene.options.camera, 1, dvec2(x + 0.9, y + 0.9) / 48.0));
        const auto near2 = scene::intersect(
            c.solid, c.eye, scene::rayDirection(scene.options.camera, 1, dvec2(x + 0.1, y + 0.1) / 48.0));
        if (!near || !near2 || glm::dot(near->normal, hit->normal) < 0.99 ||
            glm::dot(near2->normal, hit->normal) < 0.99)
          continue;
        lit += want > 0;
        ASSERT_NEAR(double(p[0]), want, 1e-4) << x << " " << y;
        ASSERT_EQ(p[3], 1.0f);
      }
    EXPECT_GT(lit, 100);
  }
}

}  // namespace
}  // namespace pileus
