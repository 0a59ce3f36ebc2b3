#pragma once
// More edits of a graph (see graph.h): links, selections of nodes, dots. Each returns a new graph.
#include <set>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::nodes {

// Links.

/// A dot on a link, which keeps its place within a many-input; `name` gets the dot's name.
Result<Graph> addDot(const Graph& graph, const Link& link, dvec2 at, std::string* name = nullptr);
/// Puts a node on a link by its first input and output that fit; the link's place within a many-input is
/// kept, links the node had at that input are replaced. The error says why it does not fit.
Result<Graph> insertOnLink(const Graph& graph, const std::string& node, const Link& link);
Graph muteLinks(const Graph& graph, const std::vector<Link>& links, bool muted);
Graph disconnectAll(const Graph& graph, const std::vector<Link>& links);
/// Every link that leaves `from` leaves `to` instead, in its place. All or none.
Result<Graph> moveLinks(const Graph& graph, const std::string& fromNode, const std::string& fromSocket,
                        const std::string& toNode, const std::string& toSocket);
/// Makes a parameter an input socket, or takes it off together with its link.
Result<Graph> exposeParam(const Graph& graph, const std::string& node, const std::string& param, bool on);

// Nodes.

/// Takes nodes out of their chain, which closes behind them; they keep links among themselves.
Graph extractNodes(const Graph& graph, const std::set<std::string>& names);
/// Copies with the links among them, moved by `by`; keepInputs: also those from other nodes. In many-inputs
/// of other nodes nothing changes. `newNames` gets the copies' names.
Graph duplicateNodes(const Graph& graph, const std::set<std::string>& names, bool keepInputs, dvec2 by,
                     std::set<std::string>* newNames = nullptr);
Graph disableNodes(const Graph& graph, const std::set<std::string>& names, bool disabled);
/// Every parameter back to its default: constants, animations and what could not be read. Links stay.
Graph resetParams(const Graph& graph, const std::string& node);
Graph setColor(const Graph& graph, const std::set<std::string>& names,
               const std::string& color);                                               ///< "" = none
Graph setLabel(const Graph& graph, const std::string& node, const std::string& label);  ///< "" = none

/// The nodes and all they need, or all that needs them. Muted links count.
std::set<std::string> upstreamOf(const Graph& graph, const std::set<std::string>& names);
std::set<std::string> downstreamOf(const Graph& graph, const std::set<std::string>& names);

}  // namespace pileus::nodes
