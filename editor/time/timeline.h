#pragma once
// The timeline's arithmetic: frames on the ruler, keys as rows, what is selected, and the clock of playback.
#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "nodes/graph/document.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::editor {

/// Frames laid out over pixels. A frame's pixel is where its line stands.
struct FrameScale {
  double first = 0, last = 25;  ///< frames at the two edges
  double left = 0, right = 100;

  double perFrame() const { return (right - left) / (last - first); }
  double toPixel(double frame) const { return left + (frame - first) * perFrame(); }
  double toFrame(double x) const { return first + (x - left) / perFrame(); }
  /// The frame below x stays where it is; factor > 1 shows more frames.
  void zoom(double x, double factor);
  void pan(double pixels);
  /// The range with some room, 24 frames at least.
  void fit(ivec2 range);
};

/// 1, 2 or 5 times a power of ten: the least distance in frames that is at least `pixels` wide.
double tickStep(double pixelsPerFrame, double pixels);

using KeyRef = nodes::KeyAt;
using KeySelection = std::set<KeyRef>;

/// An animated parameter.
struct AnimatedRow {
  std::string node, param;  ///< node: its name, or its path where it is in a group
  std::vector<nodes::AnimationKey> keys;
  std::string title;  ///< for the user: the node's name and the parameter's label
};
/// Of the selected nodes, of all nodes if none is selected; of groups also what is in them.
std::vector<AnimatedRow> keyRows(const nodes::Graph& graph, const std::set<std::string>& selection);

/// The rows of what a document shows, made anew only where graph or selection have changed.
struct KeyRowsCache {
  std::vector<AnimatedRow> rows;
  std::uint64_t revision = 0;
  std::set<std::string> selection;
};
/// Stays valid until the next call.
const std::vector<AnimatedRow>& shownRows(KeyRowsCache& cache, const nodes::Document& document);

/// Row 0 is the summary: its keys stand for those of every row at that frame. Row i + 1 is rows[i].
/// The keys within `reach` frames of `frame`, the nearest frame's only.
KeySelection keysAt(const std::vector<AnimatedRow>& rows, int row, double frame, double reach);
/// Of rows `top` to `bottom` between two frames; both pairs in any order.
KeySelection keysInBox(const std::vector<AnimatedRow>& rows, int top, int bottom, double from, double to);
/// The nearest frame with a key before (-1) or after (1) a frame.
std::optional<double> keyBeside(const std::vector<AnimatedRow>& rows, double frame, int direction);
/// Moves of the selected keys by a number of frames.
std::vector<nodes::KeyMove> movesBy(const KeySelection& keys, double frames);

/// Which frame is due at what time: the frame follows the time, so that slow pictures drop frames and never
/// slow the playback down. Loops over the range. Times are seconds of any steady clock.
class PlayClock {
 public:
  void start(int frame, int direction, ivec2 range, double fps, double now);
  void stop() { direction_ = 0; }
  bool playing() const { return direction_ != 0; }
  int direction() const { return direction_; }  ///< -1, 0, 1
  /// Was it started with another range or speed?
  bool outdated(ivec2 range, double fps) const { return range != range_ || fps != fps_; }
  int frameAt(double now) const;
  double dueIn(double now) const;  ///< seconds until the next frame
  /// A picture was finished.
  void shown(double now);
  /// Pictures a second, over the last one; the full speed while that is not known yet.
  double reachedFps(double now) const;

 private:
  int frame_ = 1, direction_ = 0;
  ivec2 range_{1, 1};
  double fps_ = 24, start_ = 0;
  std::deque<double> shown_;
};

/// The keys that are selected and moved.
struct KeyEditing {
  KeyRowsCache rows;
  KeySelection selected;
  nodes::Graph before;  ///< the graph when the drag of keys began
  KeySelection beforeSelected;
};

}  // namespace pileus::editor
