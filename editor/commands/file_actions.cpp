// Commands of documents.
#include "editor/commands/table.h"
#include "editor/document/files.h"
#include "editor/picture/shown_camera.h"

namespace pileus::editor {
namespace {

bool hasView(const Editor& e) { return !shownView(e).empty(); }
void quit(Editor& e) {
  withSavedDocument(e, [](Editor& editor) { editor.quit = true; });
}

using P = Panel;

const Action kActions[] = {
    {"file.new", "New", "File", P::Global, {ctrl(GLFW_KEY_N)}, newDocument, nullptr, nullptr, false, true},
    {"file.open",
     "Open\xe2\x80\xa6",
     "File",
     P::Global,
     {ctrl(GLFW_KEY_O)},
     askOpen,
     nullptr,
     nullptr,
     false,
     true},
    {"file.import_vdb", "Import VDB\xe2\x80\xa6", "File", P::Global, {}, askImportVdb},
    {"file.save",
     "Save",
     "File",
     P::Global,
     {ctrl(GLFW_KEY_S)},
     [](Editor& e) { save(e); },
     nullptr,
     nullptr,
     true,
     true},
    {"file.save_as",
     "Save As\xe2\x80\xa6",
     "File",
     P::Global,
     {ctrlShift(GLFW_KEY_S)},
     [](Editor& e) { saveAs(e); },
     nullptr,
     nullptr,
     false,
     true},
    {"file.export",
     "Export EXR\xe2\x80\xa6",
     "File",
     P::Global,
     {ctrl(GLFW_KEY_E)},
     askExport,
     hasView,
     nullptr,
     true},
    {"file.quit", "Quit", "File", P::Global, {ctrl(GLFW_KEY_Q)}, quit, nullptr, nullptr, true, true},
};

}  // namespace

std::span<const Action> fileActions() { return kActions; }

}  // namespace pileus::editor
