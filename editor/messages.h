#pragma once
// One-line messages of the status line: they never block and fade on their own.
#include <string>

#include "renderer/base/log.h"
#include "renderer/base/profile.h"

namespace pileus::editor {

class Messages {
 public:
  /// Shown in the status line and kept in the log.
  void info(std::string text) { set(log::Level::Info, std::move(text)); }
  void warn(std::string text) { set(log::Level::Warning, std::move(text)); }
  void error(std::string text) { set(log::Level::Error, std::move(text)); }
  /// What was just done, where it can be seen anyway: not logged.
  void note(std::string text) { level_ = log::Level::Info, text_ = std::move(text), age_.restart(); }
  /// A refusal or hint that is no event of its own: not logged.
  void hint(std::string text) { level_ = log::Level::Warning, text_ = std::move(text), age_.restart(); }

  bool visible() const { return !text_.empty() && age_.ms() < lifeMs(); }
  double msLeft() const { return visible() ? lifeMs() - age_.ms() : 0; }
  const std::string& text() const { return text_; }
  log::Level level() const { return level_; }

 private:
  double lifeMs() const {
    return level_ == log::Level::Error ? 20000 : level_ == log::Level::Warning ? 9000 : 5000;
  }
  void set(log::Level level, std::string text) {
    log::write(level, text);
    level_ = level, text_ = std::move(text), age_.restart();
  }
  log::Level level_ = log::Level::Info;
  std::string text_;
  Stopwatch age_;
};

}  // namespace pileus::editor
