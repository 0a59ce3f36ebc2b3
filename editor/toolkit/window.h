#pragma once
// The window: GLFW, its OpenGL 4.5 core context and ImGui's backends. Input events are queued and handed to
// ImGui in order, at most one click or key per frame, so that nothing is lost or reordered when frames are
// slow. UI thread only (but wake()).
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/math.h"
#include "renderer/base/result.h"

struct GLFWwindow;

namespace pileus::editor {

/// A key going down (or repeating) this frame. `key` is GLFW's code, letters by the keyboard's layout.
struct KeyPress {
  int key = 0;
  bool ctrl = false, shift = false, alt = false, repeat = false;
};

struct InputEvent {
  enum class Kind { Move, Button, Wheel, Key, Char, Focus, Mark } kind = Kind::Move;
  dvec2 at{0};   ///< Move: window units; Wheel: offsets
  int code = 0;  ///< button, key or code point
  bool down = false, repeat = false;
  int mods = 0;
};

/// The press that a Key event is, by its modifiers.
KeyPress keyPressOf(const InputEvent& event);

class Window {
 public:
  /// Error (Gpu) when no OpenGL 4.5 core window can be made; says what failed. Makes the context current and
  /// creates ImGui's. A size of 0: by the screen.
  static Result<std::unique_ptr<Window>> create(const std::string& title, ivec2 size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  float screenScale() const { return scale_; }  ///< what the screen asks for, in steps of a quarter
  static const char* systemVersion();           ///< of the window library
  static float forcedScale();                   ///< $PILEUS_UI_SCALE; 0 = not set
  void startUi();                  ///< after fonts are chosen: creates the GL objects of the interface
  void fontsChanged(float scale);  ///< between frames: the atlas holds other fonts now, for this UI scale

  /// Sleeps until there is an event or `seconds` have passed; 0 polls.
  void waitEvents(double seconds);
  /// Wakes waitEvents from any thread.
  static void wake();
  void push(const InputEvent& event) { queue_.push_back(event); }  ///< as if the user had done it
  bool inputPending() const { return !queue_.empty(); }            ///< more events wait for the next frame
  bool hadInput() const { return hadInput_; }                      ///< this frame got events
  /// With $PILEUS_UI_TRACE, F13 to F24 reach nobody: each ends the events of a frame and is counted, so that
  /// a test knows when what it sent before has been handled and drawn.
  unsigned long long marks() const { return marks_; }
  /// Errors that OpenGL has kept at the ends of frames; with $PILEUS_UI_TRACE only.
  int glFaults() const { return glFaults_; }

  /// Asked of each event before it is handed on: true keeps it, and what follows, for another frame.
  /// `moved`: the pointer has moved in this frame.
  std::function<bool(const InputEvent& event, bool moved)> holds;

  void beginFrame();                   ///< feeds events, starts the ImGui frame
  void finishUi();                     ///< the frame's draw data are made
  void endFrame(unsigned clearColor);  ///< draws them and swaps
  unsigned long long framesDrawn() const { return frames_; }
  std::span<const KeyPress> keys() const { return keys_; }
  std::vector<std::filesystem::path> takeDroppedFiles() { return std::exchange(dropped_, {}); }

  bool closeRequested() const;
  void cancelClose();
  void setTitle(const std::string& title);
  ivec2 size() const;

 private:
  Window() = default;
  void installCallbacks();
  bool feed(const InputEvent& event);  ///< false: belongs to the next frame
  void slowDown() const;
  GLFWwindow* window_ = nullptr;
  float scale_ = 1;
  bool uiStarted_ = false, hadInput_ = false, clicked_ = false, wheeled_ = false, moved_ = false;
  bool resized_ = true, marked_ = false, takesMarks_ = false, late_ = false;
  dvec2 pixelRatio_{
      1};  ///< pixels per unit of the pointer's coordinates: not 1 where the system scales windows
  dvec2 mouse_{-1e9};    ///< as handed on
  dvec2 pointer_{-1e9};  ///< as last reported
  unsigned long long frames_ = 0;
  bool buttons_[5] = {};
  std::deque<InputEvent> queue_;
  std::vector<KeyPress> keys_;
  std::vector<int> keysDownNow_;
  std::vector<std::filesystem::path> dropped_;
  std::string title_;
  unsigned long long marks_ = 0;
  int glFaults_ = 0;
};

}  // namespace pileus::editor
