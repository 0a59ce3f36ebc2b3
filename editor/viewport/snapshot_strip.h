#pragma once
// The strip of stills below the picture, and the wipe between them.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Clock;
struct Session;
struct Shown;
struct Theme;
struct Ui;
struct ViewportRoom;

/// Height the strip wants; 0 while there is none.
float snapshotStripHeight(const Theme& theme, const Shown& shown);
void drawSnapshotStrip(Ui& ui, Session& session, const Clock& clock, Shown& shown, vec2 lo, vec2 hi);
/// In place of the picture while wiping.
void drawSnapshotWipe(const ViewportRoom& room, vec2 lo, vec2 hi, bool hovered);

}  // namespace pileus::editor
