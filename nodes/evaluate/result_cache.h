#pragma once
// Finished results by content key, and the state of unfinished ones. GL thread only (results may own GPU
// objects).
#include <any>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "nodes/declare/value.h"
#include "renderer/base/hash.h"
#include "renderer/base/result.h"

namespace pileus::nodes {

using Values = std::shared_ptr<const std::vector<SocketValue>>;  ///< one per output

/// What is known about one content key.
struct CachedResult {
  bool complete = false;       ///< finished, successfully or not: never evaluated again
  std::optional<Error> error;  ///< as evaluate() said it, without the node's name
  Values values;               ///< null: nothing usable (yet)
  std::uint64_t revision = 0;  ///< unfinished: of the partial value
  double fraction = 0;         ///< unfinished
  bool usable = false;         ///< unfinished: values may flow on
  bool waitsForJob = false;    ///< unfinished: nothing to do on this thread until a job reports
  std::string what;
  std::vector<std::string> warnings, notes;
  double cpuMs = 0, gpuMs = 0;
  std::size_t bytes = 0;
  std::any state;                 ///< unfinished: the node's own (EvalContext::state)
  std::uint64_t lastWanted = 0;   ///< number of the evaluate() that last asked for it
  std::uint64_t lastStepped = 0;  ///< and of the one that last called the node
};

class ResultCache {
 public:
  /// Unfinished results live for this many calls unwanted (Draft and Final take turns), then their jobs are
  /// cancelled.
  static constexpr std::uint64_t kStateCalls = 3;
  /// Finished results wanted in this many last calls are never dropped.
  static constexpr std::uint64_t kKeepCalls = 4;

  /// Made on first use; marks it as wanted in `call`. The reference is valid until the next trim().
  CachedResult& at(const Key& key, std::uint64_t call);
  /// Is the whole result there?
  bool finished(const Key& key) const {
    const auto it = entries_.find(key);
    return it != entries_.end() && it->second.complete && !it->second.error;
  }
  void trim(std::uint64_t call);
  void setLimit(std::size_t bytes) { limit_ = bytes; }
  void clear() { entries_.clear(); }
  std::size_t size() const { return entries_.size(); }

 private:
  std::map<Key, CachedResult> entries_;
  std::size_t limit_ = std::size_t(512) << 20;
};

}  // namespace pileus::nodes
