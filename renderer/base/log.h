#pragma once
// The log: a bounded history (for the log panel) and standard error. Thread-safe.
#include <fmt/core.h>

#include <functional>
#include <string>
#include <vector>

namespace pileus::log {

enum class Level { Debug, Info, Warning, Error };

struct Line {
  Level level;
  double seconds;  ///< since start
  std::string text;
};

/// Lines below `level` are not printed on standard error; the history keeps all of them.
void setPrintLevel(Level level);
void write(Level level, std::string text);
/// The last lines, oldest first (at most 2,000 are kept).
std::vector<Line> history();
/// How many lines were ever written at `level`; tests compare it before and after.
std::size_t count(Level level);

template <class... Args>
void debug(fmt::format_string<Args...> f, Args&&... args) {
  write(Level::Debug, fmt::format(f, std::forward<Args>(args)...));
}
template <class... Args>
void info(fmt::format_string<Args...> f, Args&&... args) {
  write(Level::Info, fmt::format(f, std::forward<Args>(args)...));
}
template <class... Args>
void warn(fmt::format_string<Args...> f, Args&&... args) {
  write(Level::Warning, fmt::format(f, std::forward<Args>(args)...));
}
template <class... Args>
void error(fmt::format_string<Args...> f, Args&&... args) {
  write(Level::Error, fmt::format(f, std::forward<Args>(args)...));
}

}  // namespace pileus::log
