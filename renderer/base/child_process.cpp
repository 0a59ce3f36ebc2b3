#include "renderer/base/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

extern char** environ;

namespace pileus {

Result<ChildProcess> ChildProcess::start(const std::filesystem::path& executable,
                                         const std::vector<std::string>& arguments) {
  int pipes[2][2];
  if (::pipe2(pipes[0], O_CLOEXEC) != 0) return fail(Code::Internal, "no pipe: {}", std::strerror(errno));
  if (::pipe2(pipes[1], O_CLOEXEC) != 0) {
    ::close(pipes[0][0]);
    ::close(pipes[0][1]);
    return fail(Code::Internal, "no pipe: {}", std::strerror(errno));
  }
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, pipes[0][1], 1);
  ::posix_spawn_file_actions_adddup2(&actions, pipes[1][1], 2);
  ::posix_spawn_file_actions_addclosefrom_np(&actions, 3);
  ::posix_spawnattr_init(&attributes);
  sigset_t none, defaults;
  sigemptyset(&none);
  sigemptyset(&defaults);
  for (int s : {SIGPIPE, SIGINT, SIGTERM}) sigaddset(&defaults, s);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &defaults);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  const std::string program = executable.string();
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  pid_t pid = -1;
  const int problem = ::posix_spawn(&pid, program.c_str(), &actions, &attributes, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  for (auto& p : pipes) ::close(p[1]);
  ChildProcess child;
  child.streams_[0] = pipes[0][0];
  child.streams_[1] = pipes[1][0];
  if (problem != 0) return fail(Code::Internal, "{}: cannot be run ({})", program, std::strerror(problem));
  child.pid_ = pid;
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
