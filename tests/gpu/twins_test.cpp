// The shader's functions against their C++ twins on random inputs.
#include <cmath>
#include <random>

#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/basis.h"
#include "renderer/shadow/metric.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

using shadow::Basis;
using shadow::Metric;

constexpr int kCount = 10000, kIn = 64, kOut = 40;

/// Relative to the larger of the value and 1: sums of terms around 1 cannot be better than float rounding
/// of 1.
void expectNear(double a, double b, double scale, const char* what, int i) {
  EXPECT_NEAR(a, b, 1e-5 * std::max({1.0, std::abs(b), scale})) << what << " input " << i;
}

void compare(Metric metric, Basis basis) {
  std::mt19937_64 rng(77);
  std::uniform_real_distribution<float> u(0, 1), s(-1, 1);
  std::vector<float> in(std::size_t(kCount * kIn));
  for (int i = 0; i < kCount; ++i) {
    float* r = &in[std::size_t(i * kIn)];
    for (int k = 0; k < 3; ++k) r[k] = 2 * s(rng), r[3 + k] = s(rng);
    r[6] = s(rng), r[7] = 0.9f * s(rng), r[8] = u(rng), r[9] = 3 * u(rng), r[10] = u(rng);
    r[11] = std::min(1.0f, r[10] + 0.2f * u(rng));
    for (int k = 0; k < 4; ++k) r[12 + k] = (1 + std::floor(254 * u(rng))) / 255;
    if (metric == Metric::Interval) {
      float ends[8];
      for (float& e : ends) e = u(rng);
      std::sort(ends, ends + 8);
      std::copy(ends, ends + 8, r + 16);
      if (i % 3 == 0) r[20] = r[21] = r[22] = r[23] = 1;
    } else {
      for (int k = 0; k < 8; ++k) r[16 + k] = k == 0 ? 0.5f + u(rng) : 0.3f * s(rng);
    }
    for (int k = 0; k < 8; ++k) r[32 + k] = k == 0 || basis == Basis::Slab ? 3 * u(rng) : s(rng);
  }
  const int metricCode = metric == Metric::Interval ? METRIC_INTERVAL
                         : metric == Metric::Cosine ? METRIC_COSINE
                                                    : METRIC_FOURIER;
  const int basisCode = basis == Basis::Cosine    ? BASIS_COSINE
                        : basis == Basis::Fourier ? BASIS_FOURIER
                                                  : BASIS_SLAB;
  auto program = test::renderer().shaders().program(
      {"test/twins.comp.glsl"}, {{"METRIC_FLOATS", 8}, {"BASIS_FLOATS", 8}, {"WEIGHTS", 1}});
  ASSERT_TRUE(program) << program.error().message;
  gl::Buffer input, output;
  EXPECT_TRUE(input.assign(std::span<const float>(in)));
  EXPECT_TRUE(output.reserve(std::size_t(kCount * kOut) * sizeof(float)));
  (*program)->use();
  input.bindStorage(BIND_TEST_IN);
  output.bindStorage(BIND_TEST_OUT);
  (*program)->set("count", kCount);
  (*program)->set("metric", metricCode);
  (*program)->set("metricCount", 8);
  (*program)->set("basis", basisCode);
  glDispatchCompute((kCount + 63) / 64, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<float> out(std::size_t(kCount * kOut));
  glGetNamedBufferSubData(output.id(), 0, GLsizeiptr(out.size() * sizeof(float)), out.data());
  for (int i = 0; i < kCount; ++i) {
    const float* r = &in[std::size_t(i * kIn)];
    const float* o = &out[std::size_t(i * kOut)];
    const dvec3 ro(r[0], r[1], r[2]), rd(r[3], r[4], r[5]);
    const auto cube = intersectBox(ro, rd, dvec3(-0.5), dvec3(0.5));
    // Hits within rounding of an edge may fall on either side.
    if (cube && cube->y - cube->x > 1e-4) {
      const double scale = std::max(std::abs(cube->x), std::abs(cube->y));
      expectNear(o[0], cube->x, scale, "box enter", i);
      expectNear(o[1], cube->y, scale, "box leave", i);
    }
    const auto sphere = intersectBall(ro, rd);
    if (sphere && (sphere->y - sphere->x) * glm::length(rd) > 0.05) {
      const double scale = std::max(std::abs(sphere->x), std::abs(sphere->y)) * 4;
      expectNear(o[2], sphere->x, scale, "ball enter", i);
      expectNear(o[3], sphere->y, scale, "ball leave", i);
    }
    const double g = r[7], d = 1 + g * g - 2 * g * double(r[6]);
    const double hg = (1 - g * g) / (4 * kPi * d * std::sqrt(d));
    EXPECT_NEAR(o[4], hg, 1e-5 * std::max(hg, 1.0));
    std::vector<double> m(r + 16, r + 24), c(r + 32, r + 40);
    std::vector<double> w(r + 12, r + 16);
    expectNear(o[5], shadow::metricU(metric, m, r[8], w), 1, "u", i);
    if (metric != Metric::Interval) expectNear(o[6], shadow::metricFace(metric, i % 8, r[8]), 1, "face", i);
    expectNear(o[7], shadow::basisTau(basis, c, r[8]), 3, "tau", i);
    expectNear(o[17], shadow::basisTau(basis, std::span(c).first(std::size_t(1 + i % 7)), r[8]), 3,
               "tau of fewer", i);
    const double slab = 8.0 * double(r[8]);
    if (basis != Basis::Slab || std::abs(slab - std::round(slab)) > 1e-4)
      expectNear(o[16], shadow::basisValue(basis, c, r[8]), 8, "value", i);
    std::vector<double> projected(8, 0.0);
    shadow::projectStep(basis, projected, r[9], r[10], r[11]);
    for (std::size_t k = 0; k < 8; ++k) expectNear(o[8 + k], projected[k], 6, "projection", i);
  }
}

TEST(Twins, CosineMetricAndBasis) { compare(Metric::Cosine, Basis::Cosine); }
TEST(Twins, FourierMetricAndBasis) { compare(Metric::Fourier, Basis::Fourier); }
TEST(Twins, IntervalMetricAndSlabs) { compare(Metric::Interval, Basis::Slab); }

}  // namespace
}  // namespace pileus
