#pragma once
// The current frame: going to one, to the next key, and playing. Never an undo step.
namespace pileus::nodes {
struct Node;
}

namespace pileus::editor {

struct Editor;

/// Stops playback.
void goToFrame(Editor& editor, int frame);
void stepFrame(Editor& editor, int by);
/// The nearest key of the rows shown before (-1) or after (1) the current frame.
void goToKey(Editor& editor, int direction);
void goToEnd(Editor& editor, int direction);  ///< of the range: -1 its start, 1 its end

void play(Editor& editor, int direction);
void stopPlayback(Editor& editor);
void togglePlay(Editor& editor);
/// Before values of a node are dragged: an animated one gets keys, and all of them at one frame.
void holdFrame(Editor& editor, const nodes::Node& node);
/// Once a frame: sets the frame that is due now.
void stepPlayback(Editor& editor);
/// Seconds until the next frame is due; -1: nothing plays.
double playbackDueIn(const Editor& editor);

/// Pictures a second, over the last one.
double reachedFps(const Editor& editor);

}  // namespace pileus::editor
