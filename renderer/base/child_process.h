#pragma once
// A child process with captured standard output and error, a wall-clock limit, and death on request. Not for
// shells.
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/result.h"

namespace pileus {

class ChildProcess {
 public:
  /// Starts it in a process group of its own, standard input from /dev/null, no other file descriptors.
  /// Error: Internal.
  static Result<ChildProcess> start(const std::filesystem::path& executable,
                                    const std::vector<std::string>& arguments);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();  ///< kills and reaps

  /// Waits at most `timeout` for output; appends it. False: both streams are closed.
  bool read(std::chrono::milliseconds timeout);
  void kill();
  /// Waits for the end; the wait status of waitpid.
  int wait();

  std::string out;  ///< not yet consumed standard output
  std::string err;  ///< the last 4 KiB of standard error
  long id() const { return pid_; }

 private:
  ChildProcess() = default;
  long pid_ = -1;
  int streams_[2] = {-1, -1};
};

/// Starts a program of $PATH that goes on by itself, such as a file manager: without our file descriptors,
/// with no signal blocked, and reaped once it ends. Error: Internal.
Result<void> startDetached(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace pileus
