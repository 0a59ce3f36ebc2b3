#pragma once
// Keys of the timeline through the system's clipboard, as JSON text.
namespace pileus::editor {

class Messages;
struct Clock;
struct Session;

void copySelectedKeys(Messages& messages, const Session& session, const Clock& clock);
void cutSelectedKeys(Messages& messages, Session& session, Clock& clock);
/// The earliest key goes to the current frame; the pasted keys are selected. One undo step.
void pasteKeys(Messages& messages, Session& session, Clock& clock);

}  // namespace pileus::editor
