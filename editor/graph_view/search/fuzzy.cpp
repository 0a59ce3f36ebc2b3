#include "editor/graph_view/search/fuzzy.h"

#include <algorithm>
#include <string>
#include <vector>

namespace pileus::editor {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool wordChar(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         (static_cast<unsigned char>(c) >= 0x80);
}

constexpr int kImpossible = -1'000'000;

}  // namespace

std::optional<int> fuzzyScore(std::string_view query, std::string_view text) {
  std::string q;
  for (const char c : query)
    if (c != ' ') q += lower(c);
  if (q.empty()) return 0;
  if (text.size() > 256) text = text.substr(0, 256);
  const std::size_t n = text.size();
  if (n == 0) return std::nullopt;
  // Best score with query letter i matched at text letter j (dynamic programming: a greedy match would miss
  // word starts).
  std::vector<int> row(n, kImpossible), next(n);
  for (std::size_t i = 0; i < q.size(); ++i) {
    int best = kImpossible;  // best of the previous row before j
    for (std::size_t j = 0; j < n; ++j) {
      next[j] = kImpossible;
      if (lower(text[j]) == q[i]) {
        const bool start = j == 0 || !wordChar(text[j - 1]);
        const int here = 10 + (start ? 12 : 0) + (i == 0 && j == 0 ? 10 : 0);
        if (i == 0) {
          next[j] = here - static_cast<int>(std::min<std::size_t>(j, 8));
        } else {
          if (best > kImpossible) next[j] = best + here;
          if (j > 0 && row[j - 1] > kImpossible) next[j] = std::max(next[j], row[j - 1] + here + 9);
        }
      }
      if (i > 0) best = std::max(best, row[j]);
    }
    row.swap(next);
  }
  const int score = *std::max_element(row.begin(), row.end());
  if (score <= kImpossible / 2) return std::nullopt;
  return score - static_cast<int>(n - std::min(n, q.size())) / 4;
}

}  // namespace pileus::editor
