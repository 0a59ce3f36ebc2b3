#include "editor/graph_view/layout/path_geometry.h"

#include <algorithm>
#include <array>
#include <optional>

#include "editor/graph_view/draw_link.h"

namespace pileus::editor {
namespace {

constexpr std::size_t kSamples = 33;

std::array<vec2, kSamples> sampled(const Curve& k) {
  std::array<vec2, kSamples> points;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(kSamples - 1), s = 1 - t;
    points[i] = s * s * s * k.a + 3 * s * s * t * k.b + 3 * s * t * t * k.c + t * t * t * k.d;
  }
  return points;
}

float cross(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

/// Where the segments a-b and c-d meet.
std::optional<vec2> meeting(vec2 a, vec2 b, vec2 c, vec2 d) {
  const vec2 r = b - a, s = d - c;
  const float across = cross(r, s);
  if (across == 0) return std::nullopt;
  const float t = cross(c - a, s) / across, u = cross(c - a, r) / across;
  if (t < 0 || t > 1 || u < 0 || u > 1) return std::nullopt;
  return a + t * r;
}

struct Bounds {
  vec2 lo, hi;
};
template <class Points>
Bounds boundsOf(const Points& points) {
  Bounds b{points[0], points[0]};
  for (const vec2 p : points) b.lo = glm::min(b.lo, p), b.hi = glm::max(b.hi, p);
  return b;
}
bool apart(const Bounds& a, const Bounds& b) {
  return a.hi.x < b.lo.x || b.hi.x < a.lo.x || a.hi.y < b.lo.y || b.hi.y < a.lo.y;
}

bool inside(const std::vector<vec2>& around, vec2 p) {
  bool in = false;
  for (std::size_t i = 0, j = around.size() - 1; i < around.size(); j = i++) {
    const vec2 a = around[i], b = around[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

}  // namespace

std::vector<Crossing> crossings(const Layout& layout, const nodes::Graph& graph,
                                const std::vector<vec2>& line) {
  std::vector<Crossing> found;
  if (line.size() < 2) return found;
  const Bounds ours = boundsOf(line);
  for (const nodes::Link& link : graph.links) {
    vec2 from, to;
    nodes::SocketType type;
    if (!linkEnds(layout, link, from, to, type)) continue;
    const auto curve = sampled(linkCurve(from, to));
    if (apart(ours, boundsOf(curve))) continue;
    std::optional<vec2> at;
    for (std::size_t i = 1; i < line.size() && !at; ++i)
      for (std::size_t k = 1; k < kSamples && !at; ++k)
        at = meeting(line[i - 1], line[i], curve[k - 1], curve[k]);
    if (at) found.push_back({link, *at});
  }
  return found;
}

std::set<std::string> nodesAround(const Layout& layout, const std::vector<vec2>& line) {
  std::set<std::string> names;
  if (line.size() < 2) return names;
  const Bounds ours = boundsOf(line);
  for (const NodePlace& p : layout.nodes) {
    if (apart(ours, {p.min, p.max})) continue;
    const vec2 corners[] = {p.min, {p.max.x, p.min.y}, p.max, {p.min.x, p.max.y}};
    bool touched = inside(line, 0.5f * (p.min + p.max));
    for (const vec2 corner : corners) touched = touched || inside(line, corner);
    for (std::size_t i = 0; i < line.size() && !touched; ++i)
      for (std::size_t k = 0; k < 4 && !touched; ++k)
        touched = meeting(line[i], line[(i + 1) % line.size()], corners[k], corners[(k + 1) % 4]).has_value();
    if (touched) names.insert(p.name);
  }
  return names;
}

bool passesThrough(const Curve& curve, vec2 min, vec2 max, float& nearest) {
  const auto points = sampled(curve);
  const vec2 corners[] = {min, {max.x, min.y}, max, {min.x, max.y}};
  nearest = distance(curve, 0.5f * (min + max));
  for (std::size_t k = 1; k < kSamples; ++k) {
    const vec2 p = points[k];
    if (p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y) return true;
    for (std::size_t c = 0; c < 4; ++c)
      if (meeting(points[k - 1], p, corners[c], corners[(c + 1) % 4])) return true;
  }
  return false;
}

}  // namespace pileus::editor
