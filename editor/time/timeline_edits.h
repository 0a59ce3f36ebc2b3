#pragma once
// Edits of the keys on the timeline, each one undo step.
#include <string>

#include "nodes/graph/animation.h"

namespace pileus::editor {

class Messages;
struct Clock;
struct Session;

/// "key" or "3 keys".
std::string keysText(std::size_t count);

void deleteSelectedKeys(Messages& messages, Session& session, Clock& clock);
void deleteSelectedKeys(Messages& messages, Session& session, Clock& clock,
                        const std::string& label);  ///< of the undo step
void interpolateSelectedKeys(Messages& messages, Session& session, const Clock& clock,
                             nodes::Interpolation interpolation);
/// A key on every row shown, at the current frame, with the value it has there.
void keyShownRows(Messages& messages, Session& session, Clock& clock);
void selectAllKeys(const Session& session, Clock& clock);

/// A drag of the selected keys: begin, then where it is now, then the end.
void beginKeyMove(Session& session, Clock& clock);
bool moveSelectedKeys(Messages& messages, Session& session, Clock& clock, double frames);
void endKeyMove(Session& session, Clock& clock);

}  // namespace pileus::editor
