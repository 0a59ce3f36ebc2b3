#include "nodes/evaluate/result_cache.h"

#include <algorithm>

namespace pileus::nodes {
namespace {

/// Every result counts as at least this much, so that a long session of small ones is bounded as well.
constexpr std::size_t kLeastBytes = std::size_t(64) << 10;

std::size_t cost(const CachedResult& result) { return std::max(result.bytes, kLeastBytes); }

}  // namespace

CachedResult& ResultCache::at(const Key& key, std::uint64_t call) {
  CachedResult& result = entries_[key];
  result.lastWanted = call;
  return result;
}

void ResultCache::trim(std::uint64_t call) {
  std::erase_if(entries_, [&](const auto& entry) {
    return !entry.second.complete && entry.second.lastWanted + kStateCalls <= call;
  });
  std::size_t total = 0;
  std::vector<std::pair<std::uint64_t, Key>> old;
  for (const auto& [key, result] : entries_) {
    total += cost(result);
    if (result.complete && result.lastWanted + kKeepCalls <= call) old.emplace_back(result.lastWanted, key);
  }
  if (total <= limit_) return;
  std::sort(old.begin(), old.end());
  for (const auto& [wanted, key] : old) {
    if (total <= limit_) break;
    const auto it = entries_.find(key);
    total -= cost(it->second);
    entries_.erase(it);
  }
}

}  // namespace pileus::nodes
