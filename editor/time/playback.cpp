#include "editor/time/playback.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "editor/app/editor.h"
#include "editor/app/panels.h"

namespace pileus::editor {
namespace {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

const nodes::Settings& settings(const Editor& editor) { return editor.document.root().settings; }

}  // namespace

void goToFrame(Editor& editor, int frame) {
  stopPlayback(editor);
  if (frame == editor.frame) return;
  editor.frame = frame;
  editor.preview.touch();
}

void stepFrame(Editor& editor, int by) { goToFrame(editor, editor.frame + by); }

void goToKey(Editor& editor, int direction) {
  const std::vector<AnimatedRow>& rows = shownRows(editor.timeline.rows, editor.document);
  // Keys between whole frames: the frame they belong to, but always onwards.
  const std::optional<double> key = keyBeside(rows, editor.frame, direction);
  if (!key)
    return editor.messages.note(direction < 0 ? "No key before this frame" : "No key after this frame");
  goToFrame(editor, static_cast<int>(direction < 0 ? std::floor(*key) : std::ceil(*key)));
}

void goToEnd(Editor& editor, int direction) {
  goToFrame(editor, direction < 0 ? settings(editor).frames.x : settings(editor).frames.y);
}

void play(Editor& editor, int direction) {
  const ivec2 range = settings(editor).frames;
  if (range.x == range.y) {
    revealPanel(editor, Panel::Timeline);
    editor.messages.hint("The frame range holds one frame: set its end in the timeline to play.");
    return;
  }
  editor.timeline.answered = editor.preview.answered();
  editor.timeline.clock.start(editor.frame, direction, range, settings(editor).fps, steadySeconds());
}

void stopPlayback(Editor& editor) { editor.timeline.clock.stop(); }

void togglePlay(Editor& editor) {
  if (editor.timeline.clock.playing())
    stopPlayback(editor);
  else
    play(editor, 1);
}

void holdFrame(Editor& editor, const nodes::Node& node) {
  if (!node.animated.empty()) stopPlayback(editor);
}

void stepPlayback(Editor& editor) {
  PlayClock& clock = editor.timeline.clock;
  if (!clock.playing()) return;
  const double now = steadySeconds();
  const nodes::Settings& s = settings(editor);
  if (clock.outdated(s.frames, s.fps)) clock.start(editor.frame, clock.direction(), s.frames, s.fps, now);
  const int frame = clock.frameAt(now);
  // One picture a frame counts, however often it is refined.
  if (frame != editor.frame) {
    if (editor.preview.answered() != editor.timeline.answered) clock.shown(now);
    editor.timeline.answered = editor.preview.answered();
  }
  if (frame != editor.frame) editor.preview.touch();
  editor.frame = frame;
}

double playbackDueIn(const Editor& editor) {
  const PlayClock& clock = editor.timeline.clock;
  return clock.playing() ? clock.dueIn(steadySeconds()) : -1;
}

double reachedFps(const Editor& editor) { return editor.timeline.clock.reachedFps(steadySeconds()); }

}  // namespace pileus::editor
