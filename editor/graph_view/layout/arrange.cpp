#include "editor/graph_view/layout/arrange.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "editor/graph_view/layout/arrange_layers.h"

namespace pileus::editor {
namespace {

constexpr double kPartGap = 60;  // between parts that no link joins
constexpr double kLooseWidth = 1000;

/// Without the links that lead back in a cycle.
std::vector<BoxLink> acyclic(std::size_t boxes, const std::vector<BoxLink>& links) {
  std::vector<std::vector<std::size_t>> out(boxes);
  for (std::size_t i = 0; i < links.size(); ++i) out[static_cast<std::size_t>(links[i].from)].push_back(i);
  std::vector<char> state(boxes, 0);  // 1: being walked, 2: done
  std::vector<char> back(links.size(), 0);
  const auto walk = [&](auto&& self, std::size_t v) -> void {
    state[v] = 1;
    for (const std::size_t i : out[v]) {
      const auto to = static_cast<std::size_t>(links[i].to);
      if (state[to] == 1)
        back[i] = 1;
      else if (state[to] == 0)
        self(self, to);
    }
    state[v] = 2;
  };
  for (std::size_t v = 0; v < boxes; ++v)
    if (state[v] == 0) walk(walk, v);
  std::vector<BoxLink> kept;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (!back[i]) kept.push_back(links[i]);
  return kept;
}

/// Parts that links hold together, by the lowest box in each.
std::vector<std::vector<int>> partsOf(std::size_t boxes, const std::vector<BoxLink>& links) {
  std::vector<int> root(boxes);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[static_cast<std::size_t>(v)] != v) v = root[static_cast<std::size_t>(v)];
    return v;
  };
  for (const BoxLink& l : links) {
    const int a = find(l.from), b = find(l.to);
    root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  std::vector<std::vector<int>> parts;
  std::vector<int> partAt(boxes, -1);
  for (int v = 0; v < static_cast<int>(boxes); ++v) {
    int& part = partAt[static_cast<std::size_t>(find(v))];
    if (part < 0) part = static_cast<int>(parts.size()), parts.emplace_back();
    parts[static_cast<std::size_t>(part)].push_back(v);
  }
  return parts;
}

struct Extent {
  dvec2 min{0}, max{0};
};
Extent extentOf(const std::vector<Box>& boxes, const std::vector<dvec2>& at, const std::vector<int>& which) {
  Extent e{at[static_cast<std::size_t>(which.front())], at[static_cast<std::size_t>(which.front())]};
  for (const int v : which) {
    const auto i = static_cast<std::size_t>(v);
    e.min = glm::min(e.min, at[i]);
    e.max = glm::max(e.max, at[i] + boxes[i].size);
  }
  return e;
}

/// One connected part, its right edge at 0.
void arrangePart(const std::vector<Box>& boxes, const std::vector<int>& members,
                 const std::vector<BoxLink>& links, std::vector<dvec2>& at) {
  std::vector<BoxLink> own;
  for (const BoxLink& l : links)
    if (std::binary_search(members.begin(), members.end(), l.from)) own.push_back(l);
  Layers layers = makeLayers(boxes, members, own);
  orderLayers(layers);
  placeRows(layers);
  double right = 0;
  for (const auto& row : layers.rows) {
    double width = 0;
    for (const int v : row)
      if (const int b = layers.vertices[static_cast<std::size_t>(v)].box; b >= 0)
        width = std::max(width, boxes[static_cast<std::size_t>(b)].size.x);
    for (const int v : row) {
      const LayerVertex& vertex = layers.vertices[static_cast<std::size_t>(v)];
      if (vertex.box < 0) continue;
      const auto b = static_cast<std::size_t>(vertex.box);
      at[b] = glm::round(dvec2(right - width + 0.5 * (width - boxes[b].size.x), vertex.y));
    }
    right -= width + kLayerGap;
  }
}

/// Boxes without links, in lines.
void arrangeLoose(const std::vector<Box>& boxes, const std::vector<int>& loose, std::vector<dvec2>& at) {
  dvec2 pen(0);
  double line = 0;
  for (const int v : loose) {
    const auto i = static_cast<std::size_t>(v);
    if (pen.x > 0 && pen.x + boxes[i].size.x > kLooseWidth) pen = {0, pen.y + line + kRowGap}, line = 0;
    at[i] = pen;
    pen.x += boxes[i].size.x + kRowGap;
    line = std::max(line, boxes[i].size.y);
  }
}

dvec2 middle(const Extent& e) { return 0.5 * (e.min + e.max); }

}  // namespace

std::vector<dvec2> arranged(const std::vector<Box>& boxes, const std::vector<BoxLink>& links) {
  std::vector<dvec2> at(boxes.size());
  std::transform(boxes.begin(), boxes.end(), at.begin(), [](const Box& b) { return b.at; });
  if (boxes.size() < 2) return at;
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  const Extent before = extentOf(boxes, at, all);
  const std::vector<BoxLink> forward = acyclic(boxes.size(), links);

  std::vector<std::vector<int>> parts, joined = partsOf(boxes.size(), forward);
  std::vector<int> loose;
  for (auto& part : joined) {
    if (part.size() == 1)
      loose.push_back(part.front());
    else
      parts.push_back(std::move(part));
  }
  // Parts keep their order from top to bottom.
  std::vector<double> height;
  for (const auto& part : parts) height.push_back(middle(extentOf(boxes, at, part)).y);
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return height[a] < height[b]; });
  for (const auto& part : parts) arrangePart(boxes, part, forward, at);
  const bool anyLoose = !loose.empty();
  if (anyLoose) {
    arrangeLoose(boxes, loose, at);
    order.push_back(parts.size());  // below all others
    parts.push_back(std::move(loose));
  }
  double top = 0;
  for (const std::size_t p : order) {
    const Extent e = extentOf(boxes, at, parts[p]);
    const bool isLoose = anyLoose && p + 1 == parts.size();
    for (const int v : parts[p])  // right edges are at 0
      at[static_cast<std::size_t>(v)] -= dvec2(isLoose ? e.max.x : 0, e.min.y - top);
    top += e.max.y - e.min.y + kPartGap;
  }
  const dvec2 by = glm::round(middle(before) - middle(extentOf(boxes, at, all)));
  for (dvec2& p : at) p += by;
  return at;
}

int crossingsOf(const std::vector<Box>& boxes, const std::vector<BoxLink>& links) {
  const auto end = [&](int box, double y, bool right) {
    const Box& b = boxes[static_cast<std::size_t>(box)];
    return b.at + dvec2(right ? b.size.x : 0, y);
  };
  const auto side = [](dvec2 a, dvec2 b, dvec2 p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  int count = 0;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t j = i + 1; j < links.size(); ++j) {
      const dvec2 a = end(links[i].from, links[i].fromY, true), b = end(links[i].to, links[i].toY, false),
                  c = end(links[j].from, links[j].fromY, true), d = end(links[j].to, links[j].toY, false);
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) ++count;
    }
  return count;
}

std::vector<dvec2> aligned(const std::vector<Box>& boxes, Align how) {
  std::vector<dvec2> at;
  for (const Box& b : boxes) at.push_back(b.at);
  if (boxes.empty()) return at;
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  const Extent e = extentOf(boxes, at, all);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const dvec2 size = boxes[i].size;
    switch (how) {
      case Align::Left:
        at[i].x = e.min.x;
        break;
      case Align::Right:
        at[i].x = e.max.x - size.x;
        break;
      case Align::Top:
        at[i].y = e.min.y;
        break;
      case Align::Bottom:
        at[i].y = e.max.y - size.y;
        break;
      case Align::CenterX:
        at[i].x = std::round(0.5 * (e.min.x + e.max.x - size.x));
        break;
      case Align::CenterY:
        at[i].y = std::round(0.5 * (e.min.y + e.max.y - size.y));
        break;
    }
  }
  return at;
}

std::vector<dvec2> distributed(const std::vector<Box>& boxes, bool horizontal) {
  const int axis = horizontal ? 0 : 1;
  std::vector<dvec2> at;
  for (const Box& b : boxes) at.push_back(b.at);
  if (boxes.size() < 3) return at;
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return boxes[a].at[axis] + 0.5 * boxes[a].size[axis] < boxes[b].at[axis] + 0.5 * boxes[b].size[axis];
  });
  double taken = 0;
  for (const Box& b : boxes) taken += b.size[axis];
  const double from = boxes[order.front()].at[axis],
               to = boxes[order.back()].at[axis] + boxes[order.back()].size[axis];
  const double gap = (to - from - taken) / static_cast<double>(boxes.size() - 1);
  double pen = from;
  for (const std::size_t i : order) {
    if (i != order.front() && i != order.back()) at[i][axis] = std::round(pen);
    pen += boxes[i].size[axis] + gap;
  }
  return at;
}

}  // namespace pileus::editor
