#include "renderer/base/log.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <array>
#include <chrono>
#include <deque>
#include <mutex>

namespace pileus::log {
namespace {

constexpr std::size_t kHistory = 2000;

std::shared_ptr<spdlog::logger> makePrinter() {
  auto printer =
      std::make_shared<spdlog::logger>("pileus", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  printer->set_pattern("%^%l:%$ %v");
  printer->set_level(spdlog::level::warn);
  return printer;
}

/// Whole before any thread sees it.
struct State {
  std::mutex mutex;
  std::deque<Line> lines;
  std::array<std::size_t, 4> counts{};
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  const std::shared_ptr<spdlog::logger> printer = makePrinter();
};

State& state() {
  static State s;
  return s;
}

spdlog::level::level_enum toSpdlog(Level level) {
  switch (level) {
    case Level::Debug:
      return spdlog::level::debug;
    case Level::Info:
      return spdlog::level::info;
    case Level::Warning:
      return spdlog::level::warn;
    case Level::Error:
      return spdlog::level::err;
  }
  return spdlog::level::err;
}

}  // namespace

void setPrintLevel(Level level) { state().printer->set_level(toSpdlog(level)); }

void write(Level level, std::string text) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  s.printer->log(toSpdlog(level), text);
  ++s.counts[static_cast<std::size_t>(level)];
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - s.start).count();
  s.lines.push_back({level, seconds, std::move(text)});
  if (s.lines.size() > kHistory) s.lines.pop_front();
}

std::vector<Line> history() {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  return {s.lines.begin(), s.lines.end()};
}

std::size_t count(Level level) {
  State& s = state();
  const std::lock_guard lock(s.mutex);
  return s.counts[static_cast<std::size_t>(level)];
}

}  // namespace pileus::log
