#pragma once
// The row that starts and stops a measurement: a button, and while it runs its progress and what it is doing.
#include <string>

#include "editor/app/editor.h"

namespace pileus::editor {

enum class RunClick { None, Start, Stop };

/// At the cursor; traced as "PREFIX/run" and "PREFIX/cancel". `ready`: may be started.
RunClick runRow(Editor& editor, const std::string& prefix, const char* label, bool running, bool ready,
                double fraction, const std::string& doing, float width);

}  // namespace pileus::editor
