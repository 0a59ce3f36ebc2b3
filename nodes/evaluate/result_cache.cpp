#include "nodes/evaluate/result_cache.h"

#include <algorithm>

namespace pileus::nodes {

CachedResult& ResultCache::at(const Key& key, const Asking& asking) {
  CachedResult& result = entries_[key];
  result.lastWanted = asking.call;
  result.lastRequest = asking.request;
  return result;
}

void ResultCache::count(CachedResult& result) {
  uncount(result, nullptr);
  if (result.complete && result.values) result.held = heldBy(*result.values);
  std::size_t held = 0;
  for (const Held& h : result.held) {
    Shared& shared = shared_[h.what];
    if (shared.owners++ == 0) shared.bytes = h.bytes, bytes_ += h.bytes;
    held += h.bytes;
  }
  // What it says beyond what can be seen, such as the maps of passes still at work.
  result.counted = result.bytes > held ? result.bytes - held : 0;
  bytes_ += result.counted;
}

void ResultCache::uncount(CachedResult& result, std::size_t* maps) {
  for (const Held& h : result.held) {
    const auto it = shared_.find(h.what);
    if (--it->second.owners > 0) continue;
    bytes_ -= it->second.bytes;
    if (maps && h.map) *maps += it->second.bytes;
    shared_.erase(it);
  }
  result.held.clear();
  bytes_ -= result.counted;
  result.counted = 0;
}

ResultCache::Entries::iterator ResultCache::drop(Entries::iterator it, std::size_t* maps) {
  uncount(it->second, maps);
  return entries_.erase(it);
}

void ResultCache::forgetTransientErrors() {
  for (auto it = entries_.begin(); it != entries_.end();) {
    const auto& error = it->second.error;
    const bool again =
        error && (error->passing || error->code == Code::Gpu || error->code == Code::Cancelled);
    it = again ? drop(it) : std::next(it);
  }
}

void ResultCache::trim(const Asking& asking, bool answered) {
  std::vector<std::pair<std::uint64_t, Key>> old;
  for (auto it = entries_.begin(); it != entries_.end();) {
    const CachedResult& result = it->second;
    const bool wanted = result.lastWanted == asking.call;
    const bool orphaned = !result.complete && (answered || result.lastWanted + kStateCalls <= asking.call);
    const bool passed = result.complete && result.passing && answered;
    if (!wanted && (orphaned || passed)) {
      it = drop(it);
      continue;
    }
    const bool protect = limit_ == 0 ? wanted : result.lastRequest + 1 >= asking.request;
    if (result.complete && !protect) old.emplace_back(result.lastWanted, it->first);
    ++it;
  }
  if (bytes_ <= limit_ && old.size() <= kMost) return;
  std::sort(old.begin(), old.end());
  std::size_t left = old.size();
  for (const auto& [wanted, key] : old) {
    if (bytes_ <= limit_ && left <= kMost) break;
    drop(entries_.find(key));
    --left;
  }
}

void ResultCache::dropUnwanted(const Asking& asking) {
  for (auto it = entries_.begin(); it != entries_.end();)
    it = it->second.lastWanted < asking.call ? drop(it) : std::next(it);
}

bool ResultCache::dropMaps(std::size_t bytes, const Asking& asking) {
  bool any = false;
  std::vector<std::pair<std::uint64_t, Key>> old;
  for (auto it = entries_.begin(); it != entries_.end();) {
    const CachedResult& result = it->second;
    const bool unwanted = result.lastWanted < asking.call;
    if (unwanted && !result.complete) {
      any = true;
      it = drop(it);
      continue;
    }
    if (unwanted && std::any_of(result.held.begin(), result.held.end(), [](const Held& h) { return h.map; }))
      old.emplace_back(result.lastWanted, it->first);
    ++it;
  }
  std::sort(old.begin(), old.end());
  std::size_t freed = 0;
  for (const auto& [wanted, key] : old) {
    if (freed >= bytes) break;
    drop(entries_.find(key), &freed);
    any = true;
  }
  return any;
}

void ResultCache::clear() {
  entries_.clear();
  shared_.clear();
  bytes_ = 0;
}

}  // namespace pileus::nodes
