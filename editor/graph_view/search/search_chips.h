#pragma once
// What surrounds the rows of the node search: chips that keep one category, and the keys that work in it.
#include <string>
#include <vector>

namespace pileus::editor {

struct Canvas;
struct Theme;
struct Ui;

/// Categories of what can be added here, in menu order.
std::vector<std::string> searchCategories(const Canvas& canvas);
/// A line of chips; Alt+Left and Alt+Right walk through them too.
void drawCategoryChips(Ui& ui, Canvas& canvas);
void drawSearchKeys(const Theme& theme, float width);

}  // namespace pileus::editor
