#include "editor/time/playback.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/exchange/requests.h"
#include "editor/time/clock.h"

namespace pileus::editor {
namespace {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

const nodes::Settings& settings(const Session& session) { return session.document.root().settings; }

}  // namespace

void goToFrame(Clock& clock, int frame) {
  stopPlayback(clock);
  clock.frame = frame;
}

void stepFrame(Clock& clock, int by) { goToFrame(clock, clock.frame + by); }

void goToKey(Messages& messages, const Session& session, Clock& clock, int direction) {
  const std::vector<AnimatedRow>& rows = shownRows(clock.keys.rows, session.document);
  // Keys between whole frames: the frame they belong to, but always onwards.
  const std::optional<double> key = keyBeside(rows, clock.frame, direction);
  if (!key) return messages.note(direction < 0 ? "No key before this frame" : "No key after this frame");
  goToFrame(clock, static_cast<int>(direction < 0 ? std::floor(*key) : std::ceil(*key)));
}

void goToEnd(const Session& session, Clock& clock, int direction) {
  goToFrame(clock, direction < 0 ? settings(session).frames.x : settings(session).frames.y);
}

void play(Messages& messages, Requests& requests, const Session& session, Clock& clock, int direction) {
  const ivec2 range = settings(session).frames;
  if (range.x == range.y) {
    requests.push(ShowPanel{Panel::Timeline});
    messages.hint("The frame range holds one frame: set its end in the timeline to play.");
    return;
  }
  clock.counting = false;
  clock.play.start(clock.frame, direction, range, settings(session).fps, steadySeconds());
}

void stopPlayback(Clock& clock) { clock.play.stop(); }

void togglePlay(Messages& messages, Requests& requests, const Session& session, Clock& clock) {
  if (clock.play.playing())
    stopPlayback(clock);
  else
    play(messages, requests, session, clock, 1);
}

void holdFrame(Clock& clock, const nodes::Node& node) {
  if (!node.animated.empty()) stopPlayback(clock);
}

void stepPlayback(const Session& session, Clock& clock, std::uint64_t answered) {
  PlayClock& play = clock.play;
  if (!play.playing()) return void(clock.counting = false);
  if (!std::exchange(clock.counting, true)) clock.answered = answered;
  const double now = steadySeconds();
  const nodes::Settings& s = settings(session);
  if (play.outdated(s.frames, s.fps)) play.start(clock.frame, play.direction(), s.frames, s.fps, now);
  const int frame = play.frameAt(now);
  // One picture a frame counts, however often it is refined.
  if (frame != clock.frame) {
    if (answered != clock.answered) play.shown(now);
    clock.answered = answered;
  }
  clock.frame = frame;
}

double playbackDueIn(const Clock& clock) {
  const PlayClock& play = clock.play;
  return play.playing() ? play.dueIn(steadySeconds()) : -1;
}

double reachedFps(const Clock& clock) { return clock.play.reachedFps(steadySeconds()); }

}  // namespace pileus::editor
