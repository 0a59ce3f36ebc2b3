// Commands on the selected nodes, link or frame.
#include <fmt/core.h>

#include <algorithm>

#include "editor/app/editor.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/frames.h"
#include "nodes/graph/graph_edits.h"

namespace pileus::editor {
namespace {

std::string named(const char* verb, const std::set<std::string>& names) {
  return verb + (names.size() == 1 ? " " + *names.begin() : std::string(" nodes"));
}

template <class Test>
bool all(const Editor& editor, Test test) {
  const std::set<std::string>& names = editor.document.selection();
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const nodes::Node* node = nodes::findNode(editor.document.graph(), name);
    return node && test(*node);
  });
}

void select(Editor& editor, std::set<std::string> names) {
  editor.canvas.selectedLink.reset();
  editor.canvas.selectedFrame.reset();
  editor.document.select(std::move(names));
}

}  // namespace

void deleteSelection(Editor& editor) {
  Canvas& canvas = editor.canvas;
  if (canvas.selectedLink) {
    tryEdit(editor, nodes::disconnect(editor.document.graph(), *canvas.selectedLink), "Remove link");
    canvas.selectedLink.reset();
  } else if (canvas.selectedFrame) {
    removeFrame(editor, *canvas.selectedFrame);
  } else if (const std::set<std::string> names = editor.document.selection(); !names.empty()) {
    tryEdit(editor, nodes::removeNodes(editor.document.graph(), names), named("Delete", names));
  }
}

void deleteReconnecting(Editor& editor) {
  const std::set<std::string> names = editor.document.selection();
  if (names.empty()) return deleteSelection(editor);
  tryEdit(editor, nodes::removeNodes(editor.document.graph(), names, true),
          named("Delete and reconnect", names));
}

void extractSelection(Editor& editor) {
  const std::set<std::string> names = editor.document.selection();
  if (names.empty()) return;
  tryEdit(editor, nodes::extractNodes(editor.document.graph(), names), named("Extract", names));
}

void bypassSelection(Editor& editor) {
  const std::set<std::string> names = editor.document.selection();
  if (names.empty()) return;
  const bool on = all(editor, [](const nodes::Node& n) { return n.bypass; });
  tryEdit(editor, nodes::setBypass(editor.document.graph(), names, !on),
          named(on ? "Use again" : "Bypass", names));
}

void disableSelection(Editor& editor) {
  const std::set<std::string> names = editor.document.selection();
  if (names.empty()) return;
  const bool on = all(editor, [](const nodes::Node& n) { return n.disabled; });
  tryEdit(editor, nodes::disableNodes(editor.document.graph(), names, !on),
          named(on ? "Enable" : "Disable", names));
}

void muteSelectedLink(Editor& editor) {
  if (!editor.canvas.selectedLink) return;
  nodes::Link link = *editor.canvas.selectedLink;
  if (!tryEdit(editor, nodes::setMuted(editor.document.graph(), link, !link.muted),
               link.muted ? "Unmute link" : "Mute link"))
    return;
  link.muted = !link.muted;
  editor.canvas.selectedLink = link;
}

void colorSelection(Editor& editor, const std::string& color) {
  const std::set<std::string> names = editor.document.selection();
  tryEdit(editor, nodes::setColor(editor.document.graph(), names, color), named("Colour", names));
}

void selectAllNodes(Editor& editor) {
  std::set<std::string> names;
  for (const auto& [name, node] : editor.document.graph().nodes) names.insert(name);
  select(editor, std::move(names));
}

void selectUpstream(Editor& editor) {
  select(editor, nodes::upstreamOf(editor.document.graph(), editor.document.selection()));
}

void selectDownstream(Editor& editor) {
  select(editor, nodes::downstreamOf(editor.document.graph(), editor.document.selection()));
}

}  // namespace pileus::editor
