// Commands of documents.
#include "editor/commands/drop_commands.h"
#include "editor/commands/files.h"
#include "editor/commands/relink.h"
#include "editor/commands/table.h"
#include "editor/picture/shown_camera.h"

namespace pileus::editor {
namespace {

bool hasView(const Editor& e) { return !shownView(e.session, e.shown).empty(); }

using P = Panel;

const Action kActions[] = {
    {.id = "file.new",
     .label = "New",
     .menu = "File",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_N)},
     .run = newDocument,
     .whileTyping = true},
    {.id = "file.open",
     .label = "Open\xe2\x80\xa6",
     .menu = "File",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_O)},
     .run = askOpen,
     .whileTyping = true},
    {.id = "file.import_vdb",
     .label = "Import VDB\xe2\x80\xa6",
     .menu = "File",
     .panel = P::Global,
     .run = askImportVdb},
    {.id = "file.missing",
     .label = "Find Missing Files\xe2\x80\xa6",
     .menu = "File",
     .panel = P::Global,
     .run = showMissing},
    {.id = "file.save",
     .label = "Save",
     .menu = "File",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_S)},
     .run = [](Editor& e) { save(e); },
     .separator = true,
     .whileTyping = true},
    {.id = "file.save_as",
     .label = "Save As\xe2\x80\xa6",
     .menu = "File",
     .panel = P::Global,
     .keys = {ctrlShift(GLFW_KEY_S)},
     .run = [](Editor& e) { saveAs(e); },
     .whileTyping = true},
    {.id = "file.save_version",
     .label = "Save Next Version",
     .menu = "File",
     .panel = P::Global,
     .keys = {{{GLFW_KEY_S, true, false, true}}},
     .run = saveNextVersion,
     .whileTyping = true},
    {.id = "file.export",
     .label = "Export EXR\xe2\x80\xa6",
     .menu = "File",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_E)},
     .run = askExport,
     .enabled = hasView,
     .separator = true},
    {.id = "file.quit",
     .label = "Quit",
     .menu = "File",
     .panel = P::Global,
     .keys = {ctrl(GLFW_KEY_Q)},
     .run = quit,
     .separator = true,
     .whileTyping = true},
};

}  // namespace

std::span<const Action> fileActions() { return kActions; }

}  // namespace pileus::editor
