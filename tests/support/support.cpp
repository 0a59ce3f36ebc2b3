#include "tests/support/support.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>

namespace fs = std::filesystem;

namespace pileus::test {
namespace {

struct Scratch {
  fs::path root;
  int next = 0;
  Scratch() {
    std::string pattern = (fs::temp_directory_path() / "pileus-test-XXXXXX").string();
    root = ::mkdtemp(pattern.data());
  }
  ~Scratch() {
    std::error_code ec;
    fs::remove_all(root, ec);
  }
};

}  // namespace

std::optional<fs::path> dataFolder() {
  const char* value = std::getenv("PILEUS_TEST_DATA");
  if (!value || !*value || !fs::is_directory(value)) return std::nullopt;
  return fs::path(value);
}

fs::path scratchFolder() {
  static Scratch scratch;
  const fs::path folder = scratch.root / std::to_string(scratch.next++);
  fs::create_directories(folder);
  return folder;
}

RunResult run(const std::vector<std::string>& arguments, double timeoutSeconds,
              const std::vector<std::string>& environment) {
  int out[2], err[2];
  if (::pipe(out) != 0 || ::pipe(err) != 0) return {};
  const pid_t child = ::fork();
  if (child == 0) {
    ::setpgid(0, 0);
    ::dup2(out[1], 1);
    ::dup2(err[1], 2);
    for (int fd : {out[0], out[1], err[0], err[1]}) ::close(fd);
    const int null = ::open("/dev/null", O_RDONLY);
    ::dup2(null, 0);
    for (const std::string& e : environment) ::putenv(const_cast<char*>(e.c_str()));
    std::vector<char*> argv;
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  ::close(out[1]);
  ::close(err[1]);
  RunResult result;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeoutSeconds);
  pollfd fds[2] = {{out[0], POLLIN, 0}, {err[0], POLLIN, 0}};
  std::string* sinks[2] = {&result.out, &result.err};
  bool killed = false;
  for (int open = 2; open > 0;) {
    if (::poll(fds, 2, 100) > 0) {
      for (int i = 0; i < 2; ++i) {
        if (fds[i].fd < 0 || !(fds[i].revents & (POLLIN | POLLHUP | POLLERR))) continue;
        char chunk[8192];
        const ssize_t n = ::read(fds[i].fd, chunk, sizeof chunk);
        if (n > 0)
          sinks[i]->append(chunk, static_cast<std::size_t>(n));
        else if (n == 0) {
          ::close(fds[i].fd);
          fds[i].fd = -1;
          --open;
        }
      }
    }
    if (!killed && std::chrono::steady_clock::now() > end) {
      ::kill(-child, SIGKILL);
      killed = true;
      result.err += "\n[killed: time limit]";
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

RunResult pileus(std::vector<std::string> arguments, double timeoutSeconds,
                 const std::vector<std::string>& environment) {
  arguments.insert(arguments.begin(), PILEUS_BINARY);
  RunResult result = run(arguments, timeoutSeconds, environment);
  if (result.exitCode == 0 && !ExpectLogged::lives()) checkLog(result.err);
  return result;
}

void checkLog(const std::string& log, const std::vector<std::string>& expected) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("warning: ") && !line.starts_with("error: ")) continue;
    if (std::none_of(expected.begin(), expected.end(),
                     [&](const std::string& part) { return line.find(part) != std::string::npos; }))
      ADD_FAILURE() << "unexpected in the log of the program: " << line;
  }
}

}  // namespace pileus::test
