#include "editor/time/timeline_edits.h"

#include <fmt/core.h>

#include "editor/document/session.h"
#include "editor/exchange/messages.h"
#include "editor/time/clock.h"
#include "nodes/graph/graph_animation.h"

namespace pileus::editor {
namespace {

constexpr char kMove[] = "timeline move";

}  // namespace

std::string keysText(std::size_t count) { return count == 1 ? "key" : fmt::format("{} keys", count); }

void deleteSelectedKeys(Messages& messages, Session& session, Clock& clock) {
  deleteSelectedKeys(messages, session, clock, "Delete " + keysText(clock.keys.selected.size()));
}

void deleteSelectedKeys(Messages& messages, Session& session, Clock& clock, const std::string& label) {
  KeySelection& selected = clock.keys.selected;
  nodes::Graph graph = session.document.graph();
  for (const KeyRef& k : selected) graph = nodes::removeKey(graph, k.node, k.param, k.frame);
  if (tryEdit(session, messages, std::move(graph), label)) selected.clear();
}

void interpolateSelectedKeys(Messages& messages, Session& session, const Clock& clock,
                             nodes::Interpolation interpolation) {
  nodes::Graph graph = session.document.graph();
  for (const KeyRef& k : clock.keys.selected)
    graph = nodes::setInterpolation(graph, k.node, k.param, k.frame, interpolation);
  tryEdit(session, messages, std::move(graph), "Interpolate " + keysText(clock.keys.selected.size()));
}

void keyShownRows(Messages& messages, Session& session, Clock& clock) {
  nodes::Graph graph = session.document.graph();
  const std::vector<AnimatedRow>& rows = shownRows(clock.keys.rows, session.document);
  if (rows.empty()) return messages.hint("Nothing is animated yet: press I over a parameter.");
  for (const AnimatedRow& row : rows) {
    nodes::Animation animation{row.keys};
    Result<nodes::Graph> keyed =
        nodes::setParamAt(graph, row.node, row.param, nodes::valueAt(animation, clock.frame), clock.frame);
    if (!keyed) return messages.hint(keyed.error().message);
    graph = std::move(*keyed);
  }
  tryEdit(session, messages, std::move(graph),
          fmt::format("Set {} at frame {}", keysText(rows.size()), clock.frame));
}

void selectAllKeys(const Session& session, Clock& clock) {
  clock.keys.selected.clear();
  for (const AnimatedRow& row : shownRows(clock.keys.rows, session.document))
    for (const nodes::AnimationKey& k : row.keys) clock.keys.selected.insert({row.node, row.param, k.frame});
}

void beginKeyMove(Session& session, Clock& clock) {
  KeyEditing& t = clock.keys;
  t.before = session.document.graph();
  t.beforeSelected = t.selected;
  session.document.endMerge();
}

bool moveSelectedKeys(Messages& messages, Session& session, Clock& clock, double frames) {
  KeyEditing& t = clock.keys;
  if (t.beforeSelected.empty()) return false;
  if (t.selected.begin()->frame == t.beforeSelected.begin()->frame + frames) return false;  // there already
  // From where all began, so that keys that were passed on the way stay what they were.
  if (!tryEdit(session, messages, nodes::moveKeys(t.before, movesBy(t.beforeSelected, frames)),
               "Move " + keysText(t.beforeSelected.size()), kMove))
    return false;
  t.selected.clear();
  for (KeyRef k : t.beforeSelected) {
    k.frame += frames;
    t.selected.insert(std::move(k));
  }
  return true;
}

void endKeyMove(Session& session, Clock& clock) {
  session.document.endMerge();
  clock.keys.before = {};
}

}  // namespace pileus::editor
