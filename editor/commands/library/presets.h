#pragma once
// Presets of one's own: keeping the document, some nodes or a node's parameters as one, putting them to use,
// and changing what is kept. Files are read and written by jobs of the shelf.
#include <filesystem>
#include <string>
#include <vector>

#include "editor/document/graph_pictures.h"
#include "editor/exchange/requests.h"
#include "nodes/file/preset.h"

namespace pileus::editor {

struct Editor;

/// What the dialog asks for (dialogs/preset_dialog.h); `Modals::preset` until it is written or given up.
struct PresetDialog {
  nodes::Preset preset;                        ///< what is kept
  std::filesystem::path from;                  ///< where its relative files start
  TexturePixels picture;                       ///< of the viewport
  std::filesystem::path describing;            ///< not "": only the words of this preset are changed
  std::vector<std::filesystem::path> folders;  ///< that may be written to, the user's own first
  int folder = 0;
  std::string name, about, tags;  ///< as typed
  std::string error;              ///< why it was not written
  bool looking = false;           ///< somebody looks at a list of presets
};

/// The document, the selected nodes, or the parameters of the selected node: opens the dialog.
void askKeepPreset(Editor& editor, nodes::PresetKind kind);
/// The preset that a name would replace in the chosen folder; "" = none.
std::filesystem::path replacedBy(const Editor& editor, const PresetDialog& dialog);
/// The dialog's answer.
void keepPreset(Editor& editor);

void usePreset(Editor& editor, const UsePreset& request);
void changePreset(Editor& editor, const ChangePreset& request);
void askPresetFolder(Editor& editor);

/// Once a frame: what jobs have done; reads the folders where somebody begins to look at them.
void pollPresets(Editor& editor);

}  // namespace pileus::editor
