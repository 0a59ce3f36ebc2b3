#pragma once
// The mark of the picked point over the picture.
namespace pileus::editor {

struct Settings;
struct Shown;
struct Ui;

void drawPickedRay(Ui& ui, const Shown& shown, const Settings& settings);

}  // namespace pileus::editor
