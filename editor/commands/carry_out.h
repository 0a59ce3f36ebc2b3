#pragma once
// Does what the rooms have asked for (exchange/requests.h).
namespace pileus::editor {

struct Editor;

/// Between two frames; those asked for meanwhile too. Returns whether there were any.
bool carryOutRequests(Editor& editor);

}  // namespace pileus::editor
