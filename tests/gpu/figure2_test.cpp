// Figure 2 of the paper through the real maps: ray family "two", 200 seeded rays.
#include "editor/cli/ray_families.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

using shadow::Basis;
using shadow::Metric;

TEST(Figure2, PseudometricBeatsEuclid) {
  const auto scene = cli::makeRayScene(cli::rayFamily("two"), 200, 2);
  ASSERT_TRUE(scene) << scene.error().message;
  const auto mean = [&](Metric metric, Basis basis, int coefficients) {
    const auto e = cli::measure(test::renderer().gpu(), *scene, {metric, 4, 4}, {basis, coefficients});
    EXPECT_TRUE(e);
    return e->mean;
  };
  const double euclid = mean(Metric::None, Basis::Fourier, 12), paper = mean(Metric::Fourier, Basis::Fourier, 8), interval = mean(Metric::Interval, Basis::Cosine, 8),
               cosine = mean(Metric::Cosine, Basis::Cosine, 8);
  std::printf("mean |dT|: Fourier 12 Euclidean %.4f, Fourier 4 + 8 %.4f, cosine 4 + 8 %.4f, interval + cosine 8 %.4f\n", euclid, paper, cosine, interval);
  EXPECT_LE(2 * paper, euclid);
  EXPECT_LE(4 * interval, euclid);
}

}  // namespace
}  // namespace pileus
