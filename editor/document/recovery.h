#pragma once
// Unsaved work survives a crash: some seconds after the last change the graph is written to a recovery file
// by a job. A set of files belongs to one document of one running editor, which holds a lock on it; a set
// whose lock is free was left behind and is offered at the next start. The user's own file is never touched.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"
#include "renderer/base/jobs.h"
#include "renderer/base/profile.h"

namespace pileus::editor {

inline constexpr int kRecoveryFiles = 10;        ///< kept of a set, newest ones
inline constexpr double kRecoverySeconds = 5.0;  ///< of rest after the last change

/// Where sets lie: recovery/ in the state folder.
std::filesystem::path recoveryFolder();

/// Writes recovery files of the document that is open. UI thread; the disk is touched by jobs only.
class Recovery {
 public:
  /// `folder`: where sets lie. Nothing is created before something needs saving.
  explicit Recovery(std::filesystem::path folder = recoveryFolder(), double restSeconds = kRecoverySeconds);
  ~Recovery();  ///< joins the job; the set stays: discard() removes it

  /// What is open now. `resting`: nothing is being dragged or typed. Starts a job when it is time.
  void watch(const nodes::Graph& graph, std::uint64_t revision, const std::filesystem::path& path, bool dirty,
             bool resting);
  /// Seconds until watch() has something to do; negative: nothing is due.
  double dueSeconds() const;
  /// At once and on this thread: the program is being ended from outside.
  Result<void> saveNow(const nodes::Graph& graph, const std::filesystem::path& path);
  /// The document was saved, closed or given up: its set goes.
  void discard();
  /// Of the last job, once; "" = none.
  std::string takeError();
  int written() const { return written_; }  ///< recovery files so far

 private:
  struct Set;
  void begin(const nodes::Graph& graph, const std::filesystem::path& path);
  std::filesystem::path folder_;
  double rest_;
  std::shared_ptr<Set> set_;
  std::unique_ptr<Job<bool>> job_;
  std::uint64_t seen_ = 0, saved_ = 0;  ///< revisions
  std::filesystem::path path_;
  bool dirty_ = false;
  Stopwatch age_;
  std::string error_;
  int written_ = 0;
};

/// Work that an editor left behind.
struct Lost {
  std::filesystem::path set;       ///< its folder
  std::filesystem::path file;      ///< newest recovery file
  std::filesystem::path original;  ///< the document it belongs to; empty: it was never saved
  std::int64_t time = 0;           ///< of the recovery file, seconds since 1970
};

/// Sets that no living editor holds, newest first; only such as are newer than their document and differ
/// from it. Others of them (and empty or unreadable ones) are removed on the way.
std::vector<Lost> findLost(const std::filesystem::path& folder = recoveryFolder());
void removeLost(const Lost& lost);

}  // namespace pileus::editor
