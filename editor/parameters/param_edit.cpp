#include "editor/parameters/param_edit.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <set>

#include "editor/document/session.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/time/playback.h"
#include "editor/toolkit/ui.h"
#include "nodes/file/serialize.h"
#include "nodes/graph/graph_animation.h"
#include "nodes/graph/graph_edits.h"
#include "nodes/graph/graph_sockets.h"

namespace pileus::editor {
namespace {

using nodes::Graph;
using nodes::ParamSpec;
using nodes::ParamValue;

std::string mergeKey(const ParamTarget& target) { return "param " + target.key(); }

void remember(const Session& session, Parameters& parameters, const ParamTarget& target) {
  DragMemory& memory = parameters.drag;
  if (memory.key == target.key()) return;
  memory.key = target.key();
  memory.before.clear();
  for (const std::string& name : target.nodes)
    if (const auto it = session.document.graph().nodes.find(name); it != session.document.graph().nodes.end())
      memory.before[name] = it->second;
}

/// Each node's edit in turn; the first that is refused refuses all.
Result<Graph> onEach(const Session& session, const std::vector<std::string>& names,
                     const std::function<Result<Graph>(const Graph&, const std::string&)>& edit) {
  Graph graph = session.document.graph();
  for (const std::string& name : names) {
    if (!nodes::findNode(graph, name)) continue;
    PILEUS_TRY(graph, edit(graph, name));
  }
  return graph;
}

void compare(ParamState& state, const ParamValue& other) {
  const dvec3 *a = std::get_if<dvec3>(&state.value), *b = std::get_if<dvec3>(&other);
  if (!a || !b) {
    state.differs[0] |= !(state.value == other);
    return;
  }
  for (int i = 0; i < 3; ++i) state.differs[static_cast<std::size_t>(i)] |= (*a)[i] != (*b)[i];
}

bool hasKeyAt(const nodes::Node& node, const std::string& param, int frame) {
  const auto it = node.animated.find(param);
  return it != node.animated.end() &&
         std::any_of(it->second.keys.begin(), it->second.keys.end(),
                     [&](const nodes::AnimationKey& k) { return k.frame == frame; });
}

void findSource(const Graph& graph, const ParamTarget& target, ParamState& state) {
  for (const nodes::Link& link : graph.links)
    if (!link.muted && link.toNode == target.nodes.front() && link.toSocket == target.spec->id)
      state.sourceNode = link.fromNode, state.sourceSocket = link.fromSocket;
}

}  // namespace

std::string ParamTarget::key() const { return nodes.front() + "." + spec->id; }

std::string ParamTarget::title() const {
  return nodes.size() == 1 ? key() : fmt::format("{} of {} nodes", spec->id, nodes.size());
}

ParamState paramState(const Session& session, const Clock& clock, const ParamTarget& target) {
  const Graph& graph = session.document.graph();
  const std::string& id = target.spec->id;
  ParamState state;
  state.value = target.spec->fallback;
  bool first = true;
  for (const std::string& name : target.nodes) {
    const nodes::Node* node = nodes::findNode(graph, name);
    if (!node) continue;
    const ParamValue value = nodes::paramValue(*node, *target.spec, clock.frame);
    if (first)
      state.value = value;
    else
      compare(state, value);
    first = false;
    state.animated |= node->animated.contains(id);
    state.keyHere |= hasKeyAt(*node, id, clock.frame);
    state.faulty |= node->unknown.contains("params/" + id);
    state.modified |= node->params.contains(id) || state.animated || state.faulty;
    state.exposed |= nodes::isSocket(*node, *target.spec);
  }
  findSource(graph, target, state);
  return state;
}

void changeParam(const ParameterRoom& room, const ParamTarget& target, const ParamChange& change,
                 bool dragging) {
  if (dragging) remember(room.session, room.parameters, target);
  // An animated parameter gets a key, and all of a drag at one frame.
  for (const std::string& name : target.nodes)
    if (const nodes::Node* node = nodes::findNode(room.session.document.graph(), name))
      if (node->animated.contains(target.spec->id)) stopPlayback(room.clock);
  Result<Graph> graph = onEach(room.session, target.nodes, [&](const Graph& g, const std::string& name) {
    const ParamValue value =
        change(nodes::paramValue(*nodes::findNode(g, name), *target.spec, room.clock.frame));
    return nodes::setParamAt(g, name, target.spec->id, value, room.clock.frame);
  });
  tryEdit(room.session, room.ui.messages, std::move(graph), "Set " + target.title(),
          dragging ? mergeKey(target) : "");
  if (dragging) room.shown.preview.touch();
}

void setParamValue(const ParameterRoom& room, const ParamTarget& target, const ParamValue& value,
                   bool dragging) {
  changeParam(
      room, target, [&](const ParamValue&) { return value; }, dragging);
}

void endParamEdit(Ui& ui, Session& session, Parameters& parameters, const ParamTarget& target,
                  bool cancelled) {
  DragMemory& memory = parameters.drag;
  if (cancelled && memory.key == target.key()) {
    Graph graph = session.document.graph();
    for (const auto& [name, node] : memory.before)
      if (graph.nodes.contains(name)) graph.nodes[name] = node;
    // The document drops a step that ends where it began.
    tryEdit(session, ui.messages, std::move(graph), "Set " + target.title(), mergeKey(target));
  }
  memory = {};
  session.document.endMerge();
}

void resetParam(Ui& ui, Session& session, const ParamTarget& target) {
  tryEdit(session, ui.messages,
          onEach(session, target.nodes,
                 [&](const Graph& g, const std::string& name) {
                   return nodes::setParam(g, name, target.spec->id, target.spec->fallback);
                 }),
          "Reset " + target.title());
}

void resetNodes(Ui& ui, Session& session, const std::vector<std::string>& names) {
  if (names.empty()) return;
  tryEdit(session, ui.messages,
          onEach(session, names,
                 [&](const Graph& g, const std::string& name) {
                   return Result<Graph>(nodes::resetParams(g, name));
                 }),
          names.size() == 1 ? "Reset " + names.front() : fmt::format("Reset {} nodes", names.size()));
}

void toggleKey(Ui& ui, Session& session, const Clock& clock, const ParamTarget& target) {
  const bool remove = paramState(session, clock, target).keyHere;
  Result<Graph> graph =
      onEach(session, target.nodes, [&](const Graph& g, const std::string& name) -> Result<Graph> {
        const nodes::Node& node = *nodes::findNode(g, name);
        if (remove)
          return hasKeyAt(node, target.spec->id, clock.frame)
                     ? Result<Graph>(nodes::removeKey(g, name, target.spec->id, clock.frame))
                     : Result<Graph>(g);
        const ParamValue value = nodes::paramValue(node, *target.spec, clock.frame);
        return nodes::setKey(g, name, target.spec->id, clock.frame, value);
      });
  if (tryEdit(
          session, ui.messages, std::move(graph),
          fmt::format("{} key of {} at frame {}", remove ? "Remove" : "Set", target.title(), clock.frame)))
    ui.messages.note(
        fmt::format("{} of {} at frame {}", remove ? "Key removed" : "Key set", target.title(), clock.frame));
}

void clearAnimation(Ui& ui, Session& session, const Clock& clock, const ParamTarget& target) {
  tryEdit(session, ui.messages,
          onEach(session, target.nodes,
                 [&](const Graph& g, const std::string& name) {
                   return Result<Graph>(nodes::clearAnimation(g, name, target.spec->id, clock.frame));
                 }),
          "Remove animation of " + target.title());
}

bool canExpose(const ParamSpec& spec) { return !spec.socket && !nodes::constantOnly(spec.type); }

void toggleExposed(Ui& ui, Session& session, const Clock& clock, const ParamTarget& target) {
  const bool on = !paramState(session, clock, target).exposed;
  tryEdit(session, ui.messages,
          onEach(session, target.nodes,
                 [&](const Graph& g, const std::string& name) {
                   return nodes::exposeParam(g, name, target.spec->id, on);
                 }),
          (on ? "Expose " : "Do not expose ") + target.title());
}

void copyParam(const Session& session, const Clock& clock, const ParamTarget& target) {
  ImGui::SetClipboardText(nodes::formatParam(*target.spec, paramState(session, clock, target).value).c_str());
}

void pasteParam(const ParameterRoom& room, const ParamTarget& target) {
  const char* text = ImGui::GetClipboardText();
  const std::string whole = text ? text : "";
  std::size_t end = std::min<std::size_t>(whole.size(), 40);
  while (end > 0 && end < whole.size() && (static_cast<unsigned char>(whole[end]) & 0xC0) == 0x80)
    --end;  // UTF-8
  const std::string shown = whole.substr(0, end);
  Result<ParamValue> value = nodes::parseParam(*target.spec, text ? text : "");
  if (value) value = nodes::checkedParam(*target.spec, *value);
  if (!value)
    return room.ui.messages.hint(
        fmt::format("\"{}\" does not fit {}: {}", shown, target.spec->label, value.error().message));
  setParamValue(room, target, *value);
}

void pasteValues(Ui& ui, Session& session, const Clock& clock, const std::vector<std::string>& names) {
  const char* text = ImGui::GetClipboardText();
  std::set<std::string> pasted;
  const Result<Graph> from = nodes::pasteText(Graph{}, text ? text : "", {0, 0}, &pasted);
  if (!from || pasted.empty())
    return ui.messages.hint("Copy a node first: its values can then be pasted onto another one.");
  const std::string& sourceName = *pasted.begin();
  const nodes::Node& source = *nodes::findNode(*from, sourceName);
  const nodes::NodeType* sourceType = nodes::findNodeType(source.type);
  if (!sourceType) return ui.messages.hint("The node on the clipboard is of an unknown type.");
  int count = 0;
  Result<Graph> graph = onEach(session, names, [&](const Graph& g, const std::string& name) -> Result<Graph> {
    Graph next = g;
    const nodes::NodeType* type = nodes::findNodeType(nodes::findNode(g, name)->type);
    if (!type) return next;
    for (const ParamSpec& spec : type->params) {
      const ParamSpec* other = sourceType->param(spec.id);
      if (!other) continue;
      Result<ParamValue> value = nodes::checkedParam(spec, nodes::paramValue(source, *other, clock.frame));
      if (!value) continue;  // a value that does not fit stays as it is
      PILEUS_TRY(next, nodes::setParam(next, name, spec.id, *value));
      ++count;
    }
    return next;
  });
  if (graph && count == 0)
    return ui.messages.hint(fmt::format("{} and this node have no parameters in common.", sourceType->label));
  if (tryEdit(session, ui.messages, std::move(graph), "Paste values of " + sourceName))
    ui.messages.note(fmt::format("Values of {} pasted", sourceName));
}

}  // namespace pileus::editor
