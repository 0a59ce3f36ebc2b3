#include "tests/ui/ui_session.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "renderer/base/file.h"
#include "renderer/image/png.h"
#include "tests/ui/x_server.h"

namespace pileus::test {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr double kBusy = 2;         // two windows at once: each has half of the machine
constexpr double kPatience = 60;    // for a window to take its input; the slowest machine has it
constexpr double kTwoClicks = 0.4;  // apart, so that they are no double click (0.3)
constexpr double kOnePlace = 8;     // pixels: nearer clicks may be joined (6)
// Frames until everything shows: what is under the pointer, and popups, need a second one.
constexpr int kFrames = 2;

std::filesystem::path beside(const char* name) {
  return std::filesystem::path(PILEUS_BINARY).parent_path() / name;
}

double middle(const json& rect, std::size_t axis) {
  return 0.5 * (rect[axis].get<double>() + rect[axis + 2].get<double>());
}

}  // namespace

bool wantsScreenshots() {
  const char* value = std::getenv("PILEUS_SCREENSHOTS");
  return value && *value && std::string_view(value) != "0";
}

std::string textOf(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path);
  return text ? *text : std::string();
}

bool hasLink(const json& trace, const std::string& link) {
  for (const json& l : trace["document"]["links"])
    if (l == link) return true;
  return false;
}

double cpuSeconds(pid_t pid) {
  const std::string stat = textOf("/proc/" + std::to_string(pid) + "/stat");
  std::istringstream fields(stat.substr(stat.rfind(')') + 2));
  std::string skip;
  for (int i = 0; i < 11; ++i) fields >> skip;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// What went to the window and what is known of it.
struct UiSession::Sent {
  unsigned long long marks = 0, acknowledged = 0;
  Point pointer;
  struct Press {
    Point at{-1e9, -1e9};
    double time = -1e9;
  } presses[6];
  Clock::time_point quiet;  ///< since the window has handled everything
  std::shared_ptr<const json> newest = std::make_shared<json>(json::object());  ///< the last trace read
  struct stat file {};                                                          ///< it was read from
};

UiSession::UiSession(ivec2 screen, const std::vector<std::string>& arguments, const json& settings,
                     const std::filesystem::path& home, const std::vector<std::string>& environment)
    : screen_(screen),
      folder_(home.empty() ? scratchFolder() : home),
      server_(std::make_shared<XServer>(screen, folder_)),
      sent_(std::make_unique<Sent>()) {
  const std::filesystem::path file = folder_ / "config" / "pileus" / "settings.json";
  json all = {{"window", {screen.x, screen.y}}, {"showStart", false}};
  if (!home.empty() && std::filesystem::exists(file)) all = json::parse(textOf(file));
  all.update(settings);
  start(arguments, all, environment);
}

UiSession::UiSession(const UiSession& other, int below, ivec2 size, const std::vector<std::string>& arguments)
    : screen_(other.screen_),
      folder_(scratchFolder()),
      server_(other.server_),
      below_(below),
      sent_(std::make_unique<Sent>()) {
  start(arguments, {{"window", {size.x, size.y}}, {"showStart", false}}, {});
  if (!running_) return;
  server_->place(server_->windowOf(app_), 0, below);
  acknowledge(kFrames);
}

void UiSession::start(const std::vector<std::string>& arguments, const json& settings,
                      const std::vector<std::string>& environment) {
  std::filesystem::create_directories(folder_ / "config" / "pileus");
  std::ofstream(folder_ / "config" / "pileus" / "settings.json") << settings.dump();
  std::filesystem::remove(tracePath());
  if (!server_->running()) return;
  std::vector<std::string> all{PILEUS_BINARY};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables{server_->variable(),
                                     "LIBGL_ALWAYS_SOFTWARE=1",
                                     "PILEUS_UI_SCALE=1",
                                     "PILEUS_UI_TRACE=" + tracePath().string(),
                                     "XDG_CONFIG_HOME=" + (folder_ / "config").string(),
                                     "XDG_CACHE_HOME=" + (folder_ / "cache").string(),
                                     "XDG_STATE_HOME=" + (folder_ / "state").string(),
                                     "HOME=" + folder_.string()};
  variables.insert(variables.end(), environment.begin(), environment.end());
  app_ = launch(all, variables, folder_ / "app.log");
  running_ = waitFor([](const json& t) { return t["rects"].contains("canvas"); }, kPatience / kBusy);
}

UiSession::~UiSession() {
  if (testing::Test::HasFailure()) {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    screenshot(std::string("failed-") + test->test_suite_name() + "." + test->name());
  }
  if (app_ > 0) {
    int status = 0;
    if (::waitpid(app_, &status, WNOHANG) == app_ && status != 0)
      ADD_FAILURE() << "the program ended by itself, "
                    << (WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                            : "exit code " + std::to_string(WEXITSTATUS(status)));
    ::kill(-app_, SIGKILL);
    ::waitpid(app_, nullptr, 0);
  }
  if (const auto faults = newest()->value("glFaults", 0); faults > 0)
    ADD_FAILURE() << "OpenGL has found " << faults << " errors";
  checkLog(log(), expected_);
}

std::string UiSession::log() const { return textOf(folder_ / "app.log"); }

bool UiSession::ended() const {
  siginfo_t info{};
  return app_ <= 0 || ::waitid(P_PID, static_cast<id_t>(app_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         info.si_pid == app_;
}

/// Read only when the file is another one; each trace is a new file.
std::shared_ptr<const json> UiSession::newest() const {
  struct stat now {};
  if (::stat(tracePath().c_str(), &now) != 0) return sent_->newest;
  const struct stat& then = sent_->file;
  if (now.st_ino == then.st_ino && now.st_size == then.st_size && now.st_mtim.tv_sec == then.st_mtim.tv_sec &&
      now.st_mtim.tv_nsec == then.st_mtim.tv_nsec)
    return sent_->newest;
  json read = json::parse(textOf(tracePath()), nullptr, false);
  if (!read.is_object()) return sent_->newest;
  sent_->file = now;
  return sent_->newest = std::make_shared<json>(std::move(read));
}

json UiSession::trace() const { return *newest(); }

bool UiSession::waitFor(const Condition& condition, double seconds) const {
  const auto start = Clock::now();
  for (bool last = false;; last = ended()) {
    const std::shared_ptr<const json> t = newest();
    if (!t->empty() && condition(*t)) return true;
    if (last || secondsSince(start) > kBusy * seconds) return false;
    pause(0.004);
  }
}

bool UiSession::waitRect(const std::string& name, double seconds) const {
  return waitFor([&](const json& t) { return t["rects"].contains(name); }, seconds);
}

void UiSession::finishPicture(double seconds) const {
  if (!waitFor([](const json& t) { return t["complete"] == true; }, seconds))
    ADD_FAILURE() << "the picture is not finished after " << seconds << " s\n" << log();
}

void UiSession::settle() const {
  json last, now = trace()["rects"];
  for (int i = 0; i < 100 && now != last; ++i) {
    acknowledge(kFrames);
    pause(0.05);
    last = std::exchange(now, trace()["rects"]);
  }
}

Point UiSession::center(const std::string& rect) const {
  if (!waitRect(rect)) throw std::runtime_error("nothing called " + rect + " is on the screen");
  const json r = trace()["rects"][rect];
  return {middle(r, 0), middle(r, 1)};
}

Point UiSession::emptySpot() const {
  const json t = trace();
  const json& canvas = t["rects"]["canvas"];
  const double left = canvas[0], top = canvas[1], right = canvas[2], bottom = canvas[3];
  std::vector<std::array<double, 4>> nodes;
  for (const auto& [name, r] : t["rects"].items())
    if (name.starts_with("node/")) nodes.push_back({r[0], r[1], r[2], r[3]});
  Point best;
  double bestDistance = -1;
  for (double x = left + 20; x < right - 20; x += 10)
    for (double y = top + 20; y < bottom - 20; y += 10) {
      double nearest = std::min({x - left, right - x, y - top, bottom - y});
      for (const auto& r : nodes)
        nearest = std::min(
            nearest, std::hypot(std::max({r[0] - x, 0.0, x - r[2]}), std::max({r[1] - y, 0.0, y - r[3]})));
      if (nearest > bestDistance) bestDistance = nearest, best = {x, y};
    }
  return best;
}

void UiSession::mark(int frames) const {
  for (int i = 0; i < frames; ++i) {
    if (sent_->marks - sent_->acknowledged >= XServer::kMarks) acknowledge(0);
    server_->mark(static_cast<unsigned>(sent_->marks++ % XServer::kMarks));
  }
}

void UiSession::acknowledge(int frames) const {
  mark(frames);
  const auto marks = [&] { return newest()->value("marks", 0ull); };
  for (const auto start = Clock::now(); marks() < sent_->marks && !ended();) {
    if (secondsSince(start) > kPatience) {
      sent_->acknowledged = sent_->marks = marks();
      throw std::runtime_error("the window does not take its input");
    }
    pause(0.002);
  }
  sent_->acknowledged = sent_->marks;
  sent_->quiet = Clock::now();
}

void UiSession::move(Point p) const {
  sent_->pointer = {static_cast<double>(std::lround(p.x)), static_cast<double>(std::lround(p.y))};
  server_->move(static_cast<int>(sent_->pointer.x), static_cast<int>(sent_->pointer.y) + below_);
  acknowledge(kFrames);
}

/// As soon as it makes no double click. By the window's clock: input that waits for a slow frame does not
/// age.
void UiSession::down(int button) const {
  Sent::Press& last = sent_->presses[std::clamp(button, 0, 5)];
  const Point p = sent_->pointer;
  const double since = newest()->value("time", 0.0) + secondsSince(sent_->quiet) - last.time;
  if (since < kTwoClicks && std::hypot(p.x - last.at.x, p.y - last.at.y) < kOnePlace)
    pause(kTwoClicks - since);
  server_->button(button, true);
}

void UiSession::release(int button) const {
  server_->button(button, false);
  acknowledge(kFrames);
  pressed(button);
}

void UiSession::pressed(int button) const {
  sent_->presses[std::clamp(button, 0, 5)] = {sent_->pointer, newest()->value("time", 0.0)};
}

void UiSession::press(Point p, int button) const {
  move(p);
  down(button);
  acknowledge(kFrames);
}

void UiSession::click(Point p, int button) const {
  move(p);
  down(button);
  release(button);
}

void UiSession::click(Point p, const std::vector<std::string>& held, int button) const {
  for (const std::string& k : held) server_->key(k, true);
  click(p, button);
  for (const std::string& k : held) server_->key(k, false);
  acknowledge(kFrames);
}

/// All at once, so that it is one however slow the frames are.
void UiSession::doubleClick(Point p) const {
  move(p);
  down(1);
  server_->button(1, false);
  server_->button(1, true);
  release(1);
}

void UiSession::dragTo(Point from, Point to) const {
  for (int i = 1; i <= 6; ++i) {
    sent_->pointer = {static_cast<double>(std::lround(from.x + (to.x - from.x) * i / 6)),
                      static_cast<double>(std::lround(from.y + (to.y - from.y) * i / 6))};
    server_->move(static_cast<int>(sent_->pointer.x), static_cast<int>(sent_->pointer.y) + below_);
    mark(1);
  }
  acknowledge(kFrames);
}

void UiSession::drag(Point from, Point to, const std::vector<std::string>& held, int button,
                     const std::function<void()>& during) const {
  for (const std::string& k : held) server_->key(k, true);
  press(from, button);
  dragTo(from, to);
  if (during) during();
  release(button);
  for (const std::string& k : held) server_->key(k, false);
  if (!held.empty()) acknowledge(kFrames);
}

void UiSession::focus() const {
  server_->focus(server_->windowOf(app_));
  acknowledge(kFrames);
}

void UiSession::close() const {
  server_->close(server_->windowOf(app_));
  acknowledge(kFrames);
}

void UiSession::key(const std::string& name) const { input({"key", name}); }

void UiSession::type(const std::string& text) const {
  if (!waitFor([](const json& t) { return t["typing"] == true; }))
    throw std::runtime_error("no field takes \"" + text + "\"");
  input({"type", text});
}

void UiSession::input(const std::vector<std::string>& words) const {
  const auto foreign = [&](const std::string& command, const std::string& argument) {
    const RunResult r = run({"xdotool", command, "--", argument}, 20, {server_->variable()});
    if (r.exitCode != 0) ADD_FAILURE() << "xdotool failed: " << r.err;
  };
  std::vector<int> buttons;
  for (std::size_t i = 0; i < words.size();) {
    const std::string& command = words[i++];
    int repeat = 1;
    for (; i < words.size() && words[i].starts_with("--"); ++i) {
      if (words[i] == "--repeat") repeat = std::stoi(words.at(i + 1));
      if (words[i] != "--") ++i;
    }
    const std::string& argument = words.at(i++);
    if (command == "mousemove") {
      sent_->pointer = {std::stod(argument), std::stod(words.at(i++))};
      server_->move(static_cast<int>(sent_->pointer.x), static_cast<int>(sent_->pointer.y) + below_);
    } else if (command == "mousedown") {
      server_->button(std::stoi(argument), true);
    } else if (command == "mouseup") {
      server_->button(std::stoi(argument), false);
      buttons.push_back(std::stoi(argument));
    } else if (command == "click") {
      buttons.push_back(std::stoi(argument));
      for (int n = 0; n < repeat; ++n)
        for (const bool isDown : {true, false}) server_->button(std::stoi(argument), isDown);
    } else if (command == "keydown" || command == "keyup") {
      if (!server_->key(argument, command == "keydown")) foreign(command, argument);
    } else if (command == "key") {
      if (!server_->stroke(argument)) foreign(command, argument);
    } else if (command == "type") {
      if (!server_->type(argument)) foreign(command, argument);
    } else {
      ADD_FAILURE() << "no input is called " << command;
    }
  }
  acknowledge(kFrames);
  for (const int b : buttons) pressed(b);
}

int UiSession::waitExit(double seconds) {
  for (const auto start = Clock::now(); secondsSince(start) < seconds; pause(0.02)) {
    int status = 0;
    if (::waitpid(app_, &status, WNOHANG) == app_) {
      app_ = 0;
      return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
  }
  return -1;
}

void UiSession::screenshot(const std::string& name) const {
  if (!wantsScreenshots() && !testing::Test::HasFailure()) return;
  pause(0.4);  // the server draws on its own
  ivec2 size(0);
  const std::vector<float> rgba = server_->pixels(size);
  if (rgba.empty()) return void(ADD_FAILURE() << "no frame buffer to take a screenshot of");
  std::filesystem::create_directories(beside("screenshots"));
  const Result<void> written = image::writePng(beside("screenshots") / (name + ".png"), size, rgba.data());
  if (!written) ADD_FAILURE() << written.error().message;
}

json param(const UiSession& ui, const std::string& node, const std::string& id) {
  const json t = ui.trace();
  const json& n = t["document"]["nodes"][node];
  return n.contains("params") && n["params"].contains(id) ? n["params"][id] : json();
}

bool becomes(const UiSession& ui, const std::string& node, const std::string& id, const json& value) {
  return ui.waitFor([&](const json&) { return param(ui, node, id) == value; }, 8);
}

}  // namespace pileus::test
