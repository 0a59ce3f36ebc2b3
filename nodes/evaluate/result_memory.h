#pragma once
// What a result keeps in memory: grids, the blocks of shadow maps, pictures, each once however many values
// lead to it. GL thread.
#include <cstddef>
#include <vector>

#include "nodes/declare/value.h"

namespace pileus::nodes {

/// One thing that is kept, and by whose address it is known: values that share it name the same.
struct Held {
  const void* what = nullptr;
  std::size_t bytes = 0;
  bool map = false;  ///< a block of the shadow store

  bool operator<(const Held& o) const { return what < o.what; }
  bool operator==(const Held& o) const { return what == o.what; }
};

/// All that these values keep alive, directly or through what a picture or a map remembers of its scene;
/// sorted, each once.
std::vector<Held> heldBy(const std::vector<SocketValue>& values);

}  // namespace pileus::nodes
