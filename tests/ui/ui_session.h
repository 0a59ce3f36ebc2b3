#pragma once
// A real window to test with: starts Xvfb and the built binary, sends real input through the X server's XTest
// extension and reads where things are from the binary's trace. Input is acknowledged: what sends some
// returns once the window has handled it and drawn what follows, and no trace from before that is ever looked
// at.
#include <sys/types.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "renderer/base/math.h"
#include "tests/support/support.h"

namespace pileus::test {

using nlohmann::json;

std::string textOf(const std::filesystem::path& path);  ///< "" where there is no such file
bool hasLink(const json& trace, const std::string& link);
double cpuSeconds(pid_t pid);  ///< of processor time a process has used
/// Where the time itself is the subject; input needs none.
void pause(double seconds);

struct Point {
  double x = 0, y = 0;
};

/// $PILEUS_SCREENSHOTS: every screenshot is written, not only those of tests that fail.
bool wantsScreenshots();

class XServer;

class UiSession {
 public:
  using Condition = std::function<bool(const json&)>;

  /// `settings` joins those every session starts with; `home`: the folder of an earlier session, to go on
  /// with what it left. `environment`: "NAME=value", after those of every session.
  UiSession(ivec2 screen, const std::vector<std::string>& arguments, const json& settings = json::object(),
            const std::filesystem::path& home = {}, const std::vector<std::string>& environment = {});
  /// A second window on another session's screen, `below` pixels down.
  UiSession(const UiSession& other, int below, ivec2 size, const std::vector<std::string>& arguments);
  /// Fails the test where the log of the window and its children holds a warning or an error that was not
  /// expected, where OpenGL has found an error, and where the program has ended by itself.
  ~UiSession();
  UiSession(const UiSession&) = delete;

  const std::filesystem::path& folder() const { return folder_; }  ///< of configuration, cache and state
  bool running() const { return running_; }
  pid_t process() const { return app_; }
  std::string log() const;
  /// Warnings and errors with this in them may be in the window's log.
  void expectLogged(std::string part) { expected_.push_back(std::move(part)); }

  /// The newest one; it knows of all input sent.
  json trace() const;
  /// Looks at every new trace; false when the program has ended, and after `seconds` (twice as many:
  /// the machine may be busy with other tests).
  [[nodiscard]] bool waitFor(const Condition& condition, double seconds = 20) const;
  [[nodiscard]] bool waitRect(const std::string& name, double seconds = 20) const;
  bool shows(const std::string& rect) const { return trace()["rects"].contains(rect); }  ///< now
  /// The picture is finished; a test that waits in vain has failed.
  void finishPicture(double seconds = 80) const;
  /// Until nothing moves on the screen any more.
  void settle() const;
  /// Waits for it; a test that clicks on what is not there ends here: throws.
  Point center(const std::string& rect) const;
  /// A point of the canvas as far as can be from nodes.
  Point emptySpot() const;

  /// Words of xdotool: mousemove, click, mousedown, mouseup, key, keydown, keyup, type; several in a row.
  void input(const std::vector<std::string>& words) const;
  void move(Point p) const;
  /// Two clicks in one place keep the distance that makes them two.
  void click(Point p, int button = 1) const;
  void click(const std::string& rect, int button = 1) const { click(center(rect), button); }
  void click(Point p, const std::vector<std::string>& held, int button = 1) const;
  void doubleClick(Point p) const;
  void press(Point p, int button = 1) const;
  void dragTo(Point from, Point to) const;
  void release(int button = 1) const;
  void drag(Point from, Point to) const { drag(from, to, {}); }
  /// With keys held down meanwhile, "ctrl", "y" ...; `during` looks at the screen before the button is
  /// released.
  void drag(Point from, Point to, const std::vector<std::string>& held, int button = 1,
            const std::function<void()>& during = {}) const;
  /// Keys go to this window: without a window manager the one opened last keeps them.
  void focus() const;
  /// Asks the window to close, as the button in its title bar does.
  void close() const;
  void key(const std::string& name) const;
  /// Into the field that takes text; waits for one.
  void type(const std::string& text) const;

  /// Exit code once the program ends; -1 if it does not within `seconds`.
  int waitExit(double seconds = 20);

  /// With $PILEUS_SCREENSHOTS, or once the test has failed: screenshots/NAME.png beside the binary.
  void screenshot(const std::string& name) const;

 private:
  std::filesystem::path tracePath() const { return folder_ / "trace.json"; }
  void start(const std::vector<std::string>& arguments, const json& settings,
             const std::vector<std::string>& environment);
  void down(int button) const;
  void pressed(int button) const;
  void mark(int frames) const;  ///< of input so far; see Window::marks()
  void acknowledge(int frames) const;
  bool ended() const;
  std::shared_ptr<const json> newest() const;

  ivec2 screen_;
  std::filesystem::path folder_;
  std::shared_ptr<XServer> server_;
  pid_t app_ = 0;
  bool running_ = false;
  int below_ = 0;  ///< where the window lies on the screen
  std::vector<std::string> expected_;
  struct Sent;
  std::unique_ptr<Sent> sent_;
};

/// A parameter as the document holds it now; null where it has its default.
json param(const UiSession& ui, const std::string& node, const std::string& id);
/// Will it be that soon?
bool becomes(const UiSession& ui, const std::string& node, const std::string& id, const json& value);

}  // namespace pileus::test
