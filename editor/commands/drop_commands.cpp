#include "editor/commands/drop_commands.h"

#include <fmt/core.h>

#include "editor/commands/files.h"
#include "editor/document/drops.h"
#include "editor/document/environment_scene.h"
#include "editor/document/session.h"
#include "editor/document/vdb_scene.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/graph_view/canvas.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/toolkit/modals.h"
#include "nodes/file/serialize.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

std::string nameOf(const fs::path& path) { return path.filename().string(); }

/// A document that only shows a preset and was never touched gives way.
bool untouched(const Editor& editor) {
  const nodes::Document& d = editor.session.document;
  return d.path().empty() && !d.canUndo() && !d.canRedo() && !d.dirty();
}

/// The node whose parameters and notes say most of an import: the file that is lit, which a medium reads.
std::string volumeOf(const nodes::Graph& graph, const std::set<std::string>& added) {
  for (const nodes::Link& link : graph.links)
    if (added.contains(link.fromNode) && added.contains(link.toNode) &&
        graph.nodes.at(link.fromNode)->type == "volume.vdb_file" &&
        graph.nodes.at(link.toNode)->type == "volume.medium")
      return link.fromNode;
  for (const std::string& name : added)
    if (graph.nodes.at(name)->type == "volume.vdb_file") return name;
  return added.empty() ? std::string() : *added.begin();
}

void addVolumes(Editor& editor, const std::vector<volume::VdbFit>& fits) {
  if (fits.empty()) return;
  const bool fresh = untouched(editor);
  editor.session.document.setScope({});  // lights and renders are looked for in the whole
  nodes::Graph base = editor.session.document.graph();
  if (fresh) {
    const nodes::Settings settings = base.settings;
    base = nodes::Graph{};
    base.settings = settings;
  }
  std::optional<scene::Camera> present;
  if (!fresh && editor.shown.preview.picture())
    present = currentCamera(editor.session, editor.clock, editor.shown);
  const Result<VdbScene> scene = addVdbFiles(
      base, fits, fresh ? "" : cameraUser(editor.session, shownView(editor.session, editor.shown)), present);
  if (!scene) return editor.messages.error(scene.error().message);
  const std::string label = fits.size() == 1 ? "Import " + nameOf(fits.front().file)
                                             : fmt::format("Import {} volumes", fits.size());
  if (!tryEdit(editor.session, editor.messages, scene->graph, label)) return;
  editor.session.document.endMerge();
  if (scene->camera && scene->cameraNode.empty()) editor.shown.freeCamera = scene->camera;
  editor.session.document.select({volumeOf(scene->graph, scene->added)});
  editor.canvas.frameAll = true;
  for (const volume::VdbFit& fit : fits)
    for (const std::string& line : explainFit(fit)) log::info("{}", line);
  std::string text = scene->summary;
  if (fits.size() == 1 && fits.front().smoke)
    text +=
        fmt::format(": '{}', extinction {:.3g} 1/m", fits.front().guess.grid, fits.front().fit.extinction);
  for (const volume::VdbFit& fit : fits)
    if (fit.fire) text += fmt::format("; '{}' glows", fit.fire->grid);
  for (const volume::VdbFit& fit : fits)
    if (fit.frames.count > 1) text += fmt::format("; {} frames found beside it", fit.frames.count);
  editor.messages.info(text + ". One undo takes it back; the log says why.");
}

void addEnvironments(Editor& editor, const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    editor.session.document.setScope({});  // renders are looked for in the whole
    Result<EnvironmentScene> scene = addEnvironment(editor.session.document.graph(), file);
    if (!scene) return editor.messages.error(scene.error().message);
    if (!tryEdit(editor.session, editor.messages, std::move(scene->graph), "Add " + nameOf(file))) return;
    editor.session.document.endMerge();
    editor.session.document.select({scene->node});
    editor.canvas.frameAll = true;
    editor.messages.info(nameOf(file) + " lights the scene. One undo takes it back.");
  }
}

void merge(Editor& editor, const fs::path& path) {
  const nodes::Graph& graph = editor.session.document.graph();
  dvec2 at(0);
  for (const auto& [name, node] : graph.nodes) at = glm::max(at, node->at);
  std::set<std::string> pasted;
  Result<nodes::Graph> merged = nodes::mergeGraph(graph, path, editor.session.document.path().parent_path(),
                                                  at + dvec2(600, 300), &pasted);
  if (!merged) return editor.messages.error("Not merged: " + merged.error().message);
  if (!tryEdit(editor.session, editor.messages, std::move(*merged), "Merge " + nameOf(path))) return;
  editor.session.document.select(std::move(pasted));
  editor.canvas.frameAll = true;
  editor.messages.info("Merged " + nameOf(path));
}

void askGraph(Editor& editor, const fs::path& path) {
  Question q;
  q.id = "drop";
  q.title = "Open " + nameOf(path) + "?";
  q.text =
      "Opening it puts it in the place of the present document. Merging adds its nodes to the present graph, "
      "as one step that can be undone.";
  q.answers = {
      {"Open", [&editor, path] { withSavedDocument(editor, [&editor, path] { openFile(editor, path); }); }},
      {"Merge", [&editor, path] { merge(editor, path); }},
      {"Cancel", {}}};
  editor.modals.questions.ask(std::move(q));
}

void askStill(Editor& editor, const fs::path& path, const std::string& text) {
  Question q;
  q.id = "still";
  q.title = "Open the graph of " + nameOf(path) + "?";
  q.text =
      "This picture carries the graph it was rendered from. It opens as a new document; the picture stays as "
      "it is.";
  q.answers = {{"Open graph",
                [&editor, path, text] {
                  withSavedDocument(editor, [&editor, path, text] { openText(editor, text, path); });
                }},
               {"Cancel", {}}};
  editor.modals.questions.ask(std::move(q));
}

}  // namespace

bool takeDrops(Editor& editor) {
  const std::optional<DropContent> read = editor.drops.step(editor.messages);
  if (!read) return false;
  const DropContent& content = *read;
  std::string refused;
  for (const std::string& text : content.refusals) {
    log::warn("{}", text);
    refused += (refused.empty() ? "" : "\n\n") + text;
  }
  if (!refused.empty()) {
    Question q;
    q.id = "refused";
    q.title = content.refusals.size() == 1 ? "This file cannot be used" : "These files cannot be used";
    q.text = refused;
    q.answers = {{"Close", {}}};
    editor.modals.questions.ask(std::move(q));
  }
  addVolumes(editor, content.volumes);
  addEnvironments(editor, content.environments);
  for (const std::string& note : content.notes) editor.messages.info(note);
  for (const fs::path& path : content.graphs) askGraph(editor, path);
  for (const auto& [path, text] : content.stills) askStill(editor, path, text);
  return true;
}

void askImportVdb(Editor& editor) {
  BrowserRequest request;
  request.title = "Import volume";
  request.button = "Import";
  request.kinds = {"vdb"};
  request.otherwise = editor.session.document.path().parent_path();
  request.done = [&editor](const fs::path& path) { editor.drops.take({path}); };
  editor.modals.browser.open(editor.settings, std::move(request));
}

}  // namespace pileus::editor
