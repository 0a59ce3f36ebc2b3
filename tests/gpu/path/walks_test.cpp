// Means of random walks that are known whatever the medium does, by the path tracer's own functions.
#include "tests/support/walks.h"
#include "tests/support/noise_grid.h"

namespace pileus {
namespace {

void expectWalked(const test::Walked& w, double right, const std::string& what) {
  std::printf("  %-46s %.5f +- %.5f, right %.5f, %+.2f s.e., %.2f collisions\n", what.c_str(), w.mean,
              w.error, right, (w.mean - right) / w.error, w.collisions);
  EXPECT_LE(w.error, 0.003 * right) << what;
  EXPECT_NEAR(w.mean, right, 4 * w.error) << what;
}

struct Filling {
  const char* what;
  volume::InstanceList volumes;
};

/// Media that scatter and absorb nothing, of a size that holds the bodies, and larger than they are.
std::vector<Filling> fillings() {
  volume::Instance cloud = test::gridInstance(test::gridOf(80, test::blobs), 80, 60), turned, remapped;
  cloud.worldFromLocal = glm::scale(dmat4(1.0), dvec3(1.7)) * cloud.worldFromLocal;
  turned = remapped = cloud;
  turned.worldFromLocal = composeTransform({0.1, 0, 0}, {30, 50, 0}, dvec3(1)) * cloud.worldFromLocal;
  turned.medium.phase = scene::henyeyGreenstein(0.8);
  remapped.remap = test::table(0, 1, [](double x) { return std::sin(kPi * x); });
  remapped.medium.phase = scene::doubleHenyeyGreenstein(0.8, -0.4, 0.3);
  volume::Instance ball = test::ball({0.2, 0.1, 0}, 0.4, 6);
  ball.medium.phase = scene::rayleigh();
  std::vector<Filling> out{{"nothing but a thin fog", {test::box({0, 0, 0}, {3, 3, 3}, 0.01)}},
                           {"a box, optical depth 4", {test::box({0, 0, 0}, {3, 3, 3}, 4)}},
                           {"a grid with empty space", {cloud}},
                           {"a grid, forward", {turned}},
                           {"a grid, remapped, two lobes", {remapped}},
                           {"four that overlap", {cloud, turned, remapped, ball}}};
  for (Filling& f : out)
    for (volume::Instance& i : f.volumes) i.medium.albedo = vec3(1.0f);
  return out;
}

// Uniform light through a convex body: its mean way is 4 V / S, whatever scatters it in there (Blanco and
// Fournier 2003).
TEST(PathWalks, MeanWayThroughConvexBodies) {
  for (const Filling& f : fillings()) {
    expectWalked(test::walked(f.volumes, test::Body::UnitCube, 512, 1), 2.0 / 3,
                 fmt::format("cube, {}", f.what));
    expectWalked(test::walked(f.volumes, test::Body::UnitBall, 512, 1), 4.0 / 3,
                 fmt::format("ball, {}", f.what));
  }
}

// What a point sends out in a medium without end: <r^2> where it is absorbed, by albedo and mean cosine
// alone.
TEST(PathWalks, SquaredDistanceOfAbsorption) {
  struct Case {
    const char* what;
    scene::Phase phase;
    double cosine, albedo;
  };
  const Case cases[] = {
      {"isotropic", scene::henyeyGreenstein(0), 0, 0.5},
      {"isotropic", scene::henyeyGreenstein(0), 0, 0.9},
      {"g .85", scene::henyeyGreenstein(0.85), 0.85, 0.9},
      {"g -.5", scene::henyeyGreenstein(-0.5), -0.5, 0.8},
      {"Rayleigh", scene::rayleigh(), 0, 0.8},
      {"two lobes", scene::doubleHenyeyGreenstein(0.8, -0.4, 0.3), 0.7 * 0.8 - 0.3 * 0.4, 0.8},
      {"droplets of 10 um", scene::droplets(10), 0.86416, 0.8}};
  for (const Case& c : cases) {
    const double sigma = 2;
    volume::Instance medium = test::box({0, 0, 0}, dvec3(4000), sigma);
    medium.medium.albedo = vec3(float(c.albedo));
    medium.medium.phase = c.phase;
    expectWalked(test::walked({medium}, test::Body::Everything, 512, 2),
                 2 / (sigma * sigma * (1 - c.albedo) * (1 - c.albedo * c.cosine)),
                 fmt::format("{}, albedo {}", c.what, c.albedo));
  }
}

}  // namespace
}  // namespace pileus
