#include "editor/graph_view/layout/arrange_layers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pileus::editor {
namespace {

constexpr double kBend = 8;  // room a passing link takes in a layer
constexpr int kSweeps = 24, kHeightSweeps = 12;

/// The longest way from each member to a node without followers.
std::vector<int> layersOf(std::size_t boxes, const std::vector<int>& members,
                          const std::vector<BoxLink>& links) {
  std::vector<int> layer(boxes, 0);
  for (std::size_t pass = 0; pass < members.size(); ++pass) {
    bool changed = false;
    for (const BoxLink& l : links) {
      const int wanted = layer[static_cast<std::size_t>(l.to)] + 1;
      int& have = layer[static_cast<std::size_t>(l.from)];
      if (have < wanted) have = wanted, changed = true;
    }
    if (!changed) break;
  }
  return layer;
}

/// Neighbours of each vertex on one side.
using Sides = std::vector<std::vector<const LayerEdge*>>;
Sides edgesAt(const Layers& layers, bool incoming) {
  Sides sides(layers.vertices.size());
  for (const LayerEdge& e : layers.edges)
    sides[static_cast<std::size_t>(incoming ? e.to : e.from)].push_back(&e);
  return sides;
}

std::vector<int> ranks(const Layers& layers) {
  std::vector<int> rank(layers.vertices.size(), 0);
  for (const auto& row : layers.rows)
    for (std::size_t i = 0; i < row.size(); ++i) rank[static_cast<std::size_t>(row[i])] = static_cast<int>(i);
  return rank;
}

/// Place of an edge's end as a rank with the socket's height as its fraction.
double portRank(const Layers& layers, const std::vector<int>& rank, int vertex, double y) {
  const double height = std::max(layers.vertices[static_cast<std::size_t>(vertex)].height, 1.0);
  return rank[static_cast<std::size_t>(vertex)] + std::clamp(y / height, 0.0, 1.0) * 0.9;
}

/// Vertices in the order in which a walk from the last layer backwards through their sockets meets them: what
/// feeds one node comes to lie together. Independent of where things lie now.
void firstOrder(Layers& layers) {
  const Sides feeding = edgesAt(layers, true);
  std::vector<char> seen(layers.vertices.size(), 0);
  std::vector<std::vector<int>> rows(layers.rows.size());
  const auto visit = [&](auto&& self, int v) -> void {
    if (seen[static_cast<std::size_t>(v)]) return;
    seen[static_cast<std::size_t>(v)] = 1;
    rows[static_cast<std::size_t>(layers.vertices[static_cast<std::size_t>(v)].layer)].push_back(v);
    std::vector<const LayerEdge*> edges = feeding[static_cast<std::size_t>(v)];
    std::stable_sort(edges.begin(), edges.end(),
                     [](const LayerEdge* a, const LayerEdge* b) { return a->toY < b->toY; });
    for (const LayerEdge* e : edges) self(self, e->from);
  };
  for (const auto& row : layers.rows)
    for (const int v : row) visit(visit, v);
  layers.rows = std::move(rows);
}

/// `rightward`: by the layer on the left, else by the one on the right.
void sweep(Layers& layers, const Sides& sides, bool rightward) {
  std::vector<int> rank = ranks(layers);
  const auto count = static_cast<int>(layers.rows.size());
  for (int i = 1; i < count; ++i) {
    auto& row = layers.rows[static_cast<std::size_t>(rightward ? count - 1 - i : i)];
    std::vector<std::pair<double, int>> keyed;
    for (const int v : row) {
      double sum = 0;
      const auto& edges = sides[static_cast<std::size_t>(v)];
      for (const LayerEdge* e : edges)
        sum += rightward ? portRank(layers, rank, e->from, e->fromY) : portRank(layers, rank, e->to, e->toY);
      keyed.emplace_back(
          edges.empty() ? rank[static_cast<std::size_t>(v)] : sum / static_cast<double>(edges.size()), v);
    }
    std::stable_sort(keyed.begin(), keyed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < keyed.size(); ++k) {
      row[k] = keyed[k].second;
      rank[static_cast<std::size_t>(row[k])] = static_cast<int>(k);
    }
  }
}

/// Least squares with a fixed order and distances: neighbours that want to overlap become one block.
void resolve(Layers& layers, const std::vector<int>& row, const std::vector<double>& wanted) {
  struct Block {
    double sum = 0;  ///< of wanted minus offset
    double count = 0;
    std::size_t first = 0;
  };
  std::vector<double> offset(row.size(), 0);
  for (std::size_t i = 1; i < row.size(); ++i) {
    const LayerVertex &above = layers.vertices[static_cast<std::size_t>(row[i - 1])],
                      &below = layers.vertices[static_cast<std::size_t>(row[i])];
    offset[i] = offset[i - 1] + above.height + (above.box < 0 && below.box < 0 ? 6.0 : kRowGap);
  }
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < row.size(); ++i) {
    // Bends weigh more: a straight link is worth more than a centred node.
    const double weight = layers.vertices[static_cast<std::size_t>(row[i])].box < 0 ? 3 : 1;
    blocks.push_back({(wanted[i] - offset[i]) * weight, weight, i});
    while (blocks.size() > 1) {
      const Block last = blocks.back();
      Block& before = blocks[blocks.size() - 2];
      if (before.sum / before.count <= last.sum / last.count) break;
      before.sum += last.sum, before.count += last.count;
      blocks.pop_back();
    }
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t end = b + 1 < blocks.size() ? blocks[b + 1].first : row.size();
    for (std::size_t i = blocks[b].first; i < end; ++i)
      layers.vertices[static_cast<std::size_t>(row[i])].y = blocks[b].sum / blocks[b].count + offset[i];
  }
}

/// Where a vertex's links would be level; its own place where there are none on the wanted sides.
double levelWith(const Layers& layers, int v, const Sides* left, const Sides* right) {
  double sum = 0, count = 0;
  const auto y = [&](int w) { return layers.vertices[static_cast<std::size_t>(w)].y; };
  if (left)
    for (const LayerEdge* e : (*left)[static_cast<std::size_t>(v)])
      sum += y(e->from) + e->fromY - e->toY, ++count;
  if (right)
    for (const LayerEdge* e : (*right)[static_cast<std::size_t>(v)])
      sum += y(e->to) + e->toY - e->fromY, ++count;
  return count > 0 ? sum / count : y(v);
}

}  // namespace

Layers makeLayers(const std::vector<Box>& boxes, const std::vector<int>& members,
                  const std::vector<BoxLink>& links) {
  Layers layers;
  const std::vector<int> layer = layersOf(boxes.size(), members, links);
  std::vector<int> vertexOf(boxes.size(), -1);
  const auto add = [&](LayerVertex v) {
    if (layers.rows.size() <= static_cast<std::size_t>(v.layer))
      layers.rows.resize(static_cast<std::size_t>(v.layer) + 1);
    layers.rows[static_cast<std::size_t>(v.layer)].push_back(static_cast<int>(layers.vertices.size()));
    layers.vertices.push_back(v);
    return static_cast<int>(layers.vertices.size()) - 1;
  };
  for (const int m : members)
    vertexOf[static_cast<std::size_t>(m)] =
        add({m, layer[static_cast<std::size_t>(m)], boxes[static_cast<std::size_t>(m)].size.y, 0});
  for (const BoxLink& l : links) {
    int at = vertexOf[static_cast<std::size_t>(l.from)];
    double y = l.fromY;
    const int end = layer[static_cast<std::size_t>(l.to)];
    for (int k = layer[static_cast<std::size_t>(l.from)] - 1; k > end; --k) {
      const int bend = add({-1, k, kBend, 0});
      layers.edges.push_back({at, bend, y, kBend / 2});
      at = bend, y = kBend / 2;
    }
    layers.edges.push_back({at, vertexOf[static_cast<std::size_t>(l.to)], y, l.toY});
  }
  firstOrder(layers);
  return layers;
}

int crossings(const Layers& layers) {
  const std::vector<int> rank = ranks(layers);
  std::vector<std::vector<std::pair<double, double>>> between(layers.rows.size());
  for (const LayerEdge& e : layers.edges)
    between[static_cast<std::size_t>(layers.vertices[static_cast<std::size_t>(e.to)].layer)].emplace_back(
        portRank(layers, rank, e.from, e.fromY), portRank(layers, rank, e.to, e.toY));
  int count = 0;
  for (auto& edges : between)
    for (std::size_t a = 0; a < edges.size(); ++a)
      for (std::size_t b = a + 1; b < edges.size(); ++b)
        if ((edges[a].first - edges[b].first) * (edges[a].second - edges[b].second) < 0) ++count;
  return count;
}

void orderLayers(Layers& layers) {
  const Sides left = edgesAt(layers, true), right = edgesAt(layers, false);
  int best = crossings(layers);
  std::vector<std::vector<int>> bestRows = layers.rows;
  for (int i = 0; i < kSweeps && best > 0; ++i) {
    sweep(layers, i % 2 == 0 ? left : right, i % 2 == 0);
    if (const int now = crossings(layers); now < best) best = now, bestRows = layers.rows;
  }
  layers.rows = std::move(bestRows);
}

void placeRows(Layers& layers) {
  for (const auto& row : layers.rows) resolve(layers, row, std::vector<double>(row.size(), 0));
  const Sides left = edgesAt(layers, true), right = edgesAt(layers, false);
  const auto count = static_cast<int>(layers.rows.size());
  std::vector<double> wanted;
  for (int i = 0; i < kHeightSweeps; ++i) {
    const bool rightward = i % 2 == 1, last = i + 2 >= kHeightSweeps;
    for (int k = 0; k < count; ++k) {
      const auto& row = layers.rows[static_cast<std::size_t>(rightward ? count - 1 - k : k)];
      wanted.clear();
      for (const int v : row)
        wanted.push_back(
            levelWith(layers, v, rightward || last ? &left : nullptr, !rightward || last ? &right : nullptr));
      resolve(layers, row, wanted);
    }
  }
}

}  // namespace pileus::editor
