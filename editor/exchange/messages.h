#pragma once
// What the editor says without stopping anyone: notices in the corner of the window (toasts.h) and one quiet
// line in the status bar. Neither ever takes a key or a click that was meant for something else.
#include <algorithm>
#include <deque>
#include <string>

#include "renderer/base/log.h"
#include "renderer/base/profile.h"

namespace pileus::editor {

/// A notice in the corner, perhaps with a button.
struct Notice {
  int id = 0;
  log::Level level = log::Level::Info;
  std::string text, button;
  std::string command;  ///< of the button, by id; "" = there is no button
  Stopwatch age;

  double lifeMs() const {
    return level == log::Level::Error                         ? 20000
           : level == log::Level::Warning || !command.empty() ? 9000
                                                              : 4000;
  }
  double msLeft() const { return lifeMs() - age.ms(); }
};

class Messages {
 public:
  static constexpr std::size_t kMost = 4;  ///< notices at once; the oldest make room

  /// Notices, which are also in the log.
  void info(std::string text) { add(log::Level::Info, std::move(text)); }
  void warn(std::string text) { add(log::Level::Warning, std::move(text)); }
  void error(std::string text) { add(log::Level::Error, std::move(text)); }
  /// A notice with a button: "Restored the camera" [Undo].
  void offer(std::string text, std::string button, std::string command) {
    add(log::Level::Info, std::move(text), std::move(button), std::move(command));
  }
  /// In the status line: what was just done, where it can be seen anyway. Not logged.
  void note(std::string text) { say(log::Level::Info, std::move(text)); }
  /// In the status line: a refusal or hint that is no event of its own. Not logged.
  void hint(std::string text) { say(log::Level::Warning, std::move(text)); }

  const std::deque<Notice>& notices() const { return notices_; }  ///< oldest first
  void dismiss(int id) {
    std::erase_if(notices_, [id](const Notice& n) { return n.id == id; });
  }
  /// The pointer is on it: it stays while it is read.
  void hold(int id) {
    for (Notice& n : notices_)
      if (n.id == id) n.age.restart();
  }
  void dropOld() {
    std::erase_if(notices_, [](const Notice& n) { return n.msLeft() <= 0; });
  }

  bool lineVisible() const { return !line_.empty() && lineAge_.ms() < lineLifeMs(); }
  const std::string& line() const { return line_; }
  log::Level lineLevel() const { return lineLevel_; }

  /// Milliseconds until something fades by itself; negative: nothing will.
  double msLeft() const {
    double least = lineVisible() ? lineLifeMs() - lineAge_.ms() : -1;
    for (const Notice& n : notices_) least = least < 0 ? n.msLeft() : std::min(least, n.msLeft());
    return notices_.empty() && !lineVisible() ? -1 : std::max(least, 0.0);
  }
  const std::string& text() const { return text_; }  ///< the last one of any kind

 private:
  double lineLifeMs() const { return lineLevel_ == log::Level::Warning ? 9000 : 5000; }
  void say(log::Level level, std::string text) {
    lineLevel_ = level, line_ = text_ = std::move(text);
    lineAge_.restart();
  }
  void add(log::Level level, std::string text, std::string button = {}, std::string command = {}) {
    log::write(level, text);
    text_ = text;
    // The same once more is not two notices.
    std::erase_if(notices_, [&](const Notice& n) { return n.level == level && n.text == text; });
    notices_.push_back({++lastId_, level, std::move(text), std::move(button), std::move(command), {}});
    while (notices_.size() > kMost) notices_.pop_front();
  }

  std::deque<Notice> notices_;
  int lastId_ = 0;
  log::Level lineLevel_ = log::Level::Info;
  std::string line_, text_;
  Stopwatch lineAge_;
};

}  // namespace pileus::editor
