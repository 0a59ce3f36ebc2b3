#pragma once
// Fuzzy matching for searches: "blr" finds Blur.
#include <optional>
#include <string_view>

namespace pileus::editor {

/// Higher is better; nothing if `query`'s letters (case and spaces ignored) do not occur in `text` in order.
/// Runs of letters, word starts and a match at the beginning score; letters left out cost a little. An empty
/// query matches everything with 0.
std::optional<int> fuzzyScore(std::string_view query, std::string_view text);

}  // namespace pileus::editor
