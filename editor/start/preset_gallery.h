#pragma once
// The right side of the start view: shipped presets and one's own as pictures, found by words and tags.
#include <optional>

#include "editor/document/graph_pictures.h"
#include "editor/exchange/requests.h"

struct ImVec2;

namespace pileus::editor {

struct StartRoom;
struct Theme;

/// What was chosen; it runs after the view is closed.
using Choice = std::optional<Request>;

void heading(const Theme& theme, const char* text);
/// A picture with rounded corners, cut to fill its place; a cloud where there is none.
void drawPicture(const Theme& theme, const GraphPictures::Shown& shown, ImVec2 lo, ImVec2 hi, bool grey);
void drawGallery(const StartRoom& room, Choice& choice);

}  // namespace pileus::editor
