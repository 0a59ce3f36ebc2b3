#pragma once
// Stills of the picture, each with the graph that made it: a strip below the viewport, a wipe between any two
// or one and the picture, and the way back to a graph.
#include <memory>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"
#include "renderer/base/math.h"
#include "renderer/view/picture.h"

namespace pileus::editor {

class Messages;
struct Session;
struct Shown;

/// The line of a wipe: dragged with the pointer.
struct WipeLine {
  double at = 0.5;  ///< of the picture's width
  bool held = false;
};

struct Snapshot {
  std::size_t slot = 0;  ///< of the thumbnail's texture
  std::string name, time;
  std::shared_ptr<const view::Picture> picture;
  nodes::Graph graph;
};

struct Snapshots {
  static constexpr std::size_t kMost = 16;
  static constexpr int kPicture = -1;  ///< in place of an index: what the viewport renders now

  std::vector<Snapshot> all;
  int next = 1;  ///< number in the next one's name
  bool wiping = false;
  int left = kPicture, right = 0;
  WipeLine line;

  bool valid(int index) const {
    return index == kPicture || (index >= 0 && static_cast<std::size_t>(index) < all.size());
  }
  std::size_t bytes() const;
};

// Actions.
void takeSnapshot(Messages& messages, Session& session, Shown& shown);
void toggleSnapshotWipe(Messages& messages, Shown& shown);
void deleteSnapshot(Messages& messages, Shown& shown, std::size_t index);
/// The graph as it was, as one undo step.
void restoreSnapshot(Messages& messages, Session& session, const Shown& shown, std::size_t index);

}  // namespace pileus::editor
