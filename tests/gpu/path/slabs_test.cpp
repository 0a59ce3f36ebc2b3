// Plane slabs under diffuse light: a ray that meets one under the cosine mu brings what a beam from there
// reflects or lets through (reciprocity). Fluxes of DISORT's published tests and of van de Hulst's tables.
#include "tests/support/traced.h"

namespace pileus {
namespace {

struct Slab {
  const char* what;
  double g, albedo, depth, mu, reflected, through;  ///< < 0: not known
};

view::RenderScene slab(const Slab& s, bool reflected, int samples) {
  const double x = std::sqrt(1 - s.mu * s.mu) / s.mu;
  view::RenderScene scene = test::rayScene({-x, 1.5, 0}, {0, 0.5, 0}, 32, samples);
  // One metre thick and 10^4 m wide.
  scene.volumes = {test::box({0, 0, 0}, {1e4, 1, 1e4}, s.depth)};
  scene.volumes[0].medium.albedo = vec3(float(s.albedo));
  scene.volumes[0].medium.phase = scene::henyeyGreenstein(s.g);
  scene.lights = {reflected ? test::halves(vec3(1), vec3(0)) : test::halves(vec3(0), vec3(1))};
  return scene;
}

const Slab kSlabs[] = {
    {"isotropic, w 1, tau 32, mu .1", 0, 1, 32, 0.1, 0.97845, 0.021548},
    {"isotropic, w .2, tau .03125, mu .1", 0, 0.2, 0.03125, 0.1, 0.025447, 0.025277 + 0.731616},
    {"isotropic, w 1, tau .03125, mu .1", 0, 1, 0.03125, 0.1, 0.134620, 0.133764 + 0.731616},
    {"g .75, w 1, tau 1, mu 1", 0.75, 1, 1, 1, 0.078742, 0.553378 + 0.367879},
    {"g .75, w 1, tau 8, mu 1", 0.75, 1, 8, 1, 0.506418, 0.493247 + 3.3546e-4},
    {"g .75, w .9, tau 2, mu 1", 0.75, 0.9, 2, 1, 0.09765, 0.66063},
    {"g .85, w 1, tau 4, mu 1", 0.85, 1, 4, 1, 0.19089, 0.79074 + 0.018316},
};

TEST(PathSlabs, FluxesOfPublishedTables) {
  for (const Slab& s : kSlabs)
    for (const bool reflected : {true, false}) {
      const double right = reflected ? s.reflected : s.through;
      // Half of the samples of a flux of one half are 0: 1/(4 n) of variance at most.
      const test::Traced t = test::traced(slab(s, reflected, 160));
      test::expectMean(t, right, std::max(0.003 * right, 0.0015),
                       fmt::format("{}: {}", s.what, reflected ? "R" : "T"));
    }
}

// A half-space that scatters evenly: Chandrasekhar's H function gives what it sends back of a beam at right
// angles, 1 - H(1) sqrt(1 - w) in all and w H(1)^2 / (8 pi) straight up. A slab so thick that nothing comes
// through is one.
TEST(PathSlabs, HalfSpacesOfHFunctions) {
  struct Case {
    double albedo, h, depth;
  };
  for (const Case& c : {Case{0.5, 1.25126, 20}, Case{0.9, 1.85010, 30}, Case{0.99, 2.47279, 60}}) {
    const double reflected = 1 - c.h * std::sqrt(1 - c.albedo), up = c.albedo * c.h * c.h / (8 * kPi);
    const Slab s{"", 0, c.albedo, c.depth, 1, reflected, 0};
    test::expectMean(test::traced(slab(s, true, 512)), reflected, std::max(0.003 * reflected, 0.001),
                     fmt::format("half-space, w {}: plane albedo", c.albedo));
    view::RenderScene beam = slab(s, true, 256);
    beam.lights = {{test::sunFrom({0, 1, 0}), nullptr}};
    test::expectMean(test::traced(beam), up, 0.003 * up, fmt::format("half-space, w {}: radiance", c.albedo));
  }
}

}  // namespace
}  // namespace pileus
