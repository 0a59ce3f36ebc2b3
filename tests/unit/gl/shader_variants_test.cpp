// The reference compiler takes every shader in its variants: each pair of values of two variant constants is
// in one of them, and so are all least and all greatest values. Stages are linked with each value in one.
// What the scenes of tests ask for is checked beside (tests/support/reference_compiler.h), whatever it is.
#include <algorithm>
#include <array>
#include <random>
#include <regex>
#include <set>

#include "renderer/gl/shader_library.h"
#include "tests/support/reference_compiler.h"
#include "tests/support/support.h"

namespace pileus {
namespace {

constexpr int kAbsent = -1;  ///< not defined at all

struct Constant {
  const char* name;
  std::vector<int> values;
};

/// All there are, with values that differ in what they compile. Where an entry reads a constant that is not
/// here the compiler refuses it.
const std::vector<Constant> kConstants = {{"SHAPES", {0, 1, 2, 3, 5, 7}},
                                          {"ACTIVE", {1, 2, 4}},
                                          {"OVERFLOW", {0, 1}},
                                          {"PHASE_LOBES", {kAbsent, 1}},
                                          {"EMISSION", {kAbsent, 0, 1}},
                                          {"RESUME", {kAbsent, 0, 1}},
                                          {"TINTED", {kAbsent, 0, 1}},
                                          {"ENVIRONMENT", {kAbsent, 0, 1}},
                                          {"BACKDROP", {kAbsent, 0, 1}},
                                          {"SCATTER_GRID", {kAbsent, 0, 1}},
                                          {"OCTAVES", {kAbsent, 1, 8}},
                                          {"MULTIPLE", {kAbsent, 0, 1}},
                                          {"TRANSMITTANCE", {0, 1}},
                                          {"ORDER", {kAbsent, 0, 1}},
                                          {"DISCS", {kAbsent, 0, 1}},
                                          {"ALONG", {kAbsent, 0, 1}},
                                          {"SOLIDS", {0, 1}},
                                          {"LIGHTS", {0, 1, 3}},
                                          {"DEPTH", {0, 1}},
                                          {"LOCAL_LIGHTS", {0, 1}},
                                          {"BLOCKERS", {0, 1}},
                                          {"AIR", {kAbsent, 0, 1}},
                                          {"MANY_LIGHTS", {kAbsent, 0, 1}},
                                          {"LIGHT_KINDS", {1, 2, 4, 6, 8, 16, 31}},
                                          {"METRIC_FLOATS", {4, 8, 16, 32}},
                                          {"BASIS_FLOATS", {1, 4, 7, 8, 16, 32}},
                                          {"STORES", {1, 2, 3, 4, 6, 8, 15}},
                                          {"WEIGHTS", {0, 1}},
                                          {"HORIZON", {0, 1}},
                                          {"LOOKUP_BASES", {0, 1, 2, 4, 8, 15}},
                                          {"UNIFORM_MAPS", {kAbsent, 1}},
                                          {"METRIC", {0, 1, 2, 3}},
                                          {"METRIC_COUNT", {1, 4, 8}},
                                          {"BASIS", {0, 1, 2, 3}},
                                          {"COEFFICIENTS", {1, 4, 8}},
                                          {"METRIC_STORE", {kAbsent, 0, 1, 2, 3}},
                                          {"PARTS", {1, 8}},
                                          {"COEFFICIENT_STORE", {0, 1}},
                                          {"STORE", {0, 1, 2, 3}},
                                          {"INTERVALS", {1, 2, 4, 8}},
                                          {"BRICKS", {0, 1}},
                                          {"PROBES", {0, 64}},
                                          {"DAMPING", {0, 1}},
                                          {"PERSPECTIVE", {0, 1}},
                                          {"BATCHED", {0, 1}},
                                          {"STEP_HALVES", {1, 2}},
                                          {"WINDOWED", {0, 1}},
                                          {"FILL", {0, 1}},
                                          {"FILTER", {1, 2, 4}},
                                          {"TERMS", {4, 8, 16, 32}},
                                          {"IN_FLOATS", {64}},
                                          {"OUT_FLOATS", {80}}};

/// Those an entry reads, in itself or in what it includes.
std::vector<Constant> constantsOf(const std::string& text) {
  static const std::regex word("[A-Z][A-Z0-9_]+");
  std::set<std::string> words;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) words.insert(it->str());
  std::vector<Constant> out;
  std::copy_if(kConstants.begin(), kConstants.end(), std::back_inserter(out),
               [&](const Constant& c) { return words.contains(c.name); });
  return out;
}

/// Rows of places in the constants' values: every pair of values of any two constants is in one.
std::vector<std::vector<std::size_t>> everyPair(const std::vector<Constant>& constants) {
  using Row = std::vector<std::size_t>;
  const std::size_t n = constants.size();
  Row least(n, 0), greatest, first;  // first: number of a constant's first value among all
  std::size_t values = 0, left = 0;
  for (const Constant& c : constants) {
    greatest.push_back(c.values.size() - 1);
    first.push_back(values);
    values += c.values.size();
  }
  std::vector<bool> open(values * values, false);
  const auto pair = [&](std::size_t a, std::size_t i, std::size_t b, std::size_t j) {
    return (first[a] + i) * values + first[b] + j;
  };
  std::vector<std::array<std::size_t, 4>> pairs;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      for (std::size_t i = 0; i <= greatest[a]; ++i)
        for (std::size_t j = 0; j <= greatest[b]; ++j) {
          pairs.push_back({a, i, b, j});
          open[pair(a, i, b, j)] = true;
          ++left;
        }
  std::vector<Row> rows;
  const auto count = [&](const Row& row, bool close) {
    std::size_t sum = 0;
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = a + 1; b < n; ++b) {
        const std::size_t at = pair(a, row[a], b, row[b]);
        sum += open[at];
        if (close) open[at] = false;
      }
    return sum;
  };
  const auto take = [&](const Row& row) {
    left -= count(row, true);
    rows.push_back(row);
  };
  take(least);
  if (greatest != least) take(greatest);
  // Of some random rows with an open pair in each the one that closes most.
  std::mt19937_64 random(5);
  while (left > 0) {
    std::erase_if(pairs, [&](const auto& p) { return !open[pair(p[0], p[1], p[2], p[3])]; });
    Row best;
    std::size_t most = 0;
    for (int attempt = 0; attempt < 20; ++attempt) {
      const auto& [a, i, b, j] = pairs[random() % pairs.size()];
      Row row;
      for (const Constant& c : constants) row.push_back(random() % c.values.size());
      row[a] = i, row[b] = j;
      if (const std::size_t here = count(row, false); here > most) best = row, most = here;
    }
    take(best);
  }
  return rows;
}

/// Every value of each constant is in one.
std::vector<std::vector<std::size_t>> everyValue(const std::vector<Constant>& constants) {
  std::size_t most = 1;
  for (const Constant& c : constants) most = std::max(most, c.values.size());
  std::vector<std::vector<std::size_t>> rows(most);
  for (std::size_t r = 0; r < most; ++r)
    for (const Constant& c : constants) rows[r].push_back(r % c.values.size());
  return rows;
}

gl::Defines definesOf(const std::vector<Constant>& constants, const std::vector<std::size_t>& row) {
  gl::Defines defines;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (const int value = constants[i].values[row[i]]; value != kAbsent)
      defines.emplace_back(constants[i].name, value);
  return defines;
}

TEST(ShaderVariants, TheReferenceCompilerTakesThemAll) {
  if (!test::hasReferenceCompiler()) GTEST_SKIP() << "glslangValidator is not installed";
  const std::filesystem::path folder = test::scratchFolder();
  std::size_t programs = 0, linked = 0;
  for (const std::string& entry : gl::ShaderLibrary::entries()) {
    const std::string text = gl::ShaderLibrary::source(entry, {}).value().text;
    const std::vector<Constant> constants = constantsOf(text);
    for (const std::vector<std::size_t>& row : everyPair(constants)) {
      ASSERT_TRUE(gl::ShaderLibrary::writeSources(folder, {entry}, definesOf(constants, row)));
      ++programs;
    }
    // Stages together take a call each, so that not every pair of values is worth it.
    const auto at = entry.find(".frag.");
    if (at == entry.npos) continue;
    const std::string vertex = entry.substr(0, at) + ".vert.glsl";
    const std::vector<Constant> both = constantsOf(text + gl::ShaderLibrary::source(vertex, {}).value().text);
    for (const std::vector<std::size_t>& row : everyValue(both)) {
      ASSERT_TRUE(gl::ShaderLibrary::writeSources(folder, {vertex, entry}, definesOf(both, row)));
      ++linked;
    }
  }
  EXPECT_GT(programs, 300u);
  EXPECT_GT(linked, 10u);
  EXPECT_EQ(test::refusedPrograms(folder), "");
}

}  // namespace
}  // namespace pileus
