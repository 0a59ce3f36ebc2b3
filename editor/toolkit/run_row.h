#pragma once
// The row that starts and stops a measurement: a button, and while it runs its progress and what it is doing.
#include <string>

namespace pileus::editor {

struct Ui;

enum class RunClick { None, Start, Stop };

/// At the cursor; traced as "PREFIX/run" and "PREFIX/cancel". `ready`: may be started; `waits`: for the
/// picture.
RunClick runRow(Ui& ui, const std::string& prefix, const char* label, bool running, bool ready, bool waits,
                double fraction, const std::string& doing, float width);

}  // namespace pileus::editor
