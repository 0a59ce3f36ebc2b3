#pragma once
// An X server without a screen, and input into it as if from devices.
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/math.h"

using XDisplay = struct _XDisplay;

namespace pileus::test {

/// Starts a program in its own process group, its output in `log`.
pid_t launch(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
             const std::filesystem::path& log);

class XServer {
 public:
  /// Chooses a free display; fails the test where the server does not start. `folder` gets its frame buffer.
  XServer(ivec2 screen, const std::filesystem::path& folder);
  ~XServer();
  XServer(const XServer&) = delete;

  bool running() const { return display_ != nullptr; }
  const std::string& variable() const { return variable_; }  ///< DISPLAY=:N

  void move(int x, int y);
  void button(int button, bool down);
  /// "a", "Return", "ctrl+shift+z"; false: there is no such key.
  bool stroke(const std::string& name);
  bool key(const std::string& name, bool down);
  bool type(const std::string& text);  ///< false: a character has no key of its own; nothing was typed
  void mark(unsigned count);           ///< the count-th of the keys F13 to F24
  static constexpr unsigned kMarks = 12;

  unsigned long windowOf(pid_t process);  ///< 0 = none is shown
  void focus(unsigned long window);
  void place(unsigned long window, int x, int y);
  void close(unsigned long window);  ///< as the button in a title bar does

  /// RGBA, from the frame buffer's file (an X window dump); empty where that cannot be read.
  std::vector<float> pixels(ivec2& size) const;

 private:
  struct Stroke {
    unsigned code = 0;
    bool shift = false;
  };
  std::optional<Stroke> find(const std::string& name) const;
  void send(unsigned code, bool down);

  std::filesystem::path folder_;
  std::string variable_;
  pid_t process_ = 0;
  XDisplay* display_ = nullptr;
};

}  // namespace pileus::test
