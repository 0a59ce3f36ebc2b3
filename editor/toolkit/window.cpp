#include "editor/toolkit/window.h"

#include <epoxy/gl.h>
// GLFW after epoxy, which brings the GL declarations.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "renderer/base/log.h"

namespace pileus::editor {
namespace {

std::string lastError;

void onError(int, const char* text) { lastError = text ? text : ""; }

float contentScale(GLFWwindow* window) {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::clamp(std::round(std::max(x, y) * 4) / 4, 1.0f, 4.0f);
}

/// Never larger than the screen: a remembered size may come from another one.
ivec2 fittingSize(ivec2 size) {
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (!monitor) return size.x > 0 ? size : ivec2(1440, 900);
  int x = 0, y = 0, width = 0, height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  if (size.x <= 0 || size.y <= 0) {
    float sx = 1, sy = 1;
    glfwGetMonitorContentScale(monitor, &sx, &sy);
    size = ivec2(vec2(1440, 900) * glm::clamp(vec2(sx, sy), 1.0f, 4.0f));
  }
  return width > 0 && height > 0 ? glm::min(size, ivec2(width, height)) : size;
}

/// Letters by what the key prints, so that Ctrl+Z is where the layout has it.
int layoutKey(int key, int scancode) {
  if (key < GLFW_KEY_A || key > GLFW_KEY_Z) return key;
  const char* name = glfwGetKeyName(key, scancode);
  if (name && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0) return GLFW_KEY_A + (name[0] - 'a');
  return key;
}

bool printable(int key) { return key >= GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT; }

}  // namespace

KeyPress keyPressOf(const InputEvent& e) {
  return {e.code, (e.mods & GLFW_MOD_CONTROL) != 0, (e.mods & GLFW_MOD_SHIFT) != 0,
          (e.mods & GLFW_MOD_ALT) != 0, e.repeat};
}

Result<std::unique_ptr<Window>> Window::create(const std::string& title, ivec2 size) {
  glfwSetErrorCallback(onError);
  if (!glfwInit())
    return fail(Code::Gpu, "No window can be opened: {}",
                lastError.empty() ? "no display was found" : lastError);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "pileus");
  auto window = std::unique_ptr<Window>(new Window());
  size = fittingSize(size);
  window->window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
  if (!window->window_) {
    const std::string reason = lastError;
    glfwTerminate();
    return fail(Code::Gpu, "No OpenGL 4.5 window can be opened: {}",
                reason.empty() ? "the driver gave no reason" : reason);
  }
  glfwMakeContextCurrent(window->window_);
  glfwSwapInterval(1);
  glfwSetWindowSizeLimits(window->window_, 720, 480, GLFW_DONT_CARE, GLFW_DONT_CARE);
  window->scale_ = contentScale(window->window_);
  window->title_ = title;
  window->takesMarks_ = std::getenv("PILEUS_UI_TRACE") != nullptr;

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the editor keeps its own settings
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  window->installCallbacks();
  ImGui_ImplGlfw_InitForOpenGL(window->window_, false);
  return window;
}

Window::~Window() {
  if (!window_) return;
  if (uiStarted_) ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void Window::installCallbacks() {
  glfwSetWindowUserPointer(window_, this);
  static constexpr auto of = [](GLFWwindow* w) { return static_cast<Window*>(glfwGetWindowUserPointer(w)); };
  using Kind = InputEvent::Kind;
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
    std::deque<InputEvent>& queue = of(w)->queue_;
    of(w)->pointer_ = {x, y};
    if (!queue.empty() && queue.back().kind == Kind::Move)
      queue.back().at = {x, y};
    else
      queue.push_back({Kind::Move, {x, y}});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    // Where it was, not where it is by now: behind a slow frame the pointer may be on its way elsewhere.
    dvec2 at = of(w)->pointer_;
    if (at.x < -1e8) glfwGetCursorPos(w, &at.x, &at.y);
    if (button >= 0 && button < 5)
      of(w)->queue_.push_back({Kind::Button, at, button, action == GLFW_PRESS, false, mods});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
    of(w)->queue_.push_back({Kind::Wheel, {x, y}});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
    if (of(w)->takesMarks_ && key >= GLFW_KEY_F13 && key <= GLFW_KEY_F24) {
      if (action == GLFW_PRESS) of(w)->queue_.push_back({Kind::Mark});
      return;
    }
    if (key >= 0 && key <= GLFW_KEY_LAST)
      of(w)->queue_.push_back({Kind::Key, dvec2(0), layoutKey(key, scancode), action != GLFW_RELEASE,
                               action == GLFW_REPEAT, mods});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) {
    of(w)->queue_.push_back({Kind::Char, dvec2(0), static_cast<int>(code)});
  });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
    of(w)->queue_.push_back({Kind::Focus, dvec2(0), 0, focused == GLFW_TRUE});
  });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w)->resized_ = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w)->resized_ = true; });
  glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { of(w)->resized_ = true; });
  glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* w, float, float) {
    of(w)->scale_ = contentScale(w);
    of(w)->resized_ = true;
  });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    for (int i = 0; i < count; ++i) of(w)->dropped_.emplace_back(paths[i]);
  });
}

const char* Window::systemVersion() { return glfwGetVersionString(); }

float Window::forcedScale() {
  const char* text = std::getenv("PILEUS_UI_SCALE");
  if (!text) return 0;
  const float value = std::strtof(text, nullptr);
  if (value >= 0.5f && value <= 4.0f) return value;
  log::warn("PILEUS_UI_SCALE is {}; a number from 0.5 to 4 is expected.", text);
  return 0;
}

void Window::fontsChanged(float scale) {
  ImGui::GetIO().MouseDragThreshold = 4 * scale;
  if (!uiStarted_) return;
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Window::startUi() {
  ImGui_ImplOpenGL3_Init("#version 450 core");
  uiStarted_ = true;
}

void Window::waitEvents(double seconds) {
  if (seconds <= 0)
    glfwPollEvents();
  else
    glfwWaitEventsTimeout(seconds);
}

void Window::wake() { glfwPostEmptyEvent(); }

bool Window::feed(const InputEvent& e) {
  using Kind = InputEvent::Kind;
  ImGuiIO& io = ImGui::GetIO();
  // A click or wheel notch takes effect where the pointer was: whatever follows waits.
  if (clicked_ || marked_) return false;
  if (wheeled_ && e.kind != Kind::Wheel) return false;
  if (holds && holds(e, moved_)) return false;
  switch (e.kind) {
    case Kind::Move:
      if (!keys_.empty()) return false;
      moved_ |= mouse_ != e.at;
      mouse_ = e.at;
      break;
    case Kind::Button:
      if (!keys_.empty()) return false;
      mouse_ = e.at;
      buttons_[e.code] = e.down;
      clicked_ = true;
      break;
    case Kind::Wheel:
      io.MouseWheelH += static_cast<float>(e.at.x);
      io.MouseWheel += static_cast<float>(e.at.y);
      wheeled_ = true;
      break;
    case Kind::Key: {
      const bool typing =
          io.WantTextInput && printable(e.code) && !(e.mods & (GLFW_MOD_CONTROL | GLFW_MOD_ALT));
      const bool modifier = e.code >= GLFW_KEY_LEFT_SHIFT;
      if (e.down) {
        // Which panel a key belongs to is known one frame after the pointer has come to it.
        if (moved_ && !modifier) return false;
        if (!typing && !modifier && !keys_.empty()) return false;
        if (!modifier) keys_.push_back(keyPressOf(e));
        keysDownNow_.push_back(e.code);
      } else if (modifier && !keys_.empty()) {
        return false;  // it holds for the key that went down in this frame
      } else if (!typing &&
                 std::find(keysDownNow_.begin(), keysDownNow_.end(), e.code) != keysDownNow_.end()) {
        return false;
      }
      io.KeysDown[e.code] = e.down;
      break;
    }
    case Kind::Char:
      io.AddInputCharacter(static_cast<unsigned>(e.code));
      break;
    case Kind::Focus:
      io.AddFocusEvent(e.down);
      if (!e.down) {
        std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
        std::fill(std::begin(buttons_), std::end(buttons_), false);
      }
      break;
    case Kind::Mark:
      ++marks_;
      marked_ = true;
      break;
  }
  return true;
}

void Window::beginFrame() {
  ImGuiIO& io = ImGui::GetIO();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  // Input that waited for this frame came earlier: a double click of a test is one on every machine.
  if (takesMarks_ && late_) io.DeltaTime = std::min(io.DeltaTime, 0.05f);
  // The interface is laid out in pixels of the frame buffer, so that fonts are as sharp as the screen is.
  ivec2 pixels(0), units(0);
  glfwGetFramebufferSize(window_, &pixels.x, &pixels.y);
  glfwGetWindowSize(window_, &units.x, &units.y);
  pixelRatio_ = dvec2(glm::max(pixels, ivec2(1))) / dvec2(glm::max(units, ivec2(1)));
  io.DisplaySize = {static_cast<float>(pixels.x), static_cast<float>(pixels.y)};
  io.DisplayFramebufferScale = {1, 1};
  keys_.clear();
  keysDownNow_.clear();
  clicked_ = wheeled_ = moved_ = marked_ = false;
  hadInput_ = !queue_.empty() || resized_ || !dropped_.empty();
  resized_ = false;
  while (!queue_.empty() && feed(queue_.front())) queue_.pop_front();
  late_ = !queue_.empty();
  const dvec2 pointer = mouse_ * pixelRatio_;
  io.MousePos = {static_cast<float>(pointer.x), static_cast<float>(pointer.y)};
  if (mouse_.x < -1e8) io.MousePos = {-FLT_MAX, -FLT_MAX};
  for (int i = 0; i < 5; ++i) io.MouseDown[i] = buttons_[i];
  const auto down = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
  io.KeyCtrl = down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  io.KeyShift = down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  io.KeyAlt = down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  io.KeySuper = down(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
  ImGui::NewFrame();
}

void Window::finishUi() { ImGui::Render(); }

void Window::endFrame(unsigned clearColor) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  const ImVec4 c = ImGui::ColorConvertU32ToFloat4(clearColor);
  glClearColor(c.x, c.y, c.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (takesMarks_) {
    while (glFaults_ < 1000 && glGetError() != GL_NO_ERROR) ++glFaults_;
    slowDown();
  }
  glfwSwapBuffers(window_);
  ++frames_;
}

/// $PILEUS_UI_FRAME_MS: a test of what slow frames do.
void Window::slowDown() const {
  static const int ms = [] {
    const char* text = std::getenv("PILEUS_UI_FRAME_MS");
    return text ? std::clamp(std::atoi(text), 0, 2000) : 0;
  }();
  if (ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(ms));
}

bool Window::closeRequested() const { return glfwWindowShouldClose(window_) != 0; }
void Window::cancelClose() { glfwSetWindowShouldClose(window_, GLFW_FALSE); }

void Window::setTitle(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_, title.c_str());
}

ivec2 Window::size() const {
  ivec2 s;
  glfwGetWindowSize(window_, &s.x, &s.y);
  return s;
}

}  // namespace pileus::editor
