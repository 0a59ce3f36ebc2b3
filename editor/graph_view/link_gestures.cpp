#include "editor/graph_view/link_gestures.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/draw_link.h"
#include "editor/graph_view/layout/path_geometry.h"
#include "editor/toolkit/ui.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::editor {
namespace {

nodes::Link linkBetween(const LinkDrag& drag, const std::string& node, const std::string& socket) {
  return drag.fromOutput ? nodes::Link{drag.node, drag.socket, node, socket}
                         : nodes::Link{node, socket, drag.node, drag.socket};
}

nodes::Graph graphForDrag(const Session& session, const LinkDrag& drag) {
  nodes::Graph graph = session.document.graph();
  if (drag.replaces) graph = nodes::disconnect(graph, *drag.replaces);
  for (const nodes::Link& link : drag.moves) graph = nodes::disconnect(graph, link);
  return graph;
}

/// Does the link under way look for an input?
bool wantsInput(const LinkDrag& drag) { return drag.fromOutput && drag.moves.empty(); }

std::optional<std::string> refusal(const nodes::SocketTable& table, const LinkDrag& drag,
                                   const std::string& node, const std::string& socket) {
  if (drag.moves.empty()) return table.refusal(linkBetween(drag, node, socket));
  for (const nodes::Link& link : drag.moves)
    if (auto reason = table.refusal({node, socket, link.toNode, link.toSocket})) return reason;
  return std::nullopt;
}

std::string plural(std::size_t count, const char* one, const char* many) {
  return count == 1 ? one : fmt::format("{} {}", count, many);
}

void dropOnCanvas(Ui& ui, Session& session, Canvas& canvas, const CanvasView& view,
                  const command::LinkDrop& drop) {
  const LinkDrag& drag = drop.drag;
  // Dropping picked-off links on nothing removes them; a new one asks which node shall follow.
  if (drag.replaces || !drag.moves.empty())
    tryEdit(session, ui.messages, graphForDrag(session, drag),
            "Remove " + plural(std::max<std::size_t>(drag.moves.size(), 1), "link", "links"));
  else
    openSearch(session, canvas, drop.at, view.canvas(drop.at), drag);
}

std::vector<nodes::Link> linksOf(const std::vector<Crossing>& crossed) {
  std::vector<nodes::Link> links;
  for (const Crossing& c : crossed) links.push_back(c.link);
  return links;
}

/// Mutes the crossed links, or takes all back when they are muted already.
void muteLinks(Ui& ui, Session& session, const std::vector<Crossing>& crossed) {
  const bool all =
      std::all_of(crossed.begin(), crossed.end(), [](const Crossing& c) { return c.link.muted; });
  tryEdit(session, ui.messages, nodes::muteLinks(session.document.graph(), linksOf(crossed), !all),
          (all ? "Unmute " : "Mute ") + plural(crossed.size(), "link", "links"));
}

/// A dot's position is the corner of a square of 20 around its middle.
dvec2 dotPlace(vec2 middle) { return glm::round(dvec2(middle)) - 10.0; }

/// One dot for each output whose links are crossed; links of one output go through it together.
void putDots(Ui& ui, Session& session, const std::vector<Crossing>& crossed) {
  nodes::Graph graph = session.document.graph();
  std::map<std::pair<std::string, std::string>, std::vector<Crossing>> byOutput;
  for (const Crossing& c : crossed) byOutput[{c.link.fromNode, c.link.fromSocket}].push_back(c);
  std::set<std::string> dots;
  for (const auto& [output, links] : byOutput) {
    vec2 middle(0);
    for (const Crossing& c : links) middle += c.at / static_cast<float>(links.size());
    std::string dot;
    Result<nodes::Graph> added = nodes::addDot(graph, links.front().link, dotPlace(middle), &dot);
    if (!added) return ui.messages.hint(added.error().message);
    graph = std::move(*added);
    const std::string out = nodes::outputsOf(graph, dot).front().id;
    for (nodes::Link& link : graph.links)
      for (std::size_t i = 1; i < links.size(); ++i)
        if (link == links[i].link) link.fromNode = dot, link.fromSocket = out;
    dots.insert(dot);
  }
  if (tryEdit(session, ui.messages, std::move(graph),
              dots.size() == 1 ? "Add dot" : fmt::format("Add {} dots", dots.size())))
    session.document.select(std::move(dots));
}

}  // namespace

void startLink(Session& session, Canvas& canvas, const Layout& layout, const LinkDrag& drag) {
  canvas.refusals.clear();
  session.selectedLink.reset();
  const nodes::Graph graph = graphForDrag(session, drag);
  const nodes::SocketTable table(graph);
  const bool input = wantsInput(drag);
  for (const NodePlace& node : layout.nodes)
    for (const SocketPlace& s : node.sockets) {
      const std::string key = socketKey(node.name, s.id, s.input);
      if (node.name == drag.node && s.id == drag.socket && s.input != drag.fromOutput)
        continue;  // the fixed end itself
      if (s.input != input)
        canvas.refusals[key] = input ? "Both ends are outputs: a link ends at an input."
                                     : "Both ends are inputs: a link begins at an output.";
      else if (auto reason = refusal(table, drag, node.name, s.id))
        canvas.refusals[key] = *reason;
    }
}

void dropLink(Ui& ui, Session& session, Canvas& canvas, const CanvasView& view,
              const command::LinkDrop& drop) {
  const LinkDrag& drag = drop.drag;
  const Hit& on = drop.on;
  if (on.kind == Hit::Kind::Canvas || on.kind == Hit::Kind::Frame)
    return dropOnCanvas(ui, session, canvas, view, drop);
  if (on.kind != Hit::Kind::Input && on.kind != Hit::Kind::Output) return;
  if (on.node == drag.node && on.socket == drag.socket) return;
  const auto refused = canvas.refusals.find(socketKey(on.node, on.socket, on.kind == Hit::Kind::Input));
  if (refused != canvas.refusals.end()) return ui.messages.hint(refused->second);
  if (!drag.moves.empty())
    return void(
        tryEdit(session, ui.messages,
                nodes::moveLinks(session.document.graph(), drag.node, drag.socket, on.node, on.socket),
                "Move " + plural(drag.moves.size(), "link", "links")));
  tryEdit(session, ui.messages,
          nodes::connect(graphForDrag(session, drag), linkBetween(drag, on.node, on.socket)), "Link");
}

Hit snappedToNode(const Session& session, const Canvas& canvas, const Layout& layout, const Hit& hit) {
  const LinkDrag& drag = canvas.interaction.link;
  const NodePlace* place = hit.kind == Hit::Kind::Node ? findPlace(layout, hit.node) : nullptr;
  if (!place || hit.node == drag.node) return hit;
  const bool input = wantsInput(drag);
  const SocketPlace* taken = nullptr;
  const auto at = [&](const SocketPlace& s) {
    Hit socket = hit;
    socket.kind = input ? Hit::Kind::Input : Hit::Kind::Output;
    socket.socket = s.id;
    return socket;
  };
  for (const SocketPlace& s : place->sockets) {
    if (s.input != input || canvas.refusals.contains(socketKey(hit.node, s.id, s.input))) continue;
    const auto& links = session.document.graph().links;
    const bool free = !input || s.many || std::none_of(links.begin(), links.end(), [&](const nodes::Link& l) {
      return l.toNode == hit.node && l.toSocket == s.id;
    });
    if (free) return at(s);
    if (!taken) taken = &s;
  }
  return taken ? at(*taken) : hit;
}

std::string refusalAt(const Canvas& canvas, const Layout& layout, const Hit& hit) {
  const LinkDrag& drag = canvas.interaction.link;
  if (hit.kind == Hit::Kind::Input || hit.kind == Hit::Kind::Output) {
    const auto found = canvas.refusals.find(socketKey(hit.node, hit.socket, hit.kind == Hit::Kind::Input));
    return found == canvas.refusals.end() ? std::string() : found->second;
  }
  if (hit.kind != Hit::Kind::Node || hit.node == drag.node || !findPlace(layout, hit.node)) return {};
  return fmt::format("No {} of {} takes this link.", wantsInput(drag) ? "input" : "output", hit.node);
}

void finishStroke(Ui& ui, Session& session, const CanvasView& view, const Layout& layout,
                  const command::StrokeDone& stroke) {
  std::vector<vec2> line = stroke.points;
  for (vec2& p : line) p = view.canvas(p);
  const std::vector<Crossing> crossed = crossings(layout, session.document.graph(), line);
  if (crossed.empty()) return ui.messages.hint("The line crosses no link.");
  if (stroke.kind == Stroke::Cut)
    tryEdit(session, ui.messages, nodes::disconnectAll(session.document.graph(), linksOf(crossed)),
            "Cut " + plural(crossed.size(), "link", "links"));
  else if (stroke.kind == Stroke::Mute)
    muteLinks(ui, session, crossed);
  else
    putDots(ui, session, crossed);
}

void putDot(Ui& ui, Session& session, const nodes::Link& link, dvec2 at) {
  std::string dot;
  if (!tryEdit(session, ui.messages, nodes::addDot(session.document.graph(), link, dotPlace(vec2(at)), &dot),
               "Add dot"))
    return;
  session.selectedLink.reset();
  session.document.select({dot});
}

void dotOnSelectedLink(Ui& ui, Session& session) {
  if (!session.selectedLink) return;
  const nodes::Link link = *session.selectedLink;
  const Layout layout = layoutGraph(session.document.graph(), {});
  vec2 from, to;
  nodes::SocketType type;
  if (linkEnds(layout, link, from, to, type)) putDot(ui, session, link, dvec2(0.5f * (from + to)));
}

}  // namespace pileus::editor
