#include "tests/ui/x_server.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "renderer/base/file.h"

// After all others: their macros are words like None and Success.
#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>

namespace pileus::test {
namespace {

constexpr unsigned kFirstMark = 191;  // F13's code; F24 has 202
constexpr unsigned kShift = 50;

int onError(Display* display, XErrorEvent* event) {
  char text[256] = {};
  XGetErrorText(display, event->error_code, text, sizeof text);
  ADD_FAILURE() << "the X server says: " << text;
  return 0;
}

/// The names people give the keys to the left of the space bar.
std::string symbolOf(const std::string& name) {
  if (name == "ctrl") return "Control_L";
  if (name == "shift") return "Shift_L";
  if (name == "alt") return "Alt_L";
  return name;
}

unsigned long processOf(Display* display, Window window) {
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0, process = 0;
  unsigned char* data = nullptr;
  if (XGetWindowProperty(display, window, XInternAtom(display, "_NET_WM_PID", False), 0, 1, False,
                         XA_CARDINAL, &type, &format, &count, &left, &data) != Success)
    return 0;
  if (data && count == 1 && format == 32) process = *reinterpret_cast<unsigned long*>(data);
  if (data) XFree(data);
  return process;
}

}  // namespace

pid_t launch(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
             const std::filesystem::path& log) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that is killed leaves nothing behind
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

XServer::XServer(ivec2 screen, const std::filesystem::path& folder) : folder_(folder) {
  int ready[2];
  if (::pipe(ready) != 0) return;
  ::fcntl(ready[0], F_SETFD, FD_CLOEXEC);
  process_ = launch({"Xvfb", "-displayfd", std::to_string(ready[1]), "-screen", "0",
                     std::to_string(screen.x) + "x" + std::to_string(screen.y) + "x24", "+extension", "GLX",
                     "-nolisten", "tcp", "-fbdir", folder.string()},
                    {}, folder / "server.log");
  ::close(ready[1]);
  std::string number;
  char c = 0;
  while (::read(ready[0], &c, 1) == 1 && c != '\n') number += c;
  ::close(ready[0]);
  variable_ = "DISPLAY=:" + number;
  XSetErrorHandler(onError);
  if (!number.empty()) display_ = XOpenDisplay((":" + number).c_str());
  if (!display_) {
    const Result<std::string> log = readFile(folder / "server.log");
    ADD_FAILURE() << "Xvfb did not start (apt-get install xvfb): " << (log ? *log : "");
  }
}

XServer::~XServer() {
  if (display_) XCloseDisplay(display_);
  if (process_ <= 0) return;
  ::kill(-process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void XServer::move(int x, int y) {
  XTestFakeMotionEvent(display_, -1, x, y, CurrentTime);
  XFlush(display_);
}

void XServer::button(int button, bool down) {
  XTestFakeButtonEvent(display_, static_cast<unsigned>(button), down, CurrentTime);
  XFlush(display_);
}

/// Two presses of one key with the same time would be taken for one: the server is past its millisecond.
void XServer::send(unsigned code, bool down) {
  XTestFakeKeyEvent(display_, code, down, CurrentTime);
  XSync(display_, False);
  if (down) std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

std::optional<XServer::Stroke> XServer::find(const std::string& name) const {
  const KeySym wanted = XStringToKeysym(symbolOf(name).c_str());
  if (wanted == NoSymbol) return std::nullopt;
  for (const int level : {0, 1})
    for (unsigned code = 8; code < kFirstMark; ++code)
      if (XkbKeycodeToKeysym(display_, static_cast<KeyCode>(code), 0, level) == wanted)
        return Stroke{code, level == 1};
  return std::nullopt;
}

bool XServer::key(const std::string& name, bool down) {
  const std::optional<Stroke> stroke = find(name);
  if (!stroke) return false;
  if (stroke->shift && down) send(kShift, true);
  send(stroke->code, down);
  if (stroke->shift && !down) send(kShift, false);
  return true;
}

bool XServer::stroke(const std::string& name) {
  std::vector<std::string> keys;
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t end = std::min(name.find('+', at), name.size());
    keys.push_back(name.substr(at, end - at));
    at = end + 1;
  }
  for (const std::string& k : keys)
    if (!find(k)) return false;
  for (const std::string& k : keys) key(k, true);
  for (auto k = keys.rbegin(); k != keys.rend(); ++k) key(*k, false);
  return true;
}

bool XServer::type(const std::string& text) {
  std::vector<Stroke> strokes;
  for (const char c : text) {
    const char* symbol = c > 0 ? XKeysymToString(static_cast<KeySym>(c)) : nullptr;  // ASCII: its own symbol
    const std::optional<Stroke> stroke = symbol ? find(symbol) : std::nullopt;
    if (!stroke) return false;
    strokes.push_back(*stroke);
  }
  for (const Stroke& s : strokes) {
    if (s.shift) send(kShift, true);
    send(s.code, true);
    send(s.code, false);
    if (s.shift) send(kShift, false);
  }
  return true;
}

void XServer::mark(unsigned count) {
  for (const bool down : {true, false})
    XTestFakeKeyEvent(display_, kFirstMark + count % kMarks, down, CurrentTime);
  XFlush(display_);
}

unsigned long XServer::windowOf(pid_t process) {
  Window root = 0, parent = 0, found = 0;
  Window* children = nullptr;
  unsigned count = 0;
  if (!XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count)) return 0;
  for (unsigned i = 0; i < count; ++i) {
    XWindowAttributes attributes;
    if (processOf(display_, children[i]) == static_cast<unsigned long>(process) &&
        XGetWindowAttributes(display_, children[i], &attributes) && attributes.map_state == IsViewable)
      found = children[i];
  }
  if (children) XFree(children);
  return found;
}

void XServer::focus(unsigned long window) {
  XSetInputFocus(display_, window, RevertToParent, CurrentTime);
  XSync(display_, False);
}

void XServer::place(unsigned long window, int x, int y) {
  XMoveWindow(display_, window, x, y);
  XSync(display_, False);
}

void XServer::close(unsigned long window) {
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
  event.xclient.data.l[1] = CurrentTime;
  XSendEvent(display_, window, False, NoEventMask, &event);
  XSync(display_, False);
}

std::vector<float> XServer::pixels(ivec2& size) const {
  const Result<std::string> dump = readFile(folder_ / "Xvfb_screen0");
  if (!dump || dump->size() < 100) return {};
  const auto word = [&](std::size_t i) {
    const auto* b = reinterpret_cast<const unsigned char*>(dump->data()) + 4 * i;
    return std::size_t(b[0]) << 24 | std::size_t(b[1]) << 16 | std::size_t(b[2]) << 8 | b[3];
  };
  const std::size_t width = word(4), height = word(5), stride = word(12), start = word(0) + 12 * word(19);
  if (start + stride * height > dump->size()) return {};
  std::vector<float> rgba(width * height * 4, 1.0f);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        rgba[4 * (y * width + x) + c] =
            static_cast<float>(static_cast<unsigned char>((*dump)[start + y * stride + 4 * x + 2 - c])) /
            255.0f;
  size = {static_cast<int>(width), static_cast<int>(height)};
  return rgba;
}

}  // namespace pileus::test
