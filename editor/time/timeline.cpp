#include "editor/time/timeline.h"

#include <algorithm>
#include <cmath>

namespace pileus::editor {
namespace {

constexpr double kFewest = 4, kMost = 1e6;  // frames that the ruler shows

/// The rows that a row stands for: all for the summary.
bool covers(int row, std::size_t index) { return row == 0 || row == static_cast<int>(index) + 1; }

}  // namespace

void FrameScale::zoom(double x, double factor) {
  const double at = toFrame(x), span = std::clamp((last - first) * factor, kFewest, kMost);
  const double share = (x - left) / std::max(right - left, 1.0);
  first = at - share * span;
  last = first + span;
}

void FrameScale::pan(double pixels) {
  const double frames = pixels / perFrame();
  first -= frames, last -= frames;
}

void FrameScale::fit(ivec2 range) {
  const double end = std::max(range.y, range.x + 24), room = 0.03 * (end - range.x);
  first = range.x - room;
  last = end + room;
}

double tickStep(double pixelsPerFrame, double pixels) {
  for (double decade = 1;; decade *= 10)
    for (const double step : {1.0, 2.0, 5.0})
      if (step * decade * pixelsPerFrame >= pixels || decade >= 1e9) return step * decade;
}

std::vector<AnimatedRow> keyRows(const nodes::Graph& graph, const std::set<std::string>& selection) {
  std::vector<AnimatedRow> rows;
  for (const auto& [name, node] : graph.nodes) {
    if (!selection.empty() && !selection.contains(name)) continue;
    // What is in a group plays with it.
    if (node->group)
      for (AnimatedRow row : keyRows(*node->group, {})) {
        row.node = name + "/" + row.node;
        row.title = name + "/" + row.title;
        rows.push_back(std::move(row));
      }
    const nodes::NodeType* type = nodes::findNodeType(node->type);
    for (const auto& [param, animation] : node->animated) {
      const nodes::ParamSpec* spec = type ? type->param(param) : nullptr;
      rows.push_back({name, param, animation.keys, name + " \xc2\xb7 " + (spec ? spec->label : param)});
    }
  }
  return rows;
}

const std::vector<AnimatedRow>& shownRows(KeyRowsCache& cache, const nodes::Document& document) {
  if (cache.revision != document.graphRevision() || cache.selection != document.selection()) {
    cache.rows = keyRows(document.graph(), document.selection());
    cache.revision = document.graphRevision();
    cache.selection = document.selection();
  }
  return cache.rows;
}

KeySelection keysAt(const std::vector<AnimatedRow>& rows, int row, double frame, double reach) {
  double nearest = reach;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (covers(row, i))
      for (const nodes::AnimationKey& k : rows[i].keys)
        nearest = std::min(nearest, std::abs(k.frame - frame));
  KeySelection found;
  std::optional<double> at;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (covers(row, i))
      for (const nodes::AnimationKey& k : rows[i].keys)
        if (std::abs(k.frame - frame) <= nearest && at.value_or(k.frame) == k.frame) {
          at = k.frame;
          found.insert({rows[i].node, rows[i].param, k.frame});
        }
  return found;
}

KeySelection keysInBox(const std::vector<AnimatedRow>& rows, int top, int bottom, double from, double to) {
  if (top > bottom) std::swap(top, bottom);
  if (from > to) std::swap(from, to);
  KeySelection found;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int row = static_cast<int>(i) + 1;
    if (top > 0 && (row < top || row > bottom)) continue;
    for (const nodes::AnimationKey& k : rows[i].keys)
      if (k.frame >= from && k.frame <= to) found.insert({rows[i].node, rows[i].param, k.frame});
  }
  return found;
}

std::optional<double> keyBeside(const std::vector<AnimatedRow>& rows, double frame, int direction) {
  std::optional<double> best;
  for (const AnimatedRow& row : rows)
    for (const nodes::AnimationKey& k : row.keys)
      if ((k.frame - frame) * direction > 0 && (!best || (*best - k.frame) * direction > 0)) best = k.frame;
  return best;
}

std::vector<nodes::KeyMove> movesBy(const KeySelection& keys, double frames) {
  std::vector<nodes::KeyMove> moves;
  for (const KeyRef& k : keys) moves.push_back({k.node, k.param, k.frame, k.frame + frames});
  return moves;
}

void PlayClock::start(int frame, int direction, ivec2 range, double fps, double now) {
  range_ = range;
  frame_ = std::clamp(frame, range.x, range.y);
  direction_ = direction;
  fps_ = fps;
  start_ = now;
  shown_.clear();
}

int PlayClock::frameAt(double now) const {
  // A hair more, so that a frame's own time is surely in it.
  const auto passed = static_cast<long long>(std::floor((now - start_) * fps_ + 1e-6));
  const long long count = std::max(range_.y - range_.x + 1, 1);
  const long long at = (frame_ - range_.x + direction_ * passed) % count;
  return range_.x + static_cast<int>((at + count) % count);
}

double PlayClock::dueIn(double now) const {
  const double passed = std::floor((now - start_) * fps_ + 1e-6);
  return std::max(start_ + (passed + 1) / fps_ - now, 0.0);
}

void PlayClock::shown(double now) {
  shown_.push_back(now);
  while (!shown_.empty() && shown_.front() < now - 1) shown_.pop_front();
}

double PlayClock::reachedFps(double now) const {
  if (now - start_ < 1) return fps_;
  const auto recent =
      std::count_if(shown_.begin(), shown_.end(), [&](double t) { return t > now - 1 && t <= now; });
  return std::min(static_cast<double>(recent), fps_);
}

}  // namespace pileus::editor
