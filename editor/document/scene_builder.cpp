#include "editor/document/scene_builder.h"

#include <algorithm>

namespace pileus::editor {
namespace {

constexpr double kStepX = 260, kStepY = 170;

}  // namespace

SceneBuilder::SceneBuilder(nodes::Graph graph) : graph_(std::move(graph)) {
  double left = 0, bottom = 0;
  bool any = false;
  for (const auto& [name, node] : graph_.nodes) {
    left = any ? std::min(left, node->at.x) : node->at.x;
    bottom = any ? std::max(bottom, node->at.y + 240) : node->at.y + 240;
    any = true;
  }
  origin_ = {left, bottom};
}

std::string SceneBuilder::add(std::string_view type, double column, double row, std::string_view wanted) {
  const std::string name = nodes::freeName(graph_, nodes::checkName(wanted) ? std::string(wanted) : "Volume");
  take(nodes::addNode(graph_, type, origin_ + dvec2(column * kStepX, row * kStepY), name));
  added_.insert(name);
  return name;
}

void SceneBuilder::set(const std::string& node, const std::string& param, const nodes::ParamValue& value) {
  take(nodes::setParam(graph_, node, param, value));
}

void SceneBuilder::link(const std::string& from, const std::string& out, const std::string& to,
                        const std::string& in) {
  const nodes::Link wanted{from, out, to, in};
  if (std::find(graph_.links.begin(), graph_.links.end(), wanted) == graph_.links.end())
    take(nodes::connect(graph_, wanted));
}

Result<nodes::Graph> SceneBuilder::finish() {
  if (error_) return *error_;
  return std::move(graph_);
}

void SceneBuilder::take(Result<nodes::Graph> next) {
  if (next)
    graph_ = std::move(*next);
  else if (!error_)
    error_ = next.error();
}

}  // namespace pileus::editor
