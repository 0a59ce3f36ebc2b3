#pragma once
// Viewing any node: the viewport shows its picture without a change of the document. Slots 1 to 9 remember
// nodes to switch between.
#include <array>
#include <string>

#include "nodes/evaluate/evaluator.h"

namespace pileus::editor {

class Messages;
struct Session;
struct Shown;

// `root` is the whole document; a node in a group is named by its path, "Group/Node", as the evaluator does.

/// The first Image output of a node; "" = it has none.
std::string imageOutput(const nodes::Graph& root, const std::string& node);
/// What `node` shows as the evaluator left it: its own first image, or for an output node the image linked to
/// it; null = nothing yet.
const nodes::SocketValue* shownImage(const nodes::Evaluator& evaluator, const nodes::Graph& root,
                                     const std::string& node);
/// Can the viewport show this node: an output node, or one with an Image output?
bool viewable(const nodes::Graph& root, const std::string& node);
/// The node itself or the nearest one downstream of it, in its group, that the viewport can show; "" = none.
std::string nearestPicture(const nodes::Graph& root, const std::string& node);

/// Paths of nodes; "" = free. A slot whose node is gone counts as free.
using ViewSlots = std::array<std::string, 9>;
/// 1 to 9; 0 = the node is in no slot.
int slotOf(const ViewSlots& slots, const std::string& node);

/// Shows a node of the current scope, or the nearest picture that it takes part in; says what it did where
/// that is not plain.
void viewNode(Messages& messages, const Session& session, Shown& shown, const std::string& node);
/// Of the selection.
void viewSelected(Messages& messages, const Session& session, Shown& shown);
/// `number` from 1: shows what the slot holds; a free one takes the selected node first.
void viewSlot(Messages& messages, const Session& session, Shown& shown, int number);
void clearViewSlots(Shown& shown);
/// A node of the current scope has another name now.
void viewsFollow(const Session& session, Shown& shown, const std::string& from, const std::string& to);

}  // namespace pileus::editor
