#pragma once
// The parts that the start view shows and changes.
namespace pileus::editor {

class GraphPictures;
class PresetShelf;
struct Settings;
struct StartView;
struct Ui;

struct StartRoom {
  Ui& ui;
  Settings& settings;
  GraphPictures& pictures;
  PresetShelf& presets;
  StartView& start;
};

}  // namespace pileus::editor
