#include "editor/commands/library/presets.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "editor/commands/files.h"
#include "editor/document/preset_shelf.h"
#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/graph_view/canvas.h"
#include "editor/picture/shown.h"
#include "editor/preferences/settings.h"
#include "editor/start/start_view.h"
#include "editor/toolkit/modals.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/image/png.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr int kPictureSize = 640;

/// Those that may be written to; the user's own is made when it is needed.
std::vector<fs::path> writableFolders(const Settings& settings) {
  std::vector<fs::path> out;
  for (const fs::path& folder : presetFolders(settings))
    if (out.empty() || ::access(folder.c_str(), W_OK) == 0) out.push_back(folder);
  return out;
}

fs::path documentFolder(const Editor& editor) {
  std::error_code ec;
  const fs::path folder = editor.session.document.path().parent_path();
  return folder.empty() ? fs::current_path(ec) : folder;
}

void openDialog(Editor& editor, PresetDialog dialog) {
  editor.modals.preset = true;
  dialog.folders = writableFolders(editor.settings);
  dialog.looking = editor.presetDialog.looking;
  editor.presetDialog = std::move(dialog);
}

void addNodes(Editor& editor, const nodes::Preset& preset, dvec2 at) {
  std::set<std::string> added;
  Result<nodes::Graph> graph =
      nodes::pasteText(editor.session.document.graph(), nodes::presetText(preset), at, &added);
  if (tryEdit(editor.session, editor.messages, std::move(graph), "Add " + preset.name))
    editor.session.document.select(std::move(added));
}

void addParameters(Editor& editor, const nodes::Preset& preset, const std::string& node, dvec2 at) {
  if (!node.empty()) {
    if (tryEdit(editor.session, editor.messages,
                nodes::withPresetParameters(editor.session.document.graph(), node, preset),
                preset.name + " on " + node))
      editor.messages.note("Took the values of " + preset.name + ".");
    return;
  }
  const nodes::Graph& graph = editor.session.document.graph();
  const std::string& type = preset.graph.nodes.begin()->second->type;
  const nodes::NodeType* known = nodes::findNodeType(type);
  const std::string name = nodes::freeName(graph, nodes::checkName(preset.name) ? preset.name
                                                  : known                       ? known->label
                                                                                : type);
  Result<nodes::Graph> added = nodes::addNode(graph, type, at, name);
  if (added) added = nodes::withPresetParameters(*added, name, preset);
  if (tryEdit(editor.session, editor.messages, std::move(added), "Add " + name))
    editor.session.document.select({name});
}

void openScene(Editor& editor, const fs::path& file) {
  withSavedDocument(editor, [&editor, file] {
    const Result<std::string> text = readFile(file, std::size_t(64) << 20);
    if (!text) return editor.messages.error(text.error().message);
    openPresetText(editor, *text, file);
  });
}

}  // namespace

void askKeepPreset(Editor& editor, nodes::PresetKind kind) {
  const nodes::Document& document = editor.session.document;
  PresetDialog dialog;
  if (kind == nodes::PresetKind::Document) {
    dialog.preset.graph = document.root();
    if (!document.path().empty()) dialog.name = document.path().stem().string();
  } else {
    Result<nodes::Preset> kept = nodes::presetOf(document.graph(), document.selection(), kind);
    if (!kept) return editor.messages.hint(kept.error().message);
    dialog.preset = std::move(*kept);
    if (document.selection().size() == 1) dialog.name = *document.selection().begin();
  }
  dialog.preset.kind = kind;
  dialog.from = documentFolder(editor);
  dialog.picture = readTexture(editor.shown.displayed.texture);
  openDialog(editor, std::move(dialog));
}

fs::path replacedBy(const Editor& editor, const PresetDialog& dialog) {
  if (dialog.folders.empty()) return {};
  const fs::path folder = dialog.describing.empty() ? dialog.folders[static_cast<std::size_t>(dialog.folder)]
                                                    : dialog.describing.parent_path();
  for (const nodes::PresetEntry& e : editor.presets.entries())
    if (e.fault.empty() && e.name == dialog.name && e.file.parent_path() == folder &&
        e.file != dialog.describing)
      return e.file;
  return {};
}

void keepPreset(Editor& editor) {
  PresetDialog& d = editor.presetDialog;
  if (d.folders.empty() || editor.presets.changing()) return;
  d.error.clear();
  const std::vector<std::string> tags = nodes::presetTags(d.tags);
  if (!d.describing.empty()) {
    editor.presets.change([file = d.describing, name = d.name, about = d.about, tags] {
      return nodes::describePreset(file, name, about, tags);
    });
    return;
  }
  nodes::Preset preset = d.preset;
  preset.name = d.name;
  preset.about = d.about;
  preset.tags = tags;
  editor.presets.change([preset = std::move(preset), picture = d.picture, from = d.from,
                         folder = d.folders[static_cast<std::size_t>(d.folder)],
                         replaced = replacedBy(editor, d)]() -> Result<nodes::PresetChange> {
    std::string png;
    if (!picture.rgba.empty()) {
      const SmallPicture small = reducedPicture(picture.size, picture.rgba, kPictureSize);
      PILEUS_TRY(png, image::encodePng(small.size, small.rgba.data()));
    }
    return replaced.empty() ? nodes::savePreset(folder, preset, png, from)
                            : nodes::replacePreset(replaced, preset, png, from);
  });
}

void usePreset(Editor& editor, const UsePreset& request) {
  const Result<nodes::LoadedPreset> loaded =
      nodes::loadPreset(request.file, editor.session.document.path().parent_path());
  if (!loaded) return editor.messages.error("The preset cannot be read: " + loaded.error().message);
  const nodes::Preset& preset = loaded->preset;
  const dvec2 at = request.at.value_or(editor.canvas.center);
  switch (preset.kind) {
    case nodes::PresetKind::Document:
      return openScene(editor, request.file);
    case nodes::PresetKind::Nodes:
      return addNodes(editor, preset, at);
    case nodes::PresetKind::Parameters:
      return addParameters(editor, preset, request.node, at);
  }
}

void changePreset(Editor& editor, const ChangePreset& request) {
  const nodes::PresetEntry* found = editor.presets.find(request.file);
  if (request.how == ChangePreset::How::Reveal) return showInFolder(editor.ui, request.file);
  if (!found) return;
  if (request.how == ChangePreset::How::Delete) {
    if (!editor.presets.change([file = request.file] { return nodes::deletePreset(file); }))
      editor.messages.hint("Another preset is being written; try again in a moment.");
    return;
  }
  PresetDialog dialog;
  dialog.describing = request.file;
  dialog.preset.kind = found->kind;
  dialog.name = found->name;
  dialog.about = found->about;
  dialog.tags = nodes::presetTagList(found->tags);
  openDialog(editor, std::move(dialog));
}

void askPresetFolder(Editor& editor) {
  BrowserRequest request;
  request.title = "Add a folder of presets";
  request.button = "Add";
  request.kinds = {"json"};
  request.folder = true;
  request.done = [&editor](const fs::path& folder) {
    std::vector<std::string>& folders = editor.settings.presetFolders;
    const std::string text = folder.lexically_normal().string();
    if (std::find(folders.begin(), folders.end(), text) != folders.end())
      return editor.messages.hint("The presets of this folder are shown already.");
    folders.push_back(text);
    editor.presets.refresh(presetFolders(editor.settings));
    editor.messages.info("The presets of " + text + " are in the gallery.");
  };
  editor.modals.browser.open(editor.settings, std::move(request));
}

void pollPresets(Editor& editor) {
  const bool looking = editor.start.open || editor.canvas.search.open || editor.canvas.menuOpening;
  if (looking && !std::exchange(editor.presetDialog.looking, looking))
    editor.presets.refresh(presetFolders(editor.settings));
  editor.presetDialog.looking = looking;
  const auto change = editor.presets.poll();
  if (!change) return;
  PresetDialog& d = editor.presetDialog;
  if (!*change) {
    if (editor.modals.preset)
      d.error = change->error().message;
    else
      editor.messages.error("The preset was not changed: " + change->error().message);
    return;
  }
  editor.modals.preset = false;
  if ((*change)->undone)
    editor.messages.info((*change)->label);
  else
    editor.messages.offer((*change)->label, "Undo", "presets.undo");
}

}  // namespace pileus::editor
