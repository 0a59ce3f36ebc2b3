#pragma once
// Finished results by content key, and the state of unfinished ones. GL thread only (results may own GPU
// objects).
#include <any>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "nodes/evaluate/result_memory.h"
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
  bool passing = false;        ///< made in a draft or of what was not final: of no use once unwanted
  std::string what;
  std::vector<std::string> warnings, notes;
  double cpuMs = 0, gpuMs = 0;
  std::size_t bytes = 0;          ///< as the node reported
  std::any state;                 ///< unfinished: the node's own (EvalContext::state)
  std::uint64_t lastWanted = 0;   ///< number of the evaluate() that last asked for it
  std::uint64_t lastRequest = 0;  ///< and of the request that evaluate() was for
  std::uint64_t lastStepped = 0;  ///< number of the evaluate() that last called the node
  std::vector<Held> held;         ///< finished: what its values keep
  std::size_t counted = 0;        ///< its own part of the cache's sum, beside what it shares
};

/// The evaluate() and the request that is being answered: several calls with the same graph, targets and
/// settings are one request, until all is there.
struct Asking {
  std::uint64_t call = 0, request = 0;
};

class ResultCache {
 public:
  /// Unfinished results live for this many calls unwanted (Draft and Final take turns), or until a request is
  /// answered without them; then their jobs are cancelled.
  static constexpr std::uint64_t kStateCalls = 3;
  /// Results kept beside those of the last two requests, however small they are.
  static constexpr std::size_t kMost = 8192;

  /// Made on first use; marks it as wanted. The reference is valid until something is dropped.
  CachedResult& at(const Key& key, const Asking& asking);
  /// Is the whole result there?
  bool finished(const Key& key) const {
    const auto it = entries_.find(key);
    return it != entries_.end() && it->second.complete && !it->second.error;
  }
  /// Behind a step: what the result keeps is counted.
  void count(CachedResult& result);
  /// Errors that another try may not meet: of memory, or that it was cancelled.
  void forgetTransientErrors();
  /// After a call; `answered`: the request is complete.
  void trim(const Asking& asking, bool answered);
  /// All that this call did not ask for.
  void dropUnwanted(const Asking& asking);
  /// Old results with shadow maps that this call did not ask for, the oldest first, until so many bytes of
  /// maps have gone; unfinished ones before. False: there was none.
  bool dropMaps(std::size_t bytes, const Asking& asking);
  void setLimit(std::size_t bytes) { limit_ = bytes; }
  std::size_t limit() const { return limit_; }
  void clear();
  std::size_t bytes() const { return bytes_; }

 private:
  using Entries = std::map<Key, CachedResult>;
  struct Shared {
    std::size_t bytes = 0, owners = 0;
  };
  /// The entry behind it, and how many bytes of maps no entry keeps any more.
  Entries::iterator drop(Entries::iterator it, std::size_t* maps = nullptr);
  void uncount(CachedResult& result, std::size_t* maps);

  Entries entries_;
  std::unordered_map<const void*, Shared> shared_;
  std::size_t bytes_ = 0;  ///< of all entries, what they share once
  std::size_t limit_ = std::size_t(512) << 20;
};

}  // namespace pileus::nodes
