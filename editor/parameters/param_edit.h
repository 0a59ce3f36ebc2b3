#pragma once
// What a row of the parameter panel edits, and the edits: one parameter of one node, or of several nodes of a
// type at once. Each edit is one undo step; steps of a drag merge until endParamEdit().
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "nodes/graph/graph.h"

namespace pileus::editor {

struct Clock;
struct ParameterRoom;
struct Parameters;
struct Session;
struct Ui;

struct ParamTarget {
  std::vector<std::string> nodes;  ///< of one type; the first one's value is shown
  const nodes::ParamSpec* spec = nullptr;

  std::string key() const;    ///< "Sun.elevation"
  std::string title() const;  ///< for labels of steps: that, or "elevation of 3 nodes"
};

/// What there is to see of it at the current frame.
struct ParamState {
  nodes::ParamValue value;
  std::array<bool, 3> differs{};  ///< between the nodes: by component, else the first
  bool modified = false;          ///< on some node
  bool animated = false, keyHere = false;
  bool faulty = false;  ///< the file holds something that cannot be read
  bool exposed = false;
  std::string sourceNode, sourceSocket;  ///< of the link that gives the value; "" = none

  bool mixed() const { return differs[0] || differs[1] || differs[2]; }
  bool linked() const { return !sourceNode.empty(); }
};

ParamState paramState(const Session& session, const Clock& clock, const ParamTarget& target);

using ParamChange = std::function<nodes::ParamValue(const nodes::ParamValue&)>;
/// Applies `change` to each node's own value.
void changeParam(const ParameterRoom& room, const ParamTarget& target, const ParamChange& change,
                 bool dragging);
void setParamValue(const ParameterRoom& room, const ParamTarget& target, const nodes::ParamValue& value,
                   bool dragging = false);
/// The end of a drag; a cancelled one leaves everything as it was, and no step.
void endParamEdit(Ui& ui, Session& session, Parameters& parameters, const ParamTarget& target,
                  bool cancelled = false);

void resetParam(Ui& ui, Session& session, const ParamTarget& target);
void resetNodes(Ui& ui, Session& session, const std::vector<std::string>& nodes);
void toggleKey(Ui& ui, Session& session, const Clock& clock, const ParamTarget& target);
void clearAnimation(Ui& ui, Session& session, const Clock& clock, const ParamTarget& target);
bool canExpose(const nodes::ParamSpec& spec);
void toggleExposed(Ui& ui, Session& session, const Clock& clock, const ParamTarget& target);

void copyParam(const Session& session, const Clock& clock, const ParamTarget& target);
void pasteParam(const ParameterRoom& room, const ParamTarget& target);
/// All values of the first node on the clipboard, where these nodes have parameters of that name.
void pasteValues(Ui& ui, Session& session, const Clock& clock, const std::vector<std::string>& nodes);

/// Of the drag that goes on.
struct DragMemory {
  std::string key;
  std::map<std::string, nodes::NodePtr> before;  ///< the nodes as they were
};

}  // namespace pileus::editor
