#include "editor/parameters/param_edit.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <set>

#include "editor/app/editor.h"
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

void remember(Editor& editor, const ParamTarget& target) {
  DragMemory& memory = editor.parameters.drag;
  if (memory.key == target.key()) return;
  memory.key = target.key();
  memory.before.clear();
  for (const std::string& name : target.nodes)
    if (const auto it = editor.document.graph().nodes.find(name); it != editor.document.graph().nodes.end())
      memory.before[name] = it->second;
}

/// Each node's edit in turn; the first that is refused refuses all.
Result<Graph> onEach(const Editor& editor, const std::vector<std::string>& names,
                     const std::function<Result<Graph>(const Graph&, const std::string&)>& edit) {
  Graph graph = editor.document.graph();
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

ParamState paramState(const Editor& editor, const ParamTarget& target) {
  const Graph& graph = editor.document.graph();
  const std::string& id = target.spec->id;
  ParamState state;
  state.value = target.spec->fallback;
  bool first = true;
  for (const std::string& name : target.nodes) {
    const nodes::Node* node = nodes::findNode(graph, name);
    if (!node) continue;
    const ParamValue value = nodes::paramValue(*node, *target.spec, editor.frame);
    if (first)
      state.value = value;
    else
      compare(state, value);
    first = false;
    state.animated |= node->animated.contains(id);
    state.keyHere |= hasKeyAt(*node, id, editor.frame);
    state.faulty |= node->unknown.contains("params/" + id);
    state.modified |= node->params.contains(id) || state.animated || state.faulty;
    state.exposed |= nodes::isSocket(*node, *target.spec);
  }
  findSource(graph, target, state);
  return state;
}

void changeParam(Editor& editor, const ParamTarget& target, const ParamChange& change, bool dragging) {
  if (dragging) remember(editor, target);
  Result<Graph> graph = onEach(editor, target.nodes, [&](const Graph& g, const std::string& name) {
    const ParamValue value = change(nodes::paramValue(*nodes::findNode(g, name), *target.spec, editor.frame));
    return nodes::setParamAt(g, name, target.spec->id, value, editor.frame);
  });
  tryEdit(editor, std::move(graph), "Set " + target.title(), dragging ? mergeKey(target) : "");
  if (dragging) editor.preview.touch();
}

void setParamValue(Editor& editor, const ParamTarget& target, const ParamValue& value, bool dragging) {
  changeParam(
      editor, target, [&](const ParamValue&) { return value; }, dragging);
}

void endParamEdit(Editor& editor, const ParamTarget& target, bool cancelled) {
  DragMemory& memory = editor.parameters.drag;
  if (cancelled && memory.key == target.key()) {
    Graph graph = editor.document.graph();
    for (const auto& [name, node] : memory.before)
      if (graph.nodes.contains(name)) graph.nodes[name] = node;
    // The document drops a step that ends where it began.
    tryEdit(editor, std::move(graph), "Set " + target.title(), mergeKey(target));
  }
  memory = {};
  editor.document.endMerge();
}

void resetParam(Editor& editor, const ParamTarget& target) {
  tryEdit(editor,
          onEach(editor, target.nodes,
                 [&](const Graph& g, const std::string& name) {
                   return nodes::setParam(g, name, target.spec->id, target.spec->fallback);
                 }),
          "Reset " + target.title());
}

void resetNodes(Editor& editor, const std::vector<std::string>& names) {
  if (names.empty()) return;
  tryEdit(editor,
          onEach(editor, names,
                 [&](const Graph& g, const std::string& name) {
                   return Result<Graph>(nodes::resetParams(g, name));
                 }),
          names.size() == 1 ? "Reset " + names.front() : fmt::format("Reset {} nodes", names.size()));
}

void toggleKey(Editor& editor, const ParamTarget& target) {
  const bool remove = paramState(editor, target).keyHere;
  Result<Graph> graph =
      onEach(editor, target.nodes, [&](const Graph& g, const std::string& name) -> Result<Graph> {
        const nodes::Node& node = *nodes::findNode(g, name);
        if (remove)
          return hasKeyAt(node, target.spec->id, editor.frame)
                     ? Result<Graph>(nodes::removeKey(g, name, target.spec->id, editor.frame))
                     : Result<Graph>(g);
        const ParamValue value = nodes::paramValue(node, *target.spec, editor.frame);
        return nodes::setKey(g, name, target.spec->id, editor.frame, value);
      });
  if (tryEdit(
          editor, std::move(graph),
          fmt::format("{} key of {} at frame {}", remove ? "Remove" : "Set", target.title(), editor.frame)))
    editor.messages.note(fmt::format("{} of {} at frame {}", remove ? "Key removed" : "Key set",
                                     target.title(), editor.frame));
}

void clearAnimation(Editor& editor, const ParamTarget& target) {
  tryEdit(editor,
          onEach(editor, target.nodes,
                 [&](const Graph& g, const std::string& name) {
                   return Result<Graph>(nodes::clearAnimation(g, name, target.spec->id, editor.frame));
                 }),
          "Remove animation of " + target.title());
}

bool canExpose(const ParamSpec& spec) { return !spec.socket && !nodes::constantOnly(spec.type); }

void toggleExposed(Editor& editor, const ParamTarget& target) {
  const bool on = !paramState(editor, target).exposed;
  tryEdit(editor,
          onEach(editor, target.nodes,
                 [&](const Graph& g, const std::string& name) {
                   return nodes::exposeParam(g, name, target.spec->id, on);
                 }),
          (on ? "Expose " : "Do not expose ") + target.title());
}

void copyParam(const Editor& editor, const ParamTarget& target) {
  ImGui::SetClipboardText(nodes::formatParam(*target.spec, paramState(editor, target).value).c_str());
}

void pasteParam(Editor& editor, const ParamTarget& target) {
  const char* text = ImGui::GetClipboardText();
  const std::string shown = std::string(text ? text : "").substr(0, 40);
  Result<ParamValue> value = nodes::parseParam(*target.spec, text ? text : "");
  if (value) value = nodes::checkedParam(*target.spec, *value);
  if (!value)
    return editor.messages.hint(
        fmt::format("\"{}\" does not fit {}: {}", shown, target.spec->label, value.error().message));
  setParamValue(editor, target, *value);
}

void pasteValues(Editor& editor, const std::vector<std::string>& names) {
  const char* text = ImGui::GetClipboardText();
  std::set<std::string> pasted;
  const Result<Graph> from = nodes::pasteText(Graph{}, text ? text : "", {0, 0}, &pasted);
  if (!from || pasted.empty())
    return editor.messages.hint("Copy a node first: its values can then be pasted onto another one.");
  const std::string& sourceName = *pasted.begin();
  const nodes::Node& source = *nodes::findNode(*from, sourceName);
  const nodes::NodeType* sourceType = nodes::findNodeType(source.type);
  if (!sourceType) return editor.messages.hint("The node on the clipboard is of an unknown type.");
  int count = 0;
  Result<Graph> graph = onEach(editor, names, [&](const Graph& g, const std::string& name) -> Result<Graph> {
    Graph next = g;
    const nodes::NodeType* type = nodes::findNodeType(nodes::findNode(g, name)->type);
    if (!type) return next;
    for (const ParamSpec& spec : type->params) {
      const ParamSpec* other = sourceType->param(spec.id);
      if (!other) continue;
      Result<ParamValue> value = nodes::checkedParam(spec, nodes::paramValue(source, *other, editor.frame));
      if (!value) continue;  // a value that does not fit stays as it is
      PILEUS_TRY(next, nodes::setParam(next, name, spec.id, *value));
      ++count;
    }
    return next;
  });
  if (graph && count == 0)
    return editor.messages.hint(
        fmt::format("{} and this node have no parameters in common.", sourceType->label));
  if (tryEdit(editor, std::move(graph), "Paste values of " + sourceName))
    editor.messages.note(fmt::format("Values of {} pasted", sourceName));
}

}  // namespace pileus::editor
