#include "editor/commands/files.h"

#include <fmt/core.h>

#include "editor/commands/relink.h"
#include "editor/document/daylight.h"
#include "editor/document/drops.h"
#include "editor/document/graph_pictures.h"
#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/graph_view/bookmarks.h"
#include "editor/graph_view/canvas.h"
#include "editor/picture/camera_places.h"
#include "editor/picture/exporter.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/preferences/settings.h"
#include "editor/time/clock.h"
#include "editor/toolkit/file_listing.h"
#include "editor/toolkit/modals.h"
#include "embedded_presets.h"
#include "nodes/file/preset.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

void put(Editor& editor, nodes::Loaded loaded, const fs::path& path, const std::string& name) {
  editor.session.document = nodes::Document(std::move(loaded.graph), path);
  documentReplaced(editor);
  if (loaded.faults.empty()) return;
  for (const nodes::Fault& f : loaded.faults)
    log::write(f.error ? log::Level::Error : log::Level::Warning, name + ": " + nodes::faultText(f));
  editor.modals.faults.clear();
  for (const nodes::Fault& f : loaded.faults)
    editor.modals.faults.push_back({f.error, f.where.empty() ? f.text : f.where + ": " + f.text});
  editor.modals.faultsOf = name;
}

void failed(Editor& editor, const std::string& title, const Error& error) {
  log::error("{}", error.message);
  editor.modals.errorTitle = title;
  editor.modals.errorText = error.message;
}

/// In another folder relative paths read differently: the document goes on with those of its new file.
void followFolder(Editor& editor, const fs::path& path) {
  const fs::path from = editor.session.document.path().parent_path(), to = path.parent_path();
  if (from.empty() || from == to) return;
  nodes::Graph moved = nodes::withRelativePaths(editor.session.document.root(), from, to);
  if (!(moved == editor.session.document.root()))
    editor.session.document.editRoot(std::move(moved), "Move to " + to.string());
}

bool write(Editor& editor, const fs::path& path) {
  const fs::path folder = editor.session.document.path().parent_path();
  fs::path kept;
  if (Result<void> saved = nodes::saveGraph(path, editor.session.document.root(), folder, &kept); !saved) {
    failed(editor, "The file was not saved", saved.error());
    editor.modals.errorText += "\n\nNothing is lost: the document is still open. Save it under another name.";
    return false;
  }
  followFolder(editor, path);
  bookmarksFollow(editor.settings, editor.session.document.path().string(), path.string());
  cameraPlacesFollow(editor.settings, editor.session.document.path().string(), path.string());
  editor.session.document.markSaved(path);
  editor.session.diskStamp = fileStamp(path);
  editor.session.recovery.discard();
  editor.pictures.keep(editor.shown.displayed.texture, path);
  remember(editor.settings.recentFiles, path.string());
  editor.messages.info("Saved " + path.string() +
                       (kept.empty() ? "" : "; what could not be read of it is kept in " + kept.string()));
  return true;
}

/// Somebody else wrote the document's file since it was read or saved here.
bool changedOnDisk(const Editor& editor) {
  std::error_code ec;
  const fs::path& path = editor.session.document.path();
  return fs::exists(path, ec) && fileStamp(path) != editor.session.diskStamp;
}

void askOverwrite(Editor& editor, std::function<void()> then) {
  Question q;
  q.id = "changed";
  q.title = documentName(editor.session) + " was changed by another program";
  q.text =
      "It is not what was opened or saved here any more. Saving replaces it; what the other program wrote is "
      "lost then.";
  q.answers = {{"Replace",
                [&editor, then] {
                  if (write(editor, editor.session.document.path()) && then) then();
                }},
               {"Save as\xe2\x80\xa6", [&editor, then] { saveAs(editor, then); }},
               {"Cancel", {}}};
  editor.modals.questions.ask(std::move(q));
}

}  // namespace

void withSavedDocument(Editor& editor, std::function<void()> then) {
  if (editor.session.document.dirty())
    editor.modals.afterUnsaved = std::move(then);
  else
    then();
}

void quit(Editor& editor) {
  withSavedDocument(editor, [&editor] {
    if (!editor.exporter.active()) return void(editor.quit = true);
    Question q;
    q.id = "exporting";
    q.title = editor.exporter.target().filename().string() + " is still being exported";
    q.text =
        fmt::format("It is {:.0f} % done. Quitting now leaves no file.", 100 * editor.exporter.fraction());
    q.answers = {{"Quit when it is done", [&editor] { editor.quitAfterExport = true; }},
                 {"Quit now", [&editor] { editor.quit = true; }},
                 {"Cancel", {}}};
    editor.modals.questions.ask(std::move(q));
  });
}

void newDocument(Editor& editor) {
  withSavedDocument(editor, [&editor] {
    Result<nodes::Graph> scene = newScene();
    editor.session.document = nodes::Document(scene ? std::move(*scene) : nodes::Graph());
    documentReplaced(editor);
    editor.canvas.frameAll = true;
  });
}

void askOpen(Editor& editor) {
  withSavedDocument(editor, [&editor] {
    BrowserRequest request;
    request.title = "Open graph";
    request.button = "Open";
    request.kinds = {"json"};
    request.start = editor.session.document.path().parent_path();
    request.done = [&editor](const fs::path& path) { openFile(editor, path); };
    editor.modals.browser.open(editor.settings, std::move(request));
  });
}

bool openFile(Editor& editor, const fs::path& path) {
  std::error_code ec;
  if (dropKind(path) != DropKind::Graph) {  // a volume or a still: shown in an empty document
    editor.session.document = nodes::Document();
    documentReplaced(editor);
    editor.drops.take({path});
    return true;
  }
  const fs::path whole = fs::absolute(path, ec).lexically_normal();
  const Key stamp = fileStamp(whole);  // before it is read: what is written meanwhile is somebody else's
  Result<nodes::Loaded> loaded = nodes::loadGraph(whole);
  if (!loaded) {
    failed(editor, "The file was not opened", loaded.error());
    return false;
  }
  put(editor, std::move(*loaded), whole, whole.filename().string());
  editor.session.diskStamp = stamp;
  remember(editor.settings.recentFiles, whole.string());
  tellMissing(editor);
  return true;
}

bool openText(Editor& editor, const std::string& text, const fs::path& from) {
  Result<nodes::Loaded> loaded = nodes::parseGraph(text);
  if (!loaded) {
    failed(editor, "The graph was not opened", loaded.error());
    return false;
  }
  loaded->graph = nodes::withRelativePaths(loaded->graph, from.parent_path(), "/");
  put(editor, std::move(*loaded), {}, from.filename().string());
  editor.messages.info("Opened the graph of " + from.filename().string());
  return true;
}

bool openLost(Editor& editor, const Lost& lost) {
  Result<nodes::Loaded> work = nodes::loadGraph(lost.file);
  if (!work) {
    failed(editor, "The unsaved work was not opened", work.error());
    return false;
  }
  Result<nodes::Loaded> saved = nodes::Loaded{};
  const Key stamp = fileStamp(lost.original);
  if (!lost.original.empty()) saved = nodes::loadGraph(lost.original);
  put(editor, saved ? std::move(*saved) : nodes::Loaded{}, lost.original,
      lost.original.empty() ? "Untitled" : lost.original.filename().string());
  editor.session.diskStamp = stamp;
  editor.session.document.editRoot(std::move(work->graph), "Recover unsaved work");
  editor.canvas.frameAll = true;
  // Ours before the old one goes.
  if (editor.session.recovery.saveNow(editor.session.document.root(), lost.original)) removeLost(lost);
  editor.messages.info("Unsaved work opened. It is not in a file yet: save it.");
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

bool openPresetText(Editor& editor, const std::string& text, const fs::path& from) {
  Result<nodes::LoadedPreset> loaded = nodes::presetFromText(text);
  if (!loaded) {
    failed(editor, "The preset was not opened", loaded.error());
    return false;
  }
  nodes::Loaded scene{nodes::withRelativePaths(loaded->preset.graph, from.parent_path(), "/"),
                      std::move(loaded->faults)};
  put(editor, std::move(scene), {}, loaded->preset.name);
  tellMissing(editor);
  return true;
}

void save(Editor& editor, std::function<void()> then) {
  if (editor.session.document.path().empty()) return saveAs(editor, std::move(then));
  if (changedOnDisk(editor)) return askOverwrite(editor, std::move(then));
  if (write(editor, editor.session.document.path()) && then) then();
}

void saveAs(Editor& editor, std::function<void()> then) {
  BrowserRequest request;
  request.title = "Save graph as";
  request.button = "Save";
  request.kinds = {"json"};
  request.saving = true;
  request.start = editor.session.document.path();
  request.name = "untitled.json";
  request.done = [&editor, then = std::move(then)](const fs::path& path) {
    if (write(editor, path) && then) then();
  };
  editor.modals.browser.open(editor.settings, std::move(request));
}

void saveNextVersion(Editor& editor) {
  if (editor.session.document.path().empty()) return saveAs(editor);
  write(editor, nextVersion(editor.session.document.path()));
}

void askExport(Editor& editor) {
  const std::string view = shownView(editor.session, editor.shown);
  if (view.empty())
    return editor.messages.hint("There is no output to export: add a View node and link an image to it.");
  BrowserRequest request;
  request.title = "Export picture as scene-linear EXR";
  request.button = "Export";
  request.kinds = {"exr"};
  request.saving = true;
  request.otherwise = editor.session.document.path().parent_path();
  request.name = fs::path(documentName(editor.session)).stem().string() + ".exr";
  request.done = [&editor, view](const fs::path& path) {
    ExportRequest wanted{
        editor.session.document.root(), view, path, editor.session.document.path().parent_path(), {}};
    if (linkedCamera(editor.session, view).empty()) wanted.freeCamera = editor.shown.freeCamera;
    wanted.frame = editor.clock.frame;
    if (!editor.exporter.active()) return editor.exporter.start(std::move(wanted));
    Question q;
    q.id = "export running";
    q.title = editor.exporter.target().filename().string() + " is still being exported";
    q.text = fmt::format("It is {:.0f} % done. One picture is exported at a time.",
                         100 * editor.exporter.fraction());
    q.answers = {
        {"Stop it, export " + path.filename().string(), [&editor, wanted] { editor.exporter.start(wanted); }},
        {"Cancel", {}}};
    editor.modals.questions.ask(std::move(q));
  };
  editor.modals.browser.open(editor.settings, std::move(request));
}

}  // namespace pileus::editor
