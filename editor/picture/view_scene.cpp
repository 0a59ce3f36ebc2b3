#include "editor/picture/view_scene.h"

#include <algorithm>
#include <deque>
#include <set>

#include "editor/document/session.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/time/clock.h"
#include "nodes/declare/value.h"
#include "nodes/evaluate/flatten.h"
#include "nodes/graph/graph_groups.h"

namespace pileus::editor {
namespace {

template <class Value>
struct ItemsOf;
template <>
struct ItemsOf<nodes::VolumeValue> {
  static constexpr nodes::SocketType type = nodes::SocketType::Volume;
};
template <>
struct ItemsOf<nodes::SolidValue> {
  static constexpr nodes::SocketType type = nodes::SocketType::Solid;
};

const nodes::NodeType* typeOf(const nodes::Graph& graph, const std::string& name) {
  const nodes::Node* node = nodes::findNode(graph, name);
  return node ? nodes::findNodeType(node->type) : nullptr;
}

/// Active links into the inputs of a type, as the evaluator joins them.
std::vector<const nodes::Link*> linksOfType(const nodes::Graph& graph, const std::string& node,
                                            nodes::SocketType wanted) {
  std::vector<const nodes::Link*> out;
  const nodes::NodeType* type = typeOf(graph, node);
  if (!type) return out;
  for (const nodes::SocketSpec& s : type->inputs)
    if (s.any || s.type == wanted)
      for (const nodes::Link& link : graph.links)
        if (link.toNode == node && link.toSocket == s.id && !link.muted) out.push_back(&link);
  return out;
}

template <class Value>
const Value* valueOf(const Shown& shown, const nodes::Link& link) {
  const nodes::SocketValue* value = shown.preview.evaluator().lastGood(link.fromNode, link.fromSocket);
  return value ? std::get_if<Value>(value) : nullptr;
}

/// Follows item `index` of a node's list to where it comes from.
template <class Value>
void follow(const Shown& shown, const nodes::Graph& graph, const std::string& node, std::size_t index,
            std::vector<std::string>& chain) {
  chain.push_back(node);
  if (chain.size() > graph.nodes.size()) return;
  std::size_t first = 0;
  for (const nodes::Link* link : linksOfType(graph, node, ItemsOf<Value>::type)) {
    const Value* value = valueOf<Value>(shown, *link);
    if (!value) return;
    if (index < first + value->items.size())
      return follow<Value>(shown, graph, link->fromNode, index - first, chain);
    first += value->items.size();
  }
}

template <class Value, class Add>
void collect(const nodes::Graph& graph, const Shown& shown, const std::string& user, const Add& add) {
  for (const nodes::Link* link : linksOfType(graph, user, ItemsOf<Value>::type))
    if (const Value* value = valueOf<Value>(shown, *link))
      for (std::size_t i = 0; i < value->items.size(); ++i) {
        std::vector<std::string> chain;
        follow<Value>(shown, graph, link->fromNode, i, chain);
        add(value->items[i], std::move(chain));
      }
}

void collectLights(const nodes::Graph& graph, const Clock& clock, const std::string& user,
                   std::vector<PlacedLight>& out) {
  std::deque<std::string> open{user};
  std::set<std::string> seen{user};
  for (; !open.empty(); open.pop_front())
    for (const nodes::Link& link : graph.links) {
      if (link.toNode != open.front() || link.muted || !seen.insert(link.fromNode).second) continue;
      open.push_back(link.fromNode);
      const nodes::Node* node = nodes::findNode(graph, link.fromNode);
      if (node && node->type.starts_with("light."))
        if (auto target = gizmoTarget(graph, link.fromNode, dvec3(0), clock.frame))
          out.push_back({link.fromNode, *target});
    }
  std::sort(out.begin(), out.end(),
            [](const PlacedLight& a, const PlacedLight& b) { return a.node < b.node; });
}

bool anySelected(const Session& session, const std::vector<std::string>& chain) {
  return std::any_of(chain.begin(), chain.end(), [&](const std::string& n) { return selects(session, n); });
}

/// Paths of the nodes that have handles, the first two.
void addHandled(const nodes::Graph& graph, const std::string& prefix, double frame,
                std::vector<std::string>& out) {
  for (const auto& [name, node] : graph.nodes) {
    if (out.size() > 1) return;
    if (node->group)
      addHandled(*node->group, prefix + name + "/", frame, out);
    else if (gizmoTarget(graph, name, {}, frame))
      out.push_back(prefix + name);
  }
}

ViewScene viewScene(const Session& session, const Clock& clock, const Shown& shown) {
  ViewScene scene;
  const std::string user = cameraUser(session, shownView(session, shown));
  if (user.empty()) return scene;
  const nodes::FlatGraph flat = nodes::flatten(session.document.root());
  collect<nodes::VolumeValue>(flat.graph, shown, user,
                              [&](const volume::Instance& i, std::vector<std::string> chain) {
                                const Box3 bounds = volume::worldBounds(i);
                                if (bounds.empty()) return;
                                scene.bounds.extend(bounds);
                                scene.volumes.push_back({i, bounds, std::move(chain)});
                              });
  collect<nodes::SolidValue>(flat.graph, shown, user,
                             [&](const scene::Solid& s, std::vector<std::string> chain) {
                               scene.solids.push_back({s, std::move(chain)});
                             });
  collectLights(flat.graph, clock, user, scene.lights);
  return scene;
}

}  // namespace

void followScene(const Session& session, const Clock& clock, Shown& shown) {
  // It changes with document and frame, and once more when their values have been worked out.
  SceneCache& cache = shown.scene;
  const Preview& preview = shown.preview;
  const std::string view = shownView(session, shown);
  if (cache.complete && preview.complete() && cache.revision == session.document.revision() &&
      cache.view == view && cache.frame == clock.frame && cache.answered == preview.answered())
    return;
  static_cast<ViewScene&>(cache) = viewScene(session, clock, shown);
  cache.complete = preview.complete();
  cache.revision = session.document.revision();
  cache.view = view;
  cache.frame = clock.frame;
  cache.answered = preview.answered();
}

Box3 selectionBounds(const Session& session, const ViewScene& scene) {
  Box3 box;
  for (const PlacedVolume& v : scene.volumes)
    if (anySelected(session, v.chain)) box.extend(v.bounds);
  for (const PlacedSolid& s : scene.solids)
    if (anySelected(session, s.chain)) box.extend(scene::worldBounds(scene::SolidList{s.solid}));
  for (const PlacedLight& l : scene.lights) {
    if (!selects(session, l.node) || l.target.sun) continue;
    // A point has no size: what is about it is seen with it.
    const double around = std::max(l.target.aims ? glm::length(l.target.aim - l.target.position)
                                                 : 0.15 * glm::length(scene.bounds.size()),
                                   0.5);
    box.extend(Box3{l.target.position - around, l.target.position + around});
  }
  return box;
}

dvec3 sunCenter(const ViewScene& scene, const Projection& view) {
  if (!scene.bounds.empty())
    if (const auto at = view.screen(scene.bounds.center()); at && view.contains(*at))
      return scene.bounds.center();
  const double depth = scene.bounds.empty() ? 10
                                            : std::max(view.depth(scene.bounds.center()),
                                                       0.1 * glm::length(scene.bounds.size()));
  return view.eye() + depth * view.forward();
}

dvec3 pivotOf(const Shown& shown, const std::string& node) {
  const nodes::SocketValue* value = shown.preview.evaluator().lastGoodInput(node, "volume");
  const auto* volumes = value ? std::get_if<nodes::VolumeValue>(value) : nullptr;
  const Box3 box = volumes ? volume::worldBounds(volumes->items) : Box3{};
  return box.empty() ? dvec3(0) : box.center();
}

std::string onlySelected(const Session& session) {
  const auto& selection = session.document.selection();
  return selection.size() == 1 ? *selection.begin() : std::string();
}

bool selects(const Session& session, const std::string& path) {
  return session.document.selection().contains(shownInScope(session, path));
}

std::string shownInScope(const Session& session, const std::string& path) {
  const std::string scope = session.document.scopedName("");
  if (!path.starts_with(scope)) return {};
  const std::string rest = path.substr(scope.size());
  return rest.substr(0, rest.find('/'));
}

std::string handledNode(const Session& session, const std::string& inside, double frame) {
  const std::string name = onlySelected(session);
  if (name.empty()) return {};
  const std::string path = session.document.scopedName(name);
  const nodes::Graph* group = nodes::groupGraph(session.document.graph(), name);
  if (!group) return path;
  if (inside.starts_with(path + "/") && nodes::findNodeAt(session.document.root(), inside)) return inside;
  std::vector<std::string> all;
  addHandled(*group, path + "/", frame, all);
  return all.size() == 1 ? all.front() : std::string();
}

}  // namespace pileus::editor
