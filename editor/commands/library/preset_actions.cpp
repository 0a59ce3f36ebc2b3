// Commands of presets.
#include "editor/commands/library/presets.h"
#include "editor/commands/table.h"
#include "editor/document/preset_shelf.h"
#include "editor/document/session.h"
#include "editor/start/start_view.h"
#include "nodes/file/preset_folder.h"

namespace pileus::editor {
namespace {

bool oneNode(const Editor& e) { return e.session.document.selection().size() == 1; }
bool someNodes(const Editor& e) { return !e.session.document.selection().empty(); }

using P = Panel;

const Action kActions[] = {
    {.id = "presets.gallery",
     .label = "Gallery\xe2\x80\xa6",
     .menu = "File/Presets",
     .panel = P::Global,
     .run = [](Editor& e) { openStart(e.start); }},
    {.id = "presets.keep_document",
     .label = "Save Scene as Preset\xe2\x80\xa6",
     .menu = "File/Presets",
     .panel = P::Global,
     .run = [](Editor& e) { askKeepPreset(e, nodes::PresetKind::Document); },
     .separator = true},
    {.id = "presets.keep_nodes",
     .label = "Save Nodes as Preset\xe2\x80\xa6",
     .menu = "File/Presets",
     .panel = P::Global,
     .run = [](Editor& e) { askKeepPreset(e, nodes::PresetKind::Nodes); },
     .enabled = someNodes},
    {.id = "presets.keep_parameters",
     .label = "Save Parameters as Preset\xe2\x80\xa6",
     .menu = "File/Presets",
     .panel = P::Global,
     .run = [](Editor& e) { askKeepPreset(e, nodes::PresetKind::Parameters); },
     .enabled = oneNode},
    {.id = "presets.undo",
     .label = "Undo Change of Presets",
     .menu = "File/Presets",
     .panel = P::Global,
     .run = [](Editor& e) { e.presets.undo(); },
     .enabled = [](const Editor& e) { return e.presets.canUndo(); },
     .separator = true},
    {.id = "presets.add_folder",
     .label = "Add Folder of Presets\xe2\x80\xa6",
     .menu = "File/Presets",
     .panel = P::Global,
     .run = askPresetFolder},
    {.id = "presets.reveal",
     .label = "Show Own Presets in Folder",
     .menu = "File/Presets",
     .panel = P::Global,
     .run = [](Editor& e) { showInFolder(e.ui, nodes::ownPresetFolder() / "."); }},
};

}  // namespace

std::span<const Action> presetActions() { return kActions; }

}  // namespace pileus::editor
