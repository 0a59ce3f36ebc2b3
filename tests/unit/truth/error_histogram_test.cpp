// Quantiles of counted errors, also where there are more than 32 bits can count.
#include <gtest/gtest.h>

#include "renderer/shaders/shared/compare.h"
#include "renderer/truth/shadow_error.h"

namespace pileus::truth {
namespace {

TEST(ErrorHistogram, NothingCountedIsNoError) { EXPECT_EQ(ErrorHistogram().quantile(0.95, 1), 0); }

TEST(ErrorHistogram, CountsBeyond32Bits) {
  // Three times 3e9 small errors and as many large ones: 32 bits would leave 4.1e8 of 9e9.
  std::vector<unsigned> bins(ERROR_BINS, 0u);
  const std::size_t small = 300, large = 900;
  ErrorHistogram h;
  bins[small] = 3000000000u;
  for (int i = 0; i < 3; ++i) h.add(bins);
  bins[small] = 0, bins[large] = 1000000000u;
  for (int i = 0; i < 3; ++i) h.add(bins);
  const auto magnitude = [](double bin) {
    return ERROR_LEAST * std::pow(10.0, (bin - 1) * ERROR_DECADES / (ERROR_BINS - 1));
  };
  // 9 of 12 are small.
  EXPECT_NEAR(h.quantile(0.74, 1) / magnitude(small), 1, 0.02);
  EXPECT_NEAR(h.quantile(0.76, 1) / magnitude(large), 1, 0.02);
  EXPECT_EQ(h.quantile(1, 0.01), 0.01) << "at most the largest there was";
}

}  // namespace
}  // namespace pileus::truth
