#pragma once
// Light from everywhere has no place to take hold of: a drag sideways over the picture turns it, as if one
// held what is seen behind it.
#include <optional>
#include <string>

#include "nodes/graph/graph.h"

namespace pileus::editor {

struct Clock;
struct Session;
struct Viewport;
struct ViewportRoom;

/// A turn that goes on.
struct TurnDrag {
  std::string node, param;  ///< by its path
  double start = 0;         ///< degrees
  double turned = 0;        ///< since then, before rounding
  std::string readout;
  nodes::Graph before;  ///< what Esc brings back
};

/// What a drag would turn: the only selected node, or the only one of its kind in a selected group, if it is
/// light from everywhere and nothing is linked to its angle; `before` is empty. Nothing otherwise.
std::optional<TurnDrag> turnable(const Session& session, const Clock& clock, const std::string& inside);

/// Where a drag would turn light: the pointer says so, and once the status line.
void hintAtTurn(const ViewportRoom& room);
/// Takes hold; false: there is nothing to turn.
bool beginTurn(const ViewportRoom& room);
/// `degrees`: what has been added to the angle since; `snap`: to multiples of 15.
void continueTurn(const ViewportRoom& room, double degrees, bool snap);
void drawTurn(const ViewportRoom& room);
void endTurn(Session& session, Viewport& viewport);
/// As it was before it began; the step vanishes with it.
void cancelTurn(Session& session, Viewport& viewport);

}  // namespace pileus::editor
