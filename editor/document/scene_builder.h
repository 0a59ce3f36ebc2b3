#pragma once
// Nodes and links added to a graph one after the other, below what is there. Pure.
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "nodes/graph/graph.h"

namespace pileus::editor {

/// A graph that is being added to; the first refusal stays, and finish() tells it.
class SceneBuilder {
 public:
  explicit SceneBuilder(nodes::Graph graph);

  /// A node in a column and row below what is there; a name that is taken gets a number. Returns its name.
  std::string add(std::string_view type, double column, double row, std::string_view wanted);
  void set(const std::string& node, const std::string& param, const nodes::ParamValue& value);
  /// Nothing where that link is there already.
  void link(const std::string& from, const std::string& out, const std::string& to, const std::string& in);

  const nodes::Graph& graph() const { return graph_; }
  const std::set<std::string>& added() const { return added_; }
  Result<nodes::Graph> finish();

 private:
  void take(Result<nodes::Graph> next);

  nodes::Graph graph_;
  std::set<std::string> added_;
  dvec2 origin_{0};
  std::optional<Error> error_;
};

}  // namespace pileus::editor
