#include "editor/files.h"

#include <fmt/core.h>

#include "editor/editor.h"
#include "editor/panels/viewport_camera.h"
#include "embedded_presets.h"
#include "nodes/serialize.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

void put(Editor& editor, nodes::Loaded loaded, const fs::path& path, const std::string& name) {
  editor.document = nodes::Document(std::move(loaded.graph), path);
  documentReplaced(editor);
  if (loaded.faults.empty()) return;
  for (const nodes::Fault& f : loaded.faults)
    log::write(f.error ? log::Level::Error : log::Level::Warning, name + ": " + nodes::faultText(f));
  editor.dialogs.faults = std::move(loaded.faults);
  editor.dialogs.faultsOf = name;
}

bool write(Editor& editor, const fs::path& path) {
  if (Result<void> saved = nodes::saveGraph(path, editor.document.graph()); !saved) {
    log::error("{}", saved.error().message);
    editor.dialogs.errorTitle = "The file was not saved";
    editor.dialogs.errorText = saved.error().message;
    return false;
  }
  bookmarksFollow(editor, editor.document.path().string(), path.string());
  editor.document.markSaved(path);
  remember(editor.settings.recentFiles, path.string());
  editor.messages.info("Saved " + path.string());
  return true;
}

}  // namespace

void withSavedDocument(Editor& editor, std::function<void(Editor&)> then) {
  if (editor.document.dirty())
    editor.dialogs.afterUnsaved = std::move(then);
  else
    then(editor);
}

void newDocument(Editor& editor) {
  withSavedDocument(editor, [](Editor& e) {
    e.document = nodes::Document();
    documentReplaced(e);
  });
}

void askOpen(Editor& editor) {
  withSavedDocument(editor, [](Editor& e) {
    BrowserRequest request;
    request.title = "Open graph";
    request.button = "Open";
    request.kinds = {"json"};
    request.start = e.document.path().parent_path();
    request.done = [&e](const fs::path& path) { openFile(e, path); };
    e.browser.open(e, std::move(request));
  });
}

bool openFile(Editor& editor, const fs::path& path) {
  std::error_code ec;
  const fs::path whole = fs::absolute(path, ec).lexically_normal();
  Result<nodes::Loaded> loaded = nodes::loadGraph(whole);
  if (!loaded) {
    log::error("{}", loaded.error().message);
    editor.dialogs.errorTitle = "The file was not opened";
    editor.dialogs.errorText = loaded.error().message;
    return false;
  }
  put(editor, std::move(*loaded), whole, whole.filename().string());
  remember(editor.settings.recentFiles, whole.string());
  return true;
}

bool openPreset(Editor& editor, const std::string& name) {
  for (const EmbeddedFile& file : embedded_presets()) {
    if (file.path != name) continue;
    Result<nodes::Loaded> loaded = nodes::parseGraph(file.bytes);
    if (!loaded) {
      editor.messages.error(fmt::format("The preset {} cannot be read: {}", name, loaded.error().message));
      return false;
    }
    put(editor, std::move(*loaded), {}, name);
    return true;
  }
  editor.messages.warn(fmt::format("There is no preset {}.", name));
  return false;
}

void save(Editor& editor, std::function<void(Editor&)> then) {
  if (editor.document.path().empty()) return saveAs(editor, std::move(then));
  if (write(editor, editor.document.path()) && then) then(editor);
}

void saveAs(Editor& editor, std::function<void(Editor&)> then) {
  BrowserRequest request;
  request.title = "Save graph as";
  request.button = "Save";
  request.kinds = {"json"};
  request.saving = true;
  request.start = editor.document.path();
  request.done = [&editor, then = std::move(then)](const fs::path& path) {
    if (write(editor, path) && then) then(editor);
  };
  editor.browser.open(editor, std::move(request));
}

void askExport(Editor& editor) {
  const std::string view = shownView(editor);
  if (view.empty())
    return editor.messages.hint("There is no output to export: add a View node and link an image to it.");
  BrowserRequest request;
  request.title = "Export picture as scene-linear EXR";
  request.button = "Export";
  request.kinds = {"exr"};
  request.saving = true;
  request.start = editor.document.path().parent_path();
  request.done = [&editor, view](const fs::path& path) {
    ExportRequest wanted{editor.document.graph(), view, path, editor.document.path().parent_path(), {}};
    if (linkedCamera(editor, view).empty()) wanted.freeCamera = editor.viewport.freeCamera;
    editor.exporter.start(std::move(wanted));
  };
  editor.browser.open(editor, std::move(request));
}

std::string documentName(const Editor& editor) {
  return editor.document.path().empty() ? "Untitled" : editor.document.path().filename().string();
}

}  // namespace pileus::editor
