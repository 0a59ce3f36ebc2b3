// Commands on the selected nodes, link or frame.
#include <fmt/core.h>

#include <algorithm>

#include "editor/document/session.h"
#include "editor/graph_view/canvas.h"
#include "editor/graph_view/canvas_commands.h"
#include "editor/graph_view/frames.h"
#include "editor/toolkit/ui.h"
#include "nodes/graph/graph_edits.h"

namespace pileus::editor {
namespace {

std::string named(const char* verb, const std::set<std::string>& names) {
  return verb + (names.size() == 1 ? " " + *names.begin() : std::string(" nodes"));
}

template <class Test>
bool all(const Session& session, Test test) {
  const std::set<std::string>& names = session.document.selection();
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    const nodes::Node* node = nodes::findNode(session.document.graph(), name);
    return node && test(*node);
  });
}

void select(Session& session, Canvas& canvas, std::set<std::string> names) {
  session.selectedLink.reset();
  canvas.selectedFrame.reset();
  session.document.select(std::move(names));
}

}  // namespace

void deleteSelection(Ui& ui, Session& session, Canvas& canvas) {
  if (session.selectedLink) {
    tryEdit(session, ui.messages, nodes::disconnect(session.document.graph(), *session.selectedLink),
            "Remove link");
    session.selectedLink.reset();
  } else if (canvas.selectedFrame) {
    removeFrame(ui, session, canvas, *canvas.selectedFrame);
  } else if (const std::set<std::string> names = session.document.selection(); !names.empty()) {
    tryEdit(session, ui.messages, nodes::removeNodes(session.document.graph(), names),
            named("Delete", names));
  }
}

void deleteReconnecting(Ui& ui, Session& session, Canvas& canvas) {
  const std::set<std::string> names = session.document.selection();
  if (names.empty()) return deleteSelection(ui, session, canvas);
  tryEdit(session, ui.messages, nodes::removeNodes(session.document.graph(), names, true),
          named("Delete and reconnect", names));
}

void extractSelection(Ui& ui, Session& session) {
  const std::set<std::string> names = session.document.selection();
  if (names.empty()) return;
  tryEdit(session, ui.messages, nodes::extractNodes(session.document.graph(), names),
          named("Extract", names));
}

void bypassSelection(Ui& ui, Session& session) {
  const std::set<std::string> names = session.document.selection();
  if (names.empty()) return;
  const bool on = all(session, [](const nodes::Node& n) { return n.bypass; });
  tryEdit(session, ui.messages, nodes::setBypass(session.document.graph(), names, !on),
          named(on ? "Use again" : "Bypass", names));
}

void disableSelection(Ui& ui, Session& session) {
  const std::set<std::string> names = session.document.selection();
  if (names.empty()) return;
  const bool on = all(session, [](const nodes::Node& n) { return n.disabled; });
  tryEdit(session, ui.messages, nodes::disableNodes(session.document.graph(), names, !on),
          named(on ? "Enable" : "Disable", names));
}

void muteSelectedLink(Ui& ui, Session& session) {
  if (!session.selectedLink) return;
  nodes::Link link = *session.selectedLink;
  if (!tryEdit(session, ui.messages, nodes::setMuted(session.document.graph(), link, !link.muted),
               link.muted ? "Unmute link" : "Mute link"))
    return;
  link.muted = !link.muted;
  session.selectedLink = link;
}

void colorSelection(Ui& ui, Session& session, const std::string& color) {
  const std::set<std::string> names = session.document.selection();
  tryEdit(session, ui.messages, nodes::setColor(session.document.graph(), names, color),
          named("Colour", names));
}

void selectAllNodes(Session& session, Canvas& canvas) {
  std::set<std::string> names;
  for (const auto& [name, node] : session.document.graph().nodes) names.insert(name);
  select(session, canvas, std::move(names));
}

void selectUpstream(Session& session, Canvas& canvas) {
  select(session, canvas, nodes::upstreamOf(session.document.graph(), session.document.selection()));
}

void selectDownstream(Session& session, Canvas& canvas) {
  select(session, canvas, nodes::downstreamOf(session.document.graph(), session.document.selection()));
}

}  // namespace pileus::editor
