#pragma once
// A real window to test with: starts Xvfb and the built binary, sends real input through xdotool, reads where
// things are from the binary's trace, and keeps screenshots beside the build. Header only; one per test.
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>
#include <utility>

#include "renderer/base/file.h"
#include "renderer/image/png.h"
#include "tests/support/support.h"

namespace pileus::test {

using nlohmann::json;

inline std::string textOf(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path);
  return text ? *text : std::string();
}

inline bool hasLink(const json& trace, const std::string& link) {
  for (const json& l : trace["document"]["links"])
    if (l == link) return true;
  return false;
}

/// Seconds of processor time a process has used.
inline double cpuSeconds(pid_t pid) {
  const std::string stat = textOf("/proc/" + std::to_string(pid) + "/stat");
  std::istringstream fields(stat.substr(stat.rfind(')') + 2));
  std::string skip;
  for (int i = 0; i < 11; ++i) fields >> skip;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

inline void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// Starts a program in its own process group, its output in `log`.
inline pid_t launch(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                    const std::filesystem::path& log) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::setpgid(0, 0);
  const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(out, 1);
  ::dup2(out, 2);
  for (const std::string& e : environment) ::putenv(const_cast<char*>(e.c_str()));
  std::vector<char*> argv;
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  ::execvp(argv[0], argv.data());
  ::_exit(127);
}

struct Point {
  double x = 0, y = 0;
};

class UiSession {
 public:
  /// `settings` joins those every session starts with; `home`: the folder of an earlier session, to go on
  /// with what it left. `environment`: "NAME=value", after those of every session.
  UiSession(ivec2 screen, const std::vector<std::string>& arguments, const json& settings = json::object(),
            const std::filesystem::path& home = {}, const std::vector<std::string>& environment = {})
      : screen_(screen), folder_(home.empty() ? scratchFolder() : home) {
    std::filesystem::create_directories(folder_ / "config" / "pileus");
    const std::filesystem::path file = folder_ / "config" / "pileus" / "settings.json";
    json all_settings = {{"window", {screen.x, screen.y}}, {"showStart", false}};
    if (!home.empty() && std::filesystem::exists(file)) all_settings = json::parse(textOf(file));
    all_settings.update(settings);
    std::ofstream(file) << all_settings.dump();
    std::filesystem::remove(tracePath());
    if (!startServer()) return;
    std::vector<std::string> all{PILEUS_BINARY};
    all.insert(all.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables{display_,
                                       "LIBGL_ALWAYS_SOFTWARE=1",
                                       "PILEUS_UI_SCALE=1",
                                       "PILEUS_UI_TRACE=" + tracePath().string(),
                                       "XDG_CONFIG_HOME=" + (folder_ / "config").string(),
                                       "XDG_CACHE_HOME=" + (folder_ / "cache").string(),
                                       "XDG_STATE_HOME=" + (folder_ / "state").string(),
                                       "HOME=" + folder_.string()};
    variables.insert(variables.end(), environment.begin(), environment.end());
    app_ = launch(all, variables, folder_ / "app.log");
    running_ =
        waitFor([](const json& t) { return t.contains("rects") && t["rects"].contains("canvas"); }, 60);
  }
  /// A second window on another session's screen, `below` pixels down; that session must live longer.
  UiSession(const UiSession& other, int below, ivec2 size, const std::vector<std::string>& arguments)
      : screen_(other.screen_), folder_(scratchFolder()), display_(other.display_), below_(below) {
    std::filesystem::create_directories(folder_ / "config" / "pileus");
    std::ofstream(folder_ / "config" / "pileus" / "settings.json")
        << json{{"window", {size.x, size.y}}, {"showStart", false}}.dump();
    std::vector<std::string> all{PILEUS_BINARY};
    all.insert(all.end(), arguments.begin(), arguments.end());
    app_ = launch(
        all,
        {display_, "LIBGL_ALWAYS_SOFTWARE=1", "PILEUS_UI_SCALE=1", "PILEUS_UI_TRACE=" + tracePath().string(),
         "XDG_CONFIG_HOME=" + (folder_ / "config").string(), "XDG_CACHE_HOME=" + (folder_ / "cache").string(),
         "XDG_STATE_HOME=" + (folder_ / "state").string(), "HOME=" + folder_.string()},
        folder_ / "app.log");
    running_ =
        waitFor([](const json& t) { return t.contains("rects") && t["rects"].contains("canvas"); }, 60);
    const RunResult found = run({"xdotool", "search", "--pid", std::to_string(app_)}, 20, {display_});
    std::string id = found.out.substr(0, found.out.find('\n'));
    input({"windowmove", id, "0", std::to_string(below)});
    pause(0.3);
  }
  ~UiSession() {
    for (const pid_t pid : {app_, server_}) {
      if (pid <= 0) continue;
      ::kill(-pid, SIGKILL);
      ::waitpid(pid, nullptr, 0);
    }
  }
  UiSession(const UiSession&) = delete;

  const std::filesystem::path& folder() const { return folder_; }  ///< of configuration, cache and state
  bool running() const { return running_; }
  pid_t process() const { return app_; }
  std::string log() const { return textOf(folder_ / "app.log"); }

  json trace() const {
    const Result<std::string> text = readFile(tracePath());
    return text ? json::parse(*text, nullptr, false) : json::object();
  }
  /// Polls the trace; false after `seconds`.
  bool waitFor(const std::function<bool(const json&)>& condition, double seconds = 20) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    while (std::chrono::steady_clock::now() < end) {
      const json t = trace();
      if (t.is_object() && !t.empty() && condition(t)) return true;
      pause(0.03);
    }
    return false;
  }
  /// Until nothing moves on the screen any more.
  void settle() const {
    json last, now = trace()["rects"];
    for (int i = 0; i < 50 && now != last; ++i) {
      pause(0.3);
      last = std::exchange(now, trace()["rects"]);
    }
  }
  bool waitRect(const std::string& name, double seconds = 20) const {
    return waitFor([&](const json& t) { return t["rects"].contains(name); }, seconds);
  }
  Point center(const std::string& rect) const {
    waitRect(rect, 10);
    const json t = trace();
    if (!t["rects"].contains(rect)) {
      ADD_FAILURE() << "nothing called " << rect << " is on the screen";
      return {};
    }
    const json& r = t["rects"][rect];
    return {0.5 * (r[0].get<double>() + r[2].get<double>()), 0.5 * (r[1].get<double>() + r[3].get<double>())};
  }
  /// A point of the canvas as far as can be from nodes.
  Point emptySpot() const {
    const json t = trace();
    const json& canvas = t["rects"]["canvas"];
    Point best;
    double bestDistance = -1;
    for (double x = canvas[0].get<double>() + 20; x < canvas[2].get<double>() - 20; x += 10)
      for (double y = canvas[1].get<double>() + 20; y < canvas[3].get<double>() - 20; y += 10) {
        double nearest = std::min({x - canvas[0].get<double>(), canvas[2].get<double>() - x,
                                   y - canvas[1].get<double>(), canvas[3].get<double>() - y});
        for (const auto& [name, r] : t["rects"].items()) {
          if (!name.starts_with("node/")) continue;
          const double dx = std::max({r[0].get<double>() - x, 0.0, x - r[2].get<double>()}),
                       dy = std::max({r[1].get<double>() - y, 0.0, y - r[3].get<double>()});
          nearest = std::min(nearest, std::hypot(dx, dy));
        }
        if (nearest > bestDistance) bestDistance = nearest, best = {x, y};
      }
    return best;
  }

  void input(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "xdotool");
    const RunResult r = run(arguments, 20, {display_});
    if (r.exitCode != 0) ADD_FAILURE() << "xdotool failed: " << r.err;
  }
  void move(Point p) const {
    input({"mousemove", std::to_string(std::lround(p.x)), std::to_string(std::lround(p.y) + below_)});
  }
  void click(Point p, int button = 1) const {
    move(p);
    pause(0.15);
    input({"click", std::to_string(button)});
    pause(0.15);
  }
  void click(const std::string& rect, int button = 1) const { click(center(rect), button); }
  void press(Point p, int button = 1) const {
    move(p);
    pause(0.15);
    input({"mousedown", std::to_string(button)});
    pause(0.15);
  }
  void dragTo(Point from, Point to) const {
    for (int i = 1; i <= 6; ++i) {
      move({from.x + (to.x - from.x) * i / 6, from.y + (to.y - from.y) * i / 6});
      pause(0.05);
    }
    pause(0.3);
  }
  void release(int button = 1) const {
    input({"mouseup", std::to_string(button)});
    pause(0.15);
  }
  void drag(Point from, Point to) const {
    press(from);
    dragTo(from, to);
    release();
  }
  /// With keys held down meanwhile, "ctrl", "y" ...; `during` looks at the screen before the button is
  /// released.
  void drag(Point from, Point to, const std::vector<std::string>& held, int button = 1,
            const std::function<void()>& during = {}) const {
    for (const std::string& k : held) input({"keydown", k});
    press(from, button);
    dragTo(from, to);
    if (during) during();
    release(button);
    for (const std::string& k : held) input({"keyup", k});
    pause(0.15);
  }
  void click(Point p, const std::vector<std::string>& held, int button = 1) const {
    for (const std::string& k : held) input({"keydown", k});
    click(p, button);
    for (const std::string& k : held) input({"keyup", k});
    pause(0.15);
  }
  /// Keys go to this window: without a window manager the one opened last keeps them.
  void focus() const {
    const RunResult found =
        run({"xdotool", "search", "--onlyvisible", "--pid", std::to_string(app_)}, 20, {display_});
    input({"windowfocus", "--sync", found.out.substr(0, found.out.find('\n'))});
    pause(0.2);
  }
  void key(const std::string& name) const {
    input({"key", name});
    pause(0.15);
  }
  void type(const std::string& text) const {
    input({"type", "--delay", "15", "--", text});
    pause(0.2);
  }

  /// Exit code once the program ends; -1 if it does not within `seconds`.
  int waitExit(double seconds = 20) {
    for (double t = 0; t < seconds; t += 0.05) {
      int status = 0;
      if (::waitpid(app_, &status, WNOHANG) == app_) {
        app_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      }
      pause(0.05);
    }
    return -1;
  }

  /// screenshots/NAME.png beside the binary, from the server's frame buffer file (an X window dump).
  void screenshot(const std::string& name) const {
    pause(0.4);
    const Result<std::string> dump = readFile(folder_ / "Xvfb_screen0");
    if (!dump || dump->size() < 100) return void(ADD_FAILURE() << "no frame buffer to take a screenshot of");
    const auto word = [&](std::size_t i) {
      const auto* b = reinterpret_cast<const unsigned char*>(dump->data()) + 4 * i;
      return std::size_t(b[0]) << 24 | std::size_t(b[1]) << 16 | std::size_t(b[2]) << 8 | b[3];
    };
    const std::size_t width = word(4), height = word(5), stride = word(12), start = word(0) + 12 * word(19);
    std::vector<float> rgba(width * height * 4, 1.0f);
    if (start + stride * height > dump->size())
      return void(ADD_FAILURE() << "the frame buffer file is short");
    for (std::size_t y = 0; y < height; ++y)
      for (std::size_t x = 0; x < width; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          rgba[4 * (y * width + x) + c] =
              static_cast<float>(static_cast<unsigned char>((*dump)[start + y * stride + 4 * x + 2 - c])) /
              255.0f;
    const std::filesystem::path target = std::filesystem::path(PILEUS_BINARY).parent_path() / "screenshots";
    std::filesystem::create_directories(target);
    const Result<void> written = image::writePng(
        target / (name + ".png"), ivec2(static_cast<int>(width), static_cast<int>(height)), rgba.data());
    if (!written) ADD_FAILURE() << written.error().message;
  }

 private:
  std::filesystem::path tracePath() const { return folder_ / "trace.json"; }

  /// The server chooses a free display itself and says which when it is ready.
  bool startServer() {
    int ready[2];
    if (::pipe(ready) != 0) return false;
    ::fcntl(ready[0], F_SETFD, FD_CLOEXEC);
    server_ = launch({"Xvfb", "-displayfd", std::to_string(ready[1]), "-screen", "0",
                      std::to_string(screen_.x) + "x" + std::to_string(screen_.y) + "x24", "+extension",
                      "GLX", "-nolisten", "tcp", "-fbdir", folder_.string()},
                     {}, folder_ / "server.log");
    ::close(ready[1]);
    std::string number;
    char c = 0;
    while (::read(ready[0], &c, 1) == 1 && c != '\n') number += c;
    ::close(ready[0]);
    if (number.empty()) {
      ADD_FAILURE() << "Xvfb did not start (apt-get install xvfb): " << textOf(folder_ / "server.log");
      return false;
    }
    display_ = "DISPLAY=:" + number;
    return true;
  }

  ivec2 screen_;
  std::filesystem::path folder_;
  std::string display_;
  pid_t server_ = 0, app_ = 0;
  bool running_ = false;
  int below_ = 0;  ///< where the window lies on the screen
};

}  // namespace pileus::test
