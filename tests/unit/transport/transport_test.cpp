// The transport of scattered light on a lattice: ordinates, diffusion and sweeps against what is known
// exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "renderer/transport/diffusion.h"
#include "renderer/transport/ordinates.h"
#include "renderer/transport/solve.h"
#include "renderer/transport/sweep.h"

namespace pileus::transport {
namespace {

/// n cells of a uniform medium, by its place in 0..1.
template <class Fill>
Cells cellsOf(ivec3 n, double edge, const Fill& fill) {
  Cells out;
  out.lattice = {dvec3(0), edge, n};
  out.cells.resize(out.lattice.count());
  std::size_t i = 0;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x, ++i) fill(out.cells[i], (dvec3(x, y, z) + 0.5) / dvec3(n));
  markOpenFaces(out);
  return out;
}

void scatter(Cell& cell, double extinction, double albedo, double cosine = 0) {
  cell.extinction = vec4(vec3(float(extinction)), 0);
  cell.scattering = vec4(vec3(float(extinction * albedo)), 0);
  cell.forward = vec4(vec3(float(extinction * albedo * cosine)), 0);
}
void give(Cell& cell, double power, const dvec3& ahead = dvec3(0)) {
  for (vec4& f : cell.first) f = vec4(vec3(ahead), float(power));
}

Solution solved(const Cells& cells, const SolveOptions& options = {}) {
  JobControl control;
  Result<Solution> made = solve(cells, options, control);
  EXPECT_TRUE(made) << made.error().message;
  return made ? made.value() : Solution{};
}

double balance(const Solution& s) { return (s.kept.x + s.left.x) / s.given.x - 1; }

/// Clouds with holes, one face lit.
Cells cloud(int n, double depth, double albedo, double cosine) {
  return cellsOf(ivec3(n), 1.0 / n, [&](Cell& cell, const dvec3& p) {
    const double r = glm::length(p - 0.5);
    if (r > 0.45 || std::sin(18 * p.x) * std::sin(14 * p.y + 1) * std::sin(16 * p.z) < -0.2) return;
    scatter(cell, depth / 0.9, albedo, cosine);
    const double through = std::exp(-depth * (1 - p.z));
    give(cell, depth * albedo * through, dvec3(0, 0, -cosine * depth * albedo * through));
  });
}

TEST(Ordinates, IntegratePolynomialsOfDegreeFive) {
  const Ordinates set = ordinates();
  double all = 0, second = 0, fourth = 0, mixed = 0;
  for (std::size_t m = 0; m < kOrdinates; ++m) {
    const dvec3 d = set.direction[m];
    EXPECT_NEAR(glm::length(d), 1, 1e-12);
    all += 8 * set.weight[m];
    second += 8 * set.weight[m] * d.x * d.x;
    fourth += 8 * set.weight[m] * d.x * d.x * d.x * d.x;
    mixed += 8 * set.weight[m] * d.x * d.x * d.y * d.y;
  }
  EXPECT_NEAR(all, 4 * kPi, 1e-12);
  EXPECT_NEAR(second, 4 * kPi / 3, 1e-12);
  EXPECT_NEAR(fourth, 4 * kPi / 5, 1e-12);
  EXPECT_NEAR(mixed, 4 * kPi / 15, 1e-12);
}

TEST(Lattice, KnowsTheOpenFacesOfSolids) {
  // A wall of 1 x 3 x 3 cells in a corner.
  const Cells cells =
      cellsOf(ivec3(3), 1, [](Cell& cell, const dvec3& p) { cell.extinction.w = p.x < 0.4 ? 1 : 0; });
  const auto open = [&](int cell) { return int(cells.cells[std::size_t(cell)].glow.w); };
  EXPECT_EQ(open(0), 1 + 2 + 4 + 16) << "both along x, and where the lattice ends along y and z";
  EXPECT_EQ(open(9 + 3), 1 + 2) << "in the middle";
  EXPECT_EQ(open(1), 0) << "no solid";
}

TEST(Lattice, ThinsWhatIsDense) {
  Cells cells = cellsOf(ivec3(2, 1, 1), 0.5, [](Cell& cell, const dvec3& p) {
    const float density = p.x < 0.5 ? 1.0f : 1e4f;
    cell.extinction = vec4(density, 0.5f * density, density, 0);
    cell.scattering = vec4(0.9f * density, 0.1f * density, 0, 0);
    cell.forward = vec4(0.3f * density, 0, 0, 0);
    cell.glow = vec4(5 * density, 0, 0, 0);
  });
  const Cell before = cells.cells[0];
  thinDense(cells);
  EXPECT_EQ(cells.cells[0].extinction, before.extinction);
  const Cell& thin = cells.cells[1];
  EXPECT_FLOAT_EQ(thin.extinction.x * 0.5f, 2) << "optical depth";
  EXPECT_FLOAT_EQ(thin.scattering.x / thin.extinction.x, 0.9f);
  EXPECT_FLOAT_EQ(thin.scattering.y / thin.extinction.y, 0.2f);
  EXPECT_FLOAT_EQ(thin.forward.x / thin.scattering.x, 1 / 3.0f);
  EXPECT_FLOAT_EQ(thin.glow.x / thin.extinction.x, 5);
}

TEST(Lattice, LimitsHowFarMediaScatterBack) {
  Cells cells = cellsOf(ivec3(2, 1, 1), 1,
                        [](Cell& cell, const dvec3& p) { scatter(cell, 2, 0.75, p.x < 0.5 ? -0.9 : -0.4); });
  const Cell before = cells.cells[0], mild = cells.cells[1];
  limitBackward(cells);
  EXPECT_EQ(cells.cells[1].forward, mild.forward);
  const Cell& now = cells.cells[0];
  EXPECT_FLOAT_EQ(now.forward.x / now.scattering.x, -0.5f);
  EXPECT_FLOAT_EQ(now.extinction.x - now.scattering.x, before.extinction.x - before.scattering.x);
  EXPECT_FLOAT_EQ(now.extinction.x - now.forward.x, before.extinction.x - before.forward.x);
}

TEST(Transport, KeepsEnergy) {
  for (const double albedo : {0.5, 0.99, 1.0})
    for (const double depth : {0.01, 1.0, 30.0}) {
      SolveOptions options;
      options.residual = 1e-6;
      const Solution s = solved(cloud(24, depth, albedo, 0.4), options);
      EXPECT_LE(s.residual, 1e-6) << albedo << " " << depth;
      EXPECT_NEAR(balance(s), 0, 1e-4) << albedo << " " << depth;
    }
}

TEST(Transport, NeedsFewSweeps) {
  for (const double depth : {10.0, 30.0, 100.0}) {
    SolveOptions options;
    const Solution fast = solved(cloud(32, depth, 0.99, 0), options);
    options.accelerated = options.diffusionStart = false;
    const Solution slow = solved(cloud(32, depth, 0.99, 0), options);
    std::printf("[ sweeps ] depth %g: %d, without diffusion %d\n", depth, fast.sweeps, slow.sweeps);
    EXPECT_LE(fast.sweeps, 12) << depth;
    EXPECT_LT(fast.sweeps, slow.sweeps) << depth;
  }
}

/// However dense cells are: what sweeps themselves spread there is known to diffusion.
TEST(Transport, DenseCellsNeedFewSweepsToo) {
  for (const double depth : {10.0, 1e3, 1e4})
    for (const double albedo : {1.0, 0.9}) {
      const Cells cells = cellsOf(ivec3(32), 1.0 / 32, [&](Cell& cell, const dvec3& p) {
        scatter(cell, depth, albedo);
        const double a = std::exp(-depth * (p.z - 0.5 / 32)), b = std::exp(-depth * (p.z + 0.5 / 32));
        give(cell, albedo * 32 * (a - b));
      });
      const Solution s = solved(cells);
      std::printf("[ dense ] depth %g, albedo %g: %d sweeps, balance %.1e\n", depth, albedo, s.sweeps,
                  balance(s));
      EXPECT_LE(s.sweeps, 8) << depth << " " << albedo;
      EXPECT_NEAR(balance(s), 0, 3e-3) << depth << " " << albedo;
    }
}

/// Largest difference of the integrals of radiance, in parts of their mean where light is sent on.
double difference(const Cells& cells, const Solution& a, const Solution& b) {
  double mean = 0, most = 0;
  int count = 0;
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    if (cells.cells[i].scattering.x <= 0) continue;
    mean += double(a.moments[i].w), ++count;
    most = std::max(most, std::abs(double(a.moments[i].w) - double(b.moments[i].w)));
  }
  return most / (mean / count);
}

TEST(Transport, ComesToRestAtTheSamePlaceFromAnywhere) {
  const Cells cells = cloud(32, 20, 0.99, 0.3), other = cloud(32, 5, 0.9, 0);
  const Solution cold = solved(cells);
  SolveOptions options;
  options.diffusionStart = false;
  const Solution dark = solved(cells, options);
  options.start = solved(other).moments;
  const Solution warm = solved(cells, options);
  std::printf("[ warm ] dark %.2g, warm %.2g\n", difference(cells, cold, dark),
              difference(cells, cold, warm));
  EXPECT_LT(difference(cells, cold, dark), 1e-3);
  EXPECT_LT(difference(cells, cold, warm), 1e-3);
}

TEST(Transport, IsTheSameToTheLastBitEachTime) {
  const Cells cells = cloud(20, 10, 0.99, 0.3);
  const Solution a = solved(cells), b = solved(cells);
  EXPECT_EQ(a.sweeps, b.sweeps);
  EXPECT_TRUE(a.moments == b.moments);
}

/// In an infinite medium light of a point is absorbed at a mean squared distance of 2/(sigma^2 (1-w)(1-w g)).
TEST(Transport, SpreadsAsFarAsItShould) {
  for (const auto& [albedo, cosine] : {std::pair(0.8, 0.0), std::pair(0.8, 0.5), std::pair(0.5, 0.4)}) {
    const int n = 61;
    Cells cells =
        cellsOf(ivec3(n), 1.0, [&](Cell& cell, const dvec3&) { scatter(cell, 0.5, albedo, cosine); });
    const std::size_t middle = cells.cells.size() / 2;
    give(cells.cells[middle], 1);
    SolveOptions options;
    options.residual = 1e-6;
    const Solution s = solved(cells, options);
    double all = 0, squares = 0;
    std::size_t i = 0;
    for (int z = 0; z < n; ++z)
      for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x, ++i) {
          const double r2 = double((x - 30) * (x - 30) + (y - 30) * (y - 30) + (z - 30) * (z - 30));
          all += double(s.moments[i].w), squares += r2 * double(s.moments[i].w);
        }
    const double right = 2 / (0.25 * (1 - albedo) * (1 - albedo * cosine));
    std::printf("[ spread ] albedo %g cosine %g: %.4f, right %.4f\n", albedo, cosine, squares / all, right);
    EXPECT_NEAR(squares / all / right, 1, 0.05) << albedo;
  }
}

TEST(Transport, OneChannelServesForAll) {
  Cells gray = cloud(16, 10, 0.95, 0.2), colored = gray;
  const vec3 color(1, 0.5f, 0.25f);
  for (Cell& c : colored.cells)
    for (int k = 0; k < 3; ++k) c.first[k] *= color[k];
  // The same with a hair of colour in the medium, so that each channel is solved for.
  Cells each = colored;
  each.cells[0].scattering.y += 1e-20f;
  const Solution one = solved(colored), three = solved(each);
  const std::size_t count = gray.cells.size();
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_NEAR(one.moments[c * count + i].w, three.moments[c * count + i].w,
                  2e-4f * std::max(three.moments[c * count + i].w, 0.01f));
  EXPECT_NEAR(one.given.y / one.given.x, 0.5, 1e-4);
}

TEST(Transport, FireLightsSmoke) {
  // What emits and takes nothing away: its light must come out whole.
  Cells cells = cellsOf(ivec3(20), 0.1, [](Cell& cell, const dvec3& p) {
    if (glm::length(p - 0.5) < 0.1)
      cell.glow = vec4(3, 2, 1, 0);
    else if (p.x > 0.7)
      scatter(cell, 2, 1);
  });
  const Solution s = solved(cells);
  EXPECT_NEAR(balance(s), 0, 1e-4);
  EXPECT_NEAR(s.kept.x, 0, 1e-6 * s.given.x);
  EXPECT_NEAR(s.left.y / s.left.x, 2.0 / 3, 1e-4);
}

TEST(Transport, WhiteSolidsSendAllBack) {
  for (const float albedo : {0.0f, 0.5f, 1.0f}) {
    Cells cells = cellsOf(ivec3(16), 1.0 / 16, [&](Cell& cell, const dvec3& p) {
      if (p.y < 0.1) {
        cell.extinction.w = 1;
        cell.scattering = vec4(vec3(albedo), 0);
      } else if (glm::length(p - 0.5) < 0.3) {
        scatter(cell, 5, 1);
        give(cell, 1);
      }
    });
    SolveOptions options;
    options.residual = 1e-6;
    const Solution s = solved(cells, options);
    EXPECT_NEAR(balance(s), 0, 1e-4) << albedo;
    if (albedo == 1) {
      EXPECT_NEAR(s.kept.x, 0, 1e-5 * s.given.x);
    }
    if (albedo == 0) {
      EXPECT_GT(s.kept.x, 0.05 * s.given.x);
    }
  }
}

/// A sheet that is lit from above sends nothing down, and what scatters below it sees it from there.
TEST(Transport, SheetsHaveTwoSides) {
  Cells cells = cellsOf(ivec3(15), 1.0 / 15, [](Cell& cell, const dvec3& p) {
    if (std::abs(p.y - 0.5) < 0.03) {
      cell.extinction.w = 1;
      cell.scattering = vec4(0.5f, 0.5f, 0.5f, 0);
    }
  });
  for (Cell& cell : cells.cells)
    for (int c = 0; c < 3; ++c)
      if (cell.extinction.w > 0) sentOf(cell, 3, c) = 1;  // up
  const Solution s = solved(cells);
  EXPECT_NEAR(s.given.x, 1, 1e-4);
  EXPECT_NEAR(balance(s), 0, 1e-4);
  const auto phi = [&](int y) { return s.moments[std::size_t((7 * 15 + y) * 15 + 7)].w; };
  EXPECT_GT(phi(8), 0.5f);
  EXPECT_EQ(phi(6), 0.0f);
}

TEST(Transport, AClosedWhiteBoxThatKeepsNothingIsFinite) {
  // There is no answer; what comes out must be numbers all the same.
  Cells cells = cellsOf(ivec3(8), 1, [](Cell& cell, const dvec3& p) {
    const dvec3 off = glm::abs(p - 0.5);
    if (std::max({off.x, off.y, off.z}) > 0.4) {
      cell.extinction.w = 1;
      cell.scattering = vec4(1, 1, 1, 0);
    } else {
      scatter(cell, 1, 1);
      give(cell, 1);
    }
  });
  SolveOptions options;
  options.mostSweeps = 100;
  const Solution s = solved(cells, options);
  for (const vec4& m : s.moments) ASSERT_TRUE(std::isfinite(m.x + m.y + m.z + m.w));
}

TEST(Transport, DensitiesAMillionTimesApart) {
  Cells cells = cellsOf(ivec3(24), 1, [](Cell& cell, const dvec3& p) {
    const double extinction = p.x < 0.5 ? 1e-4 : 1e2;
    scatter(cell, extinction, 0.99);
    give(cell, extinction);
  });
  const Solution s = solved(cells);
  EXPECT_LE(s.residual, 1e-4);
  EXPECT_NEAR(balance(s), 0, 1e-3);
  for (const vec4& m : s.moments) {
    ASSERT_TRUE(std::isfinite(m.x + m.y + m.z + m.w));
    ASSERT_GE(m.w, 0);
  }
}

TEST(Transport, OneCellAndNone) {
  Cells one = cellsOf(ivec3(1), 1, [](Cell& cell, const dvec3&) {
    scatter(cell, 1, 0.9);
    give(cell, 1);
  });
  EXPECT_NEAR(balance(solved(one)), 0, 1e-3);
  EXPECT_TRUE(solved(Cells{}).moments.empty());
  EXPECT_EQ(latticeOver(Box3{}, 64).count(), 0u);
  const Lattice flat = latticeOver({dvec3(0), dvec3(100, 1, 50)}, 64);
  EXPECT_EQ(flat.cells, ivec3(64, 1, 32));
}

/// A lattice within another one: what surrounds it sends its light in.
TEST(Transport, WhatLiesAroundSendsItsLightIn) {
  const auto fill = [](Cell& cell, const dvec3& p) {
    scatter(cell, glm::length(p - 0.5) < 0.2 ? 20 : 1, 0.95);
    give(cell, p.x);
  };
  const Cells whole = cellsOf(ivec3(48), 1.0 / 48, fill), coarse = cellsOf(ivec3(24), 1.0 / 24, fill);
  Cells inner = cellsOf(ivec3(24), 1.0 / 48, [&](Cell& cell, const dvec3& p) { fill(cell, 0.25 + 0.5 * p); });
  inner.lattice.min = dvec3(0.25);
  const Solution right = solved(whole), around = solved(coarse);
  SolveOptions options;
  options.around = &around;
  const Solution made = solved(inner, options);
  EXPECT_NEAR(balance(made), 0, 1e-3);
  double error = 0, alone = 0, mean = 0;
  const Solution without = solved(inner);
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const std::size_t i = std::size_t((z * 24 + y) * 24 + x),
                          j = std::size_t(((z + 12) * 48 + y + 12) * 48 + x + 12);
        mean += double(right.moments[j].w);
        error += std::abs(double(made.moments[i].w) - double(right.moments[j].w));
        alone += std::abs(double(without.moments[i].w) - double(right.moments[j].w));
      }
  std::printf("[ around ] error %.4f, without %.4f\n", error / mean, alone / mean);
  EXPECT_LT(error / mean, 0.03);
  EXPECT_GT(alone / mean, 0.2);
}

TEST(Transport, WhatIsNotFiniteIsRefused) {
  Cells cells = cloud(8, 1, 0.9, 0);
  cells.cells[100].first[1].w = std::numeric_limits<float>::infinity();
  JobControl control;
  const Result<Solution> made = solve(cells, {}, control);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, Code::Input);
}

TEST(Transport, CanBeCancelled) {
  JobControl control;
  control.cancel();
  const Result<Solution> made = solve(cloud(8, 1, 0.9, 0), {}, control);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, Code::Cancelled);
}

}  // namespace
}  // namespace pileus::transport
