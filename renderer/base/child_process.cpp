#include "renderer/base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

extern char** environ;

namespace pileus {
namespace {

/// How children begin: in a process group of their own, with no signal blocked or ignored that we block or
/// ignore, standard input from /dev/null, no file descriptors but the standard ones.
class SpawnOptions {
 public:
  SpawnOptions() {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    ::posix_spawnattr_init(&attributes_);
    sigset_t none, defaults;
    sigemptyset(&none);
    sigemptyset(&defaults);
    for (int s : {SIGPIPE, SIGINT, SIGTERM, SIGHUP}) sigaddset(&defaults, s);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setsigdefault(&attributes_, &defaults);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setflags(&attributes_,
                               POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnOptions() {
    ::posix_spawn_file_actions_destroy(&actions_);
    ::posix_spawnattr_destroy(&attributes_);
  }
  SpawnOptions(const SpawnOptions&) = delete;

  /// Standard output and error, by our descriptors.
  void streams(int out, int err) {
    ::posix_spawn_file_actions_adddup2(&actions_, out, 1);
    ::posix_spawn_file_actions_adddup2(&actions_, err, 2);
  }
  /// A path, or with `search` a name that is looked for in $PATH.
  Result<pid_t> spawn(const std::string& program, const std::vector<std::string>& arguments, bool search) {
    ::posix_spawn_file_actions_addclosefrom_np(&actions_, 3);
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    pid_t pid = -1;
    const auto call = search ? ::posix_spawnp : ::posix_spawn;
    const int problem = call(&pid, program.c_str(), &actions_, &attributes_, argv.data(), environ);
    if (problem != 0) return fail(Code::Internal, "{}: cannot be run ({})", program, std::strerror(problem));
    return pid;
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

}  // namespace

Result<void> startDetached(const std::string& program, const std::vector<std::string>& arguments) {
  SpawnOptions options;
  PILEUS_TRY(const pid_t child, options.spawn(program, arguments, true));
  std::thread([child] {
    while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
  }).detach();
  return {};
}

Result<ChildProcess> ChildProcess::start(const std::filesystem::path& executable,
                                         const std::vector<std::string>& arguments) {
  int pipes[2][2];
  if (::pipe2(pipes[0], O_CLOEXEC) != 0) return fail(Code::Internal, "no pipe: {}", std::strerror(errno));
  if (::pipe2(pipes[1], O_CLOEXEC) != 0) {
    ::close(pipes[0][0]);
    ::close(pipes[0][1]);
    return fail(Code::Internal, "no pipe: {}", std::strerror(errno));
  }
  SpawnOptions options;
  options.streams(pipes[0][1], pipes[1][1]);
  const Result<pid_t> pid = options.spawn(executable.string(), arguments, false);
  for (auto& p : pipes) ::close(p[1]);
  ChildProcess child;
  child.streams_[0] = pipes[0][0];
  child.streams_[1] = pipes[1][0];
  if (!pid) return pid.error();
  child.pid_ = *pid;
  return child;
}

ChildProcess::ChildProcess(ChildProcess&& o) noexcept
    : out(std::move(o.out)),
      err(std::move(o.err)),
      pid_(std::exchange(o.pid_, -1)),
      streams_{std::exchange(o.streams_[0], -1), std::exchange(o.streams_[1], -1)} {}

ChildProcess::~ChildProcess() {
  if (pid_ > 0) {
    kill();
    wait();
  }
  for (int fd : streams_)
    if (fd >= 0) ::close(fd);
}

bool ChildProcess::read(std::chrono::milliseconds timeout) {
  pollfd fds[2] = {{streams_[0], POLLIN, 0}, {streams_[1], POLLIN, 0}};
  if (::poll(fds, 2, static_cast<int>(timeout.count())) > 0) {
    for (int i = 0; i < 2; ++i) {
      if (streams_[i] < 0 || !(fds[i].revents & (POLLIN | POLLHUP | POLLERR))) continue;
      char chunk[65536];
      const ssize_t n = ::read(streams_[i], chunk, sizeof chunk);
      if (n > 0) {
        std::string& sink = i == 0 ? out : err;
        sink.append(chunk, static_cast<std::size_t>(n));
        if (i == 1 && err.size() > 4096) err.erase(0, err.size() - 4096);
      } else if (n == 0 || errno != EINTR) {
        ::close(streams_[i]);
        streams_[i] = -1;
      }
    }
  }
  return streams_[0] >= 0 || streams_[1] >= 0;
}

void ChildProcess::kill() {
  if (pid_ > 0) ::kill(static_cast<pid_t>(-pid_), SIGKILL);
}

int ChildProcess::wait() {
  int status = 0;
  if (pid_ <= 0) return status;
  while (::waitpid(static_cast<pid_t>(pid_), &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

}  // namespace pileus
