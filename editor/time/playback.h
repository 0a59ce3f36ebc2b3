#pragma once
// The current frame: going to one, to the next key, and playing. Never an undo step.
#include <cstdint>

namespace pileus::nodes {
struct Node;
}

namespace pileus::editor {

class Messages;
class Requests;
struct Clock;
struct Session;

/// Stops playback.
void goToFrame(Clock& clock, int frame);
void stepFrame(Clock& clock, int by);
/// The nearest key of the rows shown before (-1) or after (1) the current frame.
void goToKey(Messages& messages, const Session& session, Clock& clock, int direction);
void goToEnd(const Session& session, Clock& clock,
             int direction);  ///< of the range: -1 its start, 1 its end

void play(Messages& messages, Requests& requests, const Session& session, Clock& clock, int direction);
void stopPlayback(Clock& clock);
void togglePlay(Messages& messages, Requests& requests, const Session& session, Clock& clock);
/// Before values of a node are dragged: an animated one gets keys, and all of them at one frame.
void holdFrame(Clock& clock, const nodes::Node& node);
/// Once a frame: sets the frame that is due now. `answered`: pictures of the preview so far.
void stepPlayback(const Session& session, Clock& clock, std::uint64_t answered);
/// Seconds until the next frame is due; -1: nothing plays.
double playbackDueIn(const Clock& clock);

/// Pictures a second, over the last one.
double reachedFps(const Clock& clock);

}  // namespace pileus::editor
