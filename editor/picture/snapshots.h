#pragma once
// Stills of the picture, each with the graph that made it: a strip below the viewport, a wipe between any two
// or one and the picture, and the way back to a graph.
#include <memory>
#include <string>
#include <vector>

#include "editor/viewport/wipe_line.h"
#include "nodes/graph/graph.h"
#include "renderer/view/picture.h"

namespace pileus::editor {

struct Editor;

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
void takeSnapshot(Editor& editor);
void toggleSnapshotWipe(Editor& editor);
void deleteSnapshot(Editor& editor, std::size_t index);
/// The graph as it was, as one undo step.
void restoreSnapshot(Editor& editor, std::size_t index);

/// Height the strip wants; 0 while there is none.
float snapshotStripHeight(const Editor& editor);
void drawSnapshotStrip(Editor& editor, vec2 lo, vec2 hi);
/// In place of the picture while wiping.
void drawSnapshotWipe(Editor& editor, vec2 lo, vec2 hi, bool hovered);

}  // namespace pileus::editor
