#pragma once
// The steps of arranged(): layers, the order within them, and heights. Vertices are the boxes and a bend for
// each layer that a link passes.
#include <vector>

#include "editor/graph_view/layout/arrange.h"

namespace pileus::editor {

struct LayerVertex {
  int box = -1;  ///< -1: a bend
  int layer = 0;
  double height = 0;
  double y = 0;  ///< top
};
/// Between neighbouring layers, from left (the higher layer) to right.
struct LayerEdge {
  int from = 0, to = 0;  ///< vertices
  double fromY = 0, toY = 0;
};
struct Layers {
  std::vector<LayerVertex> vertices;
  std::vector<LayerEdge> edges;
  std::vector<std::vector<int>>
      rows;  ///< vertices of each layer from top to bottom; layer 0 is the rightmost
};

/// `members`: the boxes of one connected part; `links` without cycles.
Layers makeLayers(const std::vector<Box>& boxes, const std::vector<int>& members,
                  const std::vector<BoxLink>& links);
/// Sweeps from side to side, each layer ordered by the middle of its neighbours; the best order is kept.
void orderLayers(Layers& layers);
int crossings(const Layers& layers);
/// Heights: each vertex as near to its neighbours as its layer has room for.
void placeRows(Layers& layers);

}  // namespace pileus::editor
