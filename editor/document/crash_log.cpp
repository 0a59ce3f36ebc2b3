#include "editor/document/crash_log.h"

#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>

#include "renderer/base/file.h"

namespace fs = std::filesystem;

namespace pileus::editor::crash {
namespace {

constexpr unsigned kEvents = 200;
constexpr std::size_t kLength = 96, kFact = 501;
constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// Everything the handler reads is plain memory that exists from the start: it may neither allocate nor lock.
char ring[kEvents][kLength];
std::atomic<unsigned> written{0};
char graph[kFact], device[kFact], target[1024];
std::array<char, 64 * 1024> stack;

template <std::size_t N>
void copy(char (&to)[N], std::string_view from) {
  const std::size_t n = std::min(from.size(), N - 1);
  for (std::size_t i = 0; i < n; ++i) to[i] = static_cast<unsigned char>(from[i]) < 32 ? ' ' : from[i];
  to[n] = 0;
}

void say(int fd, const char* text) {
  if (::write(fd, text, std::strlen(text)) < 0) return;
}

void sayNumber(int fd, long value) {
  char digits[24];
  int at = 23;
  digits[at] = 0;
  do {
    digits[--at] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value > 0 && at > 0);
  say(fd, digits + at);
}

const char* signalName(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "SIGSEGV (invalid memory)";
    case SIGBUS:
      return "SIGBUS (a mapped file became shorter, or invalid memory)";
    case SIGFPE:
      return "SIGFPE (arithmetic)";
    case SIGILL:
      return "SIGILL (invalid instruction)";
    case SIGABRT:
      return "SIGABRT (a check failed)";
  }
  return "a signal";
}

void onCrash(int signal, siginfo_t*, void*) {
  const int fd = ::open(target, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (fd >= 0) {
    say(fd, "Pileus " PILEUS_VERSION " ended with ");
    say(fd, signalName(signal));
    say(fd, "\ntime:  ");
    sayNumber(fd, static_cast<long>(::time(nullptr)));
    say(fd, "\ngraph: ");
    say(fd, graph[0] ? graph : "(unnamed)");
    say(fd, "\nGPU:   ");
    say(fd, device);
    say(fd, "\n\nlast events, newest last:\n");
    const unsigned end = written.load();
    for (unsigned i = end > kEvents ? end - kEvents : 0; i < end; ++i) {
      say(fd, ring[i % kEvents]);
      say(fd, "\n");
    }
    say(fd, "\nstack:\n");
    void* frames[64];
    ::backtrace_symbols_fd(frames, ::backtrace(frames, 64), fd);
    ::close(fd);
  }
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

}  // namespace

fs::path folder() { return stateFolder() / "crashes"; }

void install(const fs::path& where) {
  std::error_code ec;
  fs::create_directories(where, ec);
  copy(target, (where / fmt::format("crash-{}-{}.txt", ::time(nullptr), ::getpid())).string());
  void* first[1];
  ::backtrace(first, 1);  // loads what it needs now, not in the handler
  const stack_t own{stack.data(), 0, stack.size()};
  ::sigaltstack(&own, nullptr);  // also a full stack can be reported
  struct sigaction action {};
  action.sa_sigaction = onCrash;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int signal : kSignals) ::sigaction(signal, &action, nullptr);
}

void setGraph(std::string_view path) { copy(graph, path); }
void setDevice(std::string_view text) { copy(device, text); }

void note(std::string_view text) {
  const unsigned i = written.load();
  copy(ring[i % kEvents], text);
  written.store(i + 1);
}

std::vector<std::string> events() {
  std::vector<std::string> out;
  const unsigned end = written.load();
  for (unsigned i = end > kEvents ? end - kEvents : 0; i < end; ++i) out.emplace_back(ring[i % kEvents]);
  return out;
}

std::vector<fs::path> takeNewReports(const fs::path& where) {
  std::vector<fs::path> reports, old;
  std::error_code ec;
  for (fs::directory_iterator it(where, ec), end; !ec && it != end; it.increment(ec)) {
    const std::string name = it->path().filename().string();
    if (name.starts_with("crash-") && name.ends_with(".txt")) reports.push_back(it->path());
    if (name.starts_with("seen-crash-")) old.push_back(it->path());
  }
  // A mentioned report gets another name; the last twenty are kept.
  for (fs::path& report : reports) {
    const fs::path seen = where / ("seen-" + report.filename().string());
    fs::rename(report, seen, ec);
    if (!ec) report = seen;
  }
  std::sort(old.begin(), old.end());
  for (std::size_t i = 0; i + 20 < old.size(); ++i) fs::remove(old[i], ec);
  std::sort(reports.rbegin(), reports.rend());
  return reports;
}

}  // namespace pileus::editor::crash
