#include "editor/graph_view/canvas_commands.h"

#include <algorithm>
#include <cmath>

#include "editor/actions.h"
#include "editor/editor.h"
#include "editor/graph_view/hit_test.h"
#include "nodes/serialize.h"

namespace pileus::editor {
namespace {

constexpr char kMenu[] = "##canvas menu";

void zoomBy(Editor& editor, const CanvasView& view, const command::Zoom& zoom) {
  Canvas& canvas = editor.canvas;
  canvas.zoomRest += zoom.steps;
  const auto steps = static_cast<int>(std::trunc(canvas.zoomRest));
  canvas.zoomRest -= static_cast<float>(steps);
  const int level = std::clamp(canvas.level + steps, 0, static_cast<int>(editor.theme.zoomLevels.size()) - 1);
  if (level == canvas.level) return;
  // The point under the pointer stays where it is.
  const dvec2 fixed = dvec2(view.canvas(zoom.at));
  canvas.level = level;
  const double after = static_cast<double>(editor.theme.zoomLevels[static_cast<std::size_t>(level)].zoom);
  canvas.center = fixed - dvec2(zoom.at - 0.5f * (view.min + view.max)) / after;
}

void applySelection(Editor& editor, const std::set<std::string>& names, SelectOp op) {
  std::set<std::string> selection = editor.document.selection();
  if (op == SelectOp::Replace)
    selection = names;
  else if (op == SelectOp::Add)
    selection.insert(names.begin(), names.end());
  else
    for (const std::string& name : names) selection.erase(name);
  editor.canvas.selectedLink.reset();
  editor.document.select(std::move(selection));
}

nodes::Link linkBetween(const LinkDrag& drag, const std::string& node, const std::string& socket) {
  return drag.fromOutput ? nodes::Link{drag.node, drag.socket, node, socket}
                         : nodes::Link{node, socket, drag.node, drag.socket};
}

nodes::Graph graphForDrag(const Editor& editor, const LinkDrag& drag) {
  return drag.replaces ? nodes::disconnect(editor.document.graph(), *drag.replaces) : editor.document.graph();
}

void startLink(Editor& editor, const Layout& layout, const LinkDrag& drag) {
  Canvas& canvas = editor.canvas;
  canvas.refusals.clear();
  canvas.selectedLink.reset();
  const nodes::Graph graph = graphForDrag(editor, drag);
  for (const NodePlace& node : layout.nodes)
    for (const SocketPlace& s : node.sockets) {
      const std::string key = socketKey(node.name, s.id, s.input);
      if (node.name == drag.node && s.id == drag.socket && s.input != drag.fromOutput)
        continue;  // the fixed end itself
      if (s.input != drag.fromOutput)
        canvas.refusals[key] = drag.fromOutput ? "Both ends are outputs: a link ends at an input."
                                               : "Both ends are inputs: a link begins at an output.";
      else if (auto reason = nodes::linkRefusal(graph, linkBetween(drag, node.name, s.id)))
        canvas.refusals[key] = *reason;
    }
}

void dropLink(Editor& editor, const CanvasView& view, const command::LinkDrop& drop) {
  const LinkDrag& drag = drop.drag;
  if (drop.on.kind == Hit::Kind::Canvas) {
    // Dropping a picked-off link on nothing removes it; a new one asks which node shall follow.
    if (drag.replaces)
      tryEdit(editor, nodes::disconnect(editor.document.graph(), *drag.replaces), "Remove link");
    else
      openSearch(editor, drop.at, view.canvas(drop.at), drag);
    return;
  }
  if (drop.on.kind != Hit::Kind::Input && drop.on.kind != Hit::Kind::Output) return;
  if (drop.on.node == drag.node && drop.on.socket == drag.socket) return;
  const auto refusal =
      editor.canvas.refusals.find(socketKey(drop.on.node, drop.on.socket, drop.on.kind == Hit::Kind::Input));
  if (refusal != editor.canvas.refusals.end()) return editor.messages.hint(refusal->second);
  tryEdit(editor, nodes::connect(graphForDrag(editor, drag), linkBetween(drag, drop.on.node, drop.on.socket)),
          "Link");
}

struct Carry {
  Editor& editor;
  const CanvasView& view;
  const Layout& layout;

  void operator()(const command::Pan& c) {
    editor.canvas.center -= dvec2(c.by) / static_cast<double>(view.level.zoom);
  }
  void operator()(const command::Zoom& c) { zoomBy(editor, view, c); }
  void operator()(const command::SelectNode& c) { applySelection(editor, {c.node}, c.op); }
  void operator()(const command::SelectLink& c) {
    editor.document.select({});
    editor.canvas.selectedLink = c.link;
  }
  void operator()(const command::SelectNone&) { applySelection(editor, {}, SelectOp::Replace); }
  void operator()(const command::SelectBox& c) {
    applySelection(editor, nodesInside(layout, view.canvas(c.a), view.canvas(c.b)), c.op);
  }
  void operator()(const command::Move& c) {
    const std::set<std::string>& names = editor.document.selection();
    if (names.empty()) return;
    editor.document.edit(
        nodes::moveNodes(editor.document.graph(), names, dvec2(c.by) / static_cast<double>(view.level.zoom)),
        names.size() == 1 ? "Move " + *names.begin() : "Move nodes", "move nodes");
  }
  void operator()(const command::MoveDone&) { editor.document.endMerge(); }
  void operator()(const command::LinkStart& c) { startLink(editor, layout, c.drag); }
  void operator()(const command::LinkDrop& c) { dropLink(editor, view, c); }
  void operator()(const command::Menu& c) {
    if (c.hit.kind == Hit::Kind::Link)
      (*this)(command::SelectLink{c.hit.link});
    else if (!editor.document.selection().contains(c.hit.node))
      applySelection(editor, {c.hit.node}, SelectOp::Replace);
    editor.canvas.menuHit = c.hit;
    ImGui::OpenPopup(kMenu);
  }
  void operator()(const command::Search& c) { openSearch(editor, c.at, view.canvas(c.at)); }
  void operator()(const command::Open& c) {
    // A picture's output is viewed by opening it; other nodes are renamed in place of a further meaning.
    const nodes::Node* node = nodes::findNode(editor.document.graph(), c.node);
    const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
    if (type && type->isOutput)
      editor.viewport.activeView = c.node;
    else
      editor.parameters.focusName = true;
  }
};

}  // namespace

void carryOut(Editor& editor, const CanvasView& view, const Layout& layout, const Command& command) {
  std::visit(Carry{editor, view, layout}, command);
}

void drawCanvasMenu(Editor& editor) {
  if (!ImGui::BeginPopup(kMenu)) return;
  if (editor.canvas.menuHit.kind == Hit::Kind::Link) {
    actionMenuItem(editor, "graph.delete");
  } else {
    const nodes::Node* node = nodes::findNode(editor.document.graph(), editor.canvas.menuHit.node);
    const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
    ImGui::PushFont(editor.theme.strong);
    ImGui::TextUnformatted(editor.canvas.menuHit.node.c_str());
    ImGui::PopFont();
    if (type && type->label != editor.canvas.menuHit.node) ImGui::TextDisabled("%s", type->label.c_str());
    ImGui::Separator();
    if (type && type->isOutput && ImGui::MenuItem("Show in viewport"))
      editor.viewport.activeView = editor.canvas.menuHit.node;
    for (const char* id :
         {"graph.rename", "graph.bypass", "graph.duplicate", "edit.cut", "edit.copy", "graph.frame"})
      actionMenuItem(editor, id);
    ImGui::Separator();
    actionMenuItem(editor, "graph.delete");
  }
  ImGui::EndPopup();
}

void deleteSelection(Editor& editor) {
  if (editor.canvas.selectedLink) {
    tryEdit(editor, nodes::disconnect(editor.document.graph(), *editor.canvas.selectedLink), "Remove link");
    editor.canvas.selectedLink.reset();
    return;
  }
  const std::set<std::string> names = editor.document.selection();
  if (names.empty()) return;
  tryEdit(editor, nodes::removeNodes(editor.document.graph(), names),
          names.size() == 1 ? "Delete " + *names.begin() : "Delete nodes");
}

namespace {

void pasteAt(Editor& editor, std::string_view text, dvec2 at, const std::string& label) {
  std::set<std::string> pasted;
  if (tryEdit(editor, nodes::pasteText(editor.document.graph(), text, at, &pasted), label))
    editor.document.select(std::move(pasted));
}

}  // namespace

void duplicateSelection(Editor& editor) {
  const std::set<std::string>& names = editor.document.selection();
  vec2 lo, hi;
  if (names.empty() || !bounds(layoutGraph(editor.document.graph(), {}), names, lo, hi)) return;
  dvec2 a(1e300), b(-1e300);
  for (const std::string& name : names) {
    a = glm::min(a, editor.document.graph().nodes.at(name)->at);
    b = glm::max(b, editor.document.graph().nodes.at(name)->at);
  }
  pasteAt(editor, nodes::copyText(editor.document.graph(), names), 0.5 * (a + b) + dvec2(40, 40),
          "Duplicate");
}

void copySelection(Editor& editor) {
  if (!editor.document.selection().empty())
    ImGui::SetClipboardText(nodes::copyText(editor.document.graph(), editor.document.selection()).c_str());
}

void cutSelection(Editor& editor) {
  if (editor.document.selection().empty()) return;
  copySelection(editor);
  const std::set<std::string> names = editor.document.selection();
  tryEdit(editor, nodes::removeNodes(editor.document.graph(), names, true),
          names.size() == 1 ? "Cut " + *names.begin() : "Cut nodes");
}

void pasteNodes(Editor& editor) {
  const char* text = ImGui::GetClipboardText();
  if (!text || !*text) return editor.messages.hint("The clipboard holds no nodes.");
  pasteAt(editor, text, editor.canvas.pointerInside ? dvec2(editor.canvas.pointer) : editor.canvas.center,
          "Paste");
}

void bypassSelection(Editor& editor) {
  const std::set<std::string>& names = editor.document.selection();
  if (names.empty()) return;
  const nodes::Graph& graph = editor.document.graph();
  const bool all = std::all_of(names.begin(), names.end(), [&](const std::string& n) {
    const nodes::Node* node = nodes::findNode(graph, n);
    return node && node->bypass;
  });
  tryEdit(editor, nodes::setBypass(graph, names, !all), all ? "Use again" : "Bypass");
}

void selectAllNodes(Editor& editor) {
  std::set<std::string> names;
  for (const auto& [name, node] : editor.document.graph().nodes) names.insert(name);
  editor.document.select(std::move(names));
}

void searchNode(Editor& editor) {
  const Canvas& canvas = editor.canvas;
  if (canvas.pointerInside)
    openSearch(editor, vec(ImGui::GetIO().MousePos), canvas.pointer);
  else
    openSearch(editor, 0.5f * (canvas.min + canvas.max), vec2(canvas.center));
}

}  // namespace pileus::editor
