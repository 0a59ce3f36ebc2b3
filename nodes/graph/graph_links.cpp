// Edits of links and of the sockets they end at.
#include "nodes/graph/graph_change.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::nodes {
namespace {

std::vector<Link>::iterator linkAt(Graph& graph, const Link& link) {
  return std::find_if(graph.links.begin(), graph.links.end(),
                      [&](const Link& l) { return sameEnds(l, link); });
}

Error noSuchLink(const Link& link) { return fail(Code::Arguments, "there is no link {}", linkText(link)); }

}  // namespace

Result<Graph> addDot(const Graph& graph, const Link& link, dvec2 at, std::string* name) {
  Graph result = graph;
  const auto place = linkAt(result, link);
  if (place == result.links.end()) return noSuchLink(link);
  const std::string dot = freeName(graph, "Dot");
  PILEUS_TRY(const Graph withNode, addNode(graph, "dot", at, dot));
  result.nodes = withNode.nodes;
  const Link into{place->fromNode, place->fromSocket, dot, "in", false};
  place->fromNode = dot;
  place->fromSocket = "out";
  result.links.insert(place, into);
  if (name) *name = dot;
  return result;
}

Result<Graph> insertOnLink(const Graph& graph, const std::string& node, const Link& wanted) {
  Graph result = graph;
  const auto place = linkAt(result, wanted);
  if (place == result.links.end()) return noSuchLink(wanted);
  if (!findNode(graph, node)) return fail(Code::Arguments, "there is no node '{}'", node);
  const Link link = *place;
  if (link.fromNode == node || link.toNode == node)
    return fail(Code::Arguments, "{} is at an end of this link", node);
  result.links.erase(place);
  const SocketTable table(result);
  std::string reason;
  for (const SocketInfo& in : table.inputs(node)) {
    const Link before{link.fromNode, link.fromSocket, node, in.id, false};
    if (const auto refused = table.refusal(before)) {
      if (reason.empty()) reason = *refused;
      continue;
    }
    for (const SocketInfo& out : table.outputs(node)) {
      const Link after{node, out.id, link.toNode, link.toSocket, link.muted};
      if (const auto refused = table.refusal(after)) {
        reason = *refused;
        continue;
      }
      // The old link's place goes to the one that takes over its end; a duplicate in a many-input stays where
      // it was.
      const auto made = connect(graph, before);
      if (!made) {
        reason = made.error().message;
        continue;
      }
      Graph done = *made;
      const auto old = linkAt(done, link);
      if (hasLink(done, after))
        done.links.erase(old);
      else
        *old = after;
      // Both together must fit as well: a dot's type is decided by both ends.
      const Graph without = disconnect(done, after);
      if (const auto refused = linkRefusal(without, after)) {
        reason = *refused;
        continue;
      }
      return done;
    }
  }
  if (reason.empty()) reason = node + " has no input and output to put on a link";
  return fail(Code::Arguments, "{}", reason);
}

Graph muteLinks(const Graph& graph, const std::vector<Link>& links, bool muted) {
  Graph result = graph;
  for (const Link& link : links)
    if (const auto it = linkAt(result, link); it != result.links.end()) it->muted = muted;
  return result;
}

Graph disconnectAll(const Graph& graph, const std::vector<Link>& links) {
  Graph result = graph;
  for (const Link& link : links)
    std::erase_if(result.links, [&](const Link& l) { return sameEnds(l, link); });
  return result;
}

Result<Graph> moveLinks(const Graph& graph, const std::string& fromNode, const std::string& fromSocket,
                        const std::string& toNode, const std::string& toSocket) {
  if (fromNode == toNode && fromSocket == toSocket) return graph;
  const auto leaves = [&](const Link& l) { return l.fromNode == fromNode && l.fromSocket == fromSocket; };
  Graph rest = graph;
  std::erase_if(rest.links, leaves);
  if (!SocketTable(graph).output(toNode, toSocket))
    return fail(Code::Arguments, "{} has no output '{}'", toNode, toSocket);
  Graph result = graph;
  for (const Link& link : graph.links) {
    if (!leaves(link)) continue;
    const Link moved{toNode, toSocket, link.toNode, link.toSocket, link.muted};
    if (const auto reason = linkRefusal(rest, moved))
      return fail(Code::Arguments, "{}: {}", linkText(moved), *reason);
    const auto place = linkAt(result, link);
    if (hasLink(rest, moved)) {
      result.links.erase(place);  // it is there already
    } else {
      *place = moved;
      rest.links.push_back(moved);
    }
  }
  return result;
}

Result<Graph> exposeParam(const Graph& graph, const std::string& name, const std::string& param, bool on) {
  const Node* node = findNode(graph, name);
  if (!node) return fail(Code::Arguments, "there is no node '{}'", name);
  const NodeType* type = findNodeType(node->type);
  const ParamSpec* spec = type ? type->param(param) : nullptr;
  if (!spec) return fail(Code::Arguments, "{} ({}) has no parameter '{}'", name, node->type, param);
  if (on && constantOnly(spec->type)) return fail(Code::Arguments, "{}.{} takes no link", name, param);
  Graph result = graph;
  if (on) {
    if (!isSocket(*node, *spec)) expose(result, name, param);
    return result;
  }
  if (spec->socket) return fail(Code::Arguments, "{}.{} is always a socket", name, param);
  changeNode(result, name, [&](Node& n) { std::erase(n.expose, param); });
  std::erase_if(result.links, [&](const Link& l) { return l.toNode == name && l.toSocket == param; });
  return result;
}

}  // namespace pileus::nodes
