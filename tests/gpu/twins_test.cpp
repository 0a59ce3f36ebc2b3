// The shader's functions against their C++ twins on random inputs.
#include <bit>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <random>

#include "renderer/shaders/shared/bindings.h"
#include "renderer/shadow/basis.h"
#include "renderer/shadow/metric.h"
#include "tests/support/gpu.h"

namespace pileus {
namespace {

using shadow::Basis;
using shadow::Metric;

constexpr int kCount = 10000, kIn = 64, kOut = 80;  // records, floats of each
constexpr std::size_t kMostTerms = 32;

/// Relative to the larger of the value and 1: sums of terms around 1 cannot be better than float rounding
/// of 1.
void expectNear(double a, double b, double scale, const char* what, int i) {
  EXPECT_NEAR(a, b, 1e-5 * std::max({1.0, std::abs(b), scale})) << what << " input " << i;
}

/// A number that carries a bit is the one it was, up to that bit, and is never subnormal.
void expectBit(const float* o, float was, int i) {
  const auto bits = std::bit_cast<std::uint32_t>(o[11]);
  EXPECT_TRUE(std::isnormal(o[11])) << was << " input " << i;
  EXPECT_EQ(bits & 1u, unsigned(i % 2)) << was << " input " << i;
  EXPECT_NEAR(o[11], was, 1.2e-38f + 1.3e-7f * std::abs(was)) << "input " << i;
  const unsigned half = glm::packHalf1x16(o[12]);
  EXPECT_NE(half & 0x7C00u, 0u) << was << " input " << i;
  EXPECT_EQ(half & 1u, unsigned(i % 2)) << was << " input " << i;
  EXPECT_NEAR(o[12], was, 6.2e-5f + 1e-3f * std::abs(was)) << "input " << i;
}

/// Steps of any width, from points to the whole of u; `terms`: what the shader has room for.
void compare(Metric metric, Basis basis, std::size_t terms = 8) {
  std::mt19937_64 rng(77);
  std::uniform_real_distribution<float> u(0, 1), s(-1, 1);
  std::vector<float> in(std::size_t(kCount * kIn));
  for (int i = 0; i < kCount; ++i) {
    float* r = &in[std::size_t(i * kIn)];
    for (int k = 0; k < 3; ++k) r[k] = 2 * s(rng), r[3 + k] = s(rng);
    r[6] = s(rng), r[7] = 0.9f * s(rng), r[8] = u(rng), r[9] = 3 * u(rng), r[10] = u(rng);
    // Most devices' sines lose their relative precision near 0: widths of every order of magnitude.
    r[11] = std::min(1.0f, r[10] + (i % 2 ? u(rng) : std::pow(10.0f, -7 * u(rng))));
    if (i % 50 == 0) r[10] = 0, r[11] = 1;
    r[24] = float(1 + i % 4), r[25] = std::floor(u(rng) * r[24]), r[26] = u(rng);
    r[27] = i % 7 == 0 ? r[26] : r[26] + (1 - r[26]) * u(rng);
    r[28] = i % 3 == 0 ? 1e-40f * s(rng) : i % 3 == 1 ? std::ldexp(s(rng), -20) : 0.0f;
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
    for (std::size_t k = 0; k < terms; ++k) r[32 + k] = k == 0 || basis == Basis::Slab ? 3 * u(rng) : s(rng);
  }
  const int metricCode = metric == Metric::Interval ? METRIC_INTERVAL
                         : metric == Metric::Cosine ? METRIC_COSINE
                                                    : METRIC_FOURIER;
  const int basisCode = basis == Basis::Cosine    ? BASIS_COSINE
                        : basis == Basis::Fourier ? BASIS_FOURIER
                                                  : BASIS_SLAB;
  auto program = test::renderer().shaders().program({"test/twins.comp.glsl"}, {{"METRIC_FLOATS", 8},
                                                                               {"BASIS_FLOATS", int(terms)},
                                                                               {"WEIGHTS", 1},
                                                                               {"IN_FLOATS", kIn},
                                                                               {"OUT_FLOATS", kOut}});
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
    EXPECT_NEAR(o[4], hg, 3e-5 * std::max(hg, 1.0));  // g to 0.9: 1 + g^2 - 2 g cos loses two digits
    std::vector<double> m(r + 16, r + 24), c(r + 32, r + 32 + terms);
    std::vector<double> w(r + 12, r + 16);
    expectNear(o[5], shadow::metricU(metric, m, r[8], w), 1, "u", i);
    if (metric != Metric::Interval) expectNear(o[6], shadow::metricFace(metric, i % 8, r[8]), 1, "face", i);
    expectNear(o[7], shadow::basisTau(basis, c, r[8]), 3, "tau", i);
    expectNear(o[8], shadow::basisTau(basis, std::span(c).first(1 + std::size_t(i) % (terms - 1)), r[8]), 3,
               "tau of fewer", i);
    const double slab = double(terms) * double(r[8]);
    if (basis != Basis::Slab || std::abs(slab - std::round(slab)) > 1e-4)
      expectNear(o[9], shadow::basisValue(basis, c, r[8]), double(terms), "value", i);
    const int pieces = int(r[24]), piece = int(r[25]);
    expectNear(o[10], shadow::pieceTau(c, pieces, piece, r[8]), 6, "tau of pieces", i);
    std::vector<double> projected(terms, 0.0), pieced(terms, 0.0);
    shadow::projectStep(basis, projected, r[9], r[10], r[11]);
    shadow::projectPiece(pieced, r[9], pieces, piece, r[26], r[27]);
    for (std::size_t k = 0; k < terms; ++k) {
      expectNear(o[16 + k], projected[k], 6, "projection", i);
      expectNear(o[16 + terms + k], pieced[k], 6, "projection of a piece", i);
    }
    expectBit(o, r[28], i);
  }
}

TEST(Twins, CosineMetricAndBasis) { compare(Metric::Cosine, Basis::Cosine); }
TEST(Twins, FourierMetricAndBasis) { compare(Metric::Fourier, Basis::Fourier); }
TEST(Twins, IntervalMetricAndSlabs) { compare(Metric::Interval, Basis::Slab); }
TEST(Twins, ManyTerms) {
  for (const std::size_t terms : {std::size_t(12), std::size_t(16), kMostTerms})
    for (const Basis basis : {Basis::Cosine, Basis::Fourier, Basis::Slab})
      compare(Metric::Interval, basis, terms);
}

}  // namespace
}  // namespace pileus
