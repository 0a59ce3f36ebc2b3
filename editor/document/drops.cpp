#include "editor/document/drops.h"

#include <algorithm>
#include <cctype>

#include "editor/app/editor.h"
#include "editor/document/files.h"
#include "editor/document/vdb_scene.h"
#include "editor/picture/shown_camera.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"
#include "renderer/image/exr.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

std::string nameOf(const fs::path& path) { return path.filename().string(); }

/// A document that only shows a preset and was never touched gives way.
bool untouched(const Editor& editor) {
  const nodes::Document& d = editor.document;
  return d.path().empty() && !d.canUndo() && !d.canRedo() && !d.dirty();
}

void addVolumes(Editor& editor, const std::vector<volume::VdbFit>& fits) {
  if (fits.empty()) return;
  const bool fresh = untouched(editor);
  editor.document.setScope({});  // lights and renders are looked for in the whole
  nodes::Graph base = editor.document.graph();
  if (fresh) {
    const nodes::Settings settings = base.settings;
    base = nodes::Graph{};
    base.settings = settings;
  }
  std::optional<scene::Camera> present;
  if (!fresh && editor.preview.picture()) present = currentCamera(editor);
  const Result<VdbScene> scene =
      addVdbFiles(base, fits, fresh ? "" : cameraUser(editor, shownView(editor)), present);
  if (!scene) return editor.messages.error(scene.error().message);
  const std::string label = fits.size() == 1 ? "Import " + nameOf(fits.front().file)
                                             : fmt::format("Import {} volumes", fits.size());
  if (!tryEdit(editor, scene->graph, label)) return;
  editor.document.endMerge();
  if (scene->camera && scene->cameraNode.empty()) editor.viewport.freeCamera = scene->camera;
  editor.document.select(scene->added);
  (fresh ? editor.canvas.frameAll : editor.canvas.frameSelection) = true;
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

void merge(Editor& editor, const fs::path& path) {
  const Result<std::string> text = readFile(path, std::size_t(64) << 20);
  if (!text) return editor.messages.error(text.error().message);
  const nodes::Graph& graph = editor.document.graph();
  dvec2 at(0);
  for (const auto& [name, node] : graph.nodes) at = glm::max(at, node->at);
  std::set<std::string> pasted;
  Result<nodes::Graph> merged = nodes::pasteText(graph, *text, at + dvec2(600, 300), &pasted);
  if (!merged) return editor.messages.error(path.string() + ": cannot be merged: " + merged.error().message);
  if (!tryEdit(editor, std::move(*merged), "Merge " + nameOf(path))) return;
  editor.document.select(std::move(pasted));
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
      {"Open", [path](Editor& e) { withSavedDocument(e, [path](Editor& x) { openFile(x, path); }); }},
      {"Merge", [path](Editor& e) { merge(e, path); }},
      {"Cancel", {}}};
  editor.dialogs.questions.ask(std::move(q));
}

void askStill(Editor& editor, const fs::path& path, const std::string& text) {
  Question q;
  q.id = "still";
  q.title = "Open the graph of " + nameOf(path) + "?";
  q.text =
      "This picture carries the graph it was rendered from. It opens as a new document; the picture stays as "
      "it is.";
  q.answers = {{"Open graph",
                [path, text](Editor& e) {
                  withSavedDocument(e, [path, text](Editor& x) { openText(x, text, path); });
                }},
               {"Cancel", {}}};
  editor.dialogs.questions.ask(std::move(q));
}

}  // namespace

DropKind dropKind(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (ending == ".json") return DropKind::Graph;
  if (ending == ".vdb") return DropKind::Volume;
  if (ending == ".exr") return DropKind::Still;
  if (ending == ".hdr") return DropKind::Environment;
  return DropKind::Unknown;
}

std::string whyNotDropped(const fs::path& path, DropKind kind) {
  const std::string name = nameOf(path);
  if (kind == DropKind::Still)
    return name +
           " carries no Pileus graph. Environment lights do not exist yet: light the scene with Sun, Point "
           "or "
           "Spot lights; a still exported by Pileus gives its graph back.";
  if (kind == DropKind::Environment)
    return name +
           " is an environment picture. Environment lights do not exist yet: light the scene with a Sun "
           "and a second, bluish one as sky.";
  if (path.extension() == ".nvdb")
    return name + " is a NanoVDB file, which cannot be read: convert it to .vdb (nanovdb_convert).";
  std::error_code ec;
  if (fs::is_directory(path, ec))
    return name + " is a folder. Graphs (.json), volumes (.vdb) and stills (.exr) can be dropped.";
  return name + " cannot be used. Graphs (.json), volumes (.vdb) and stills (.exr) can be dropped.";
}

DropContent readDrops(const std::vector<fs::path>& paths, JobControl& control) {
  DropContent out;
  for (const fs::path& path : paths) {
    if (control.cancelled()) break;
    const DropKind kind = dropKind(path);
    std::error_code ec;
    if (!fs::exists(path, ec)) {
      out.refusals.push_back(path.string() + ": there is no such file");
    } else if (kind == DropKind::Graph) {
      out.graphs.push_back(path);
    } else if (kind == DropKind::Volume) {
      Result<volume::VdbFit> fit = volume::fitVdb(path, control);
      if (fit)
        out.volumes.push_back(std::move(*fit));
      else
        out.refusals.push_back(fit.error().message);
    } else if (kind == DropKind::Still) {
      const auto metadata = image::readExrMetadata(path);
      if (!metadata)
        out.refusals.push_back(metadata.error().message);
      else if (const auto it = metadata->find(image::kGraphAttribute); it != metadata->end())
        out.stills.emplace_back(path, it->second);
      else
        out.refusals.push_back(whyNotDropped(path, kind));
    } else {
      out.refusals.push_back(whyNotDropped(path, kind));
    }
  }
  return out;
}

void Drops::take(std::vector<fs::path> paths) {
  std::error_code ec;
  for (fs::path& path : paths) waiting_.push_back(fs::absolute(path, ec).lexically_normal());
}

void Drops::step(Editor& editor) {
  if (!job_ && !waiting_.empty()) {
    const auto volumes = std::count_if(waiting_.begin(), waiting_.end(),
                                       [](const fs::path& p) { return dropKind(p) == DropKind::Volume; });
    if (volumes > 0) editor.messages.note("Reading " + nameOf(waiting_.front()) + "\xe2\x80\xa6");
    job_ = std::make_unique<Job<DropContent>>(
        [paths = std::exchange(waiting_, {})](JobControl& control) -> Result<DropContent> {
          return readDrops(paths, control);
        });
  }
  if (!job_ || !job_->done()) return;
  const std::unique_ptr<Job<DropContent>> done = std::move(job_);
  const DropContent& content = *done->result();
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
    editor.dialogs.questions.ask(std::move(q));
  }
  addVolumes(editor, content.volumes);
  for (const fs::path& path : content.graphs) askGraph(editor, path);
  for (const auto& [path, text] : content.stills) askStill(editor, path, text);
}

void askImportVdb(Editor& editor) {
  BrowserRequest request;
  request.title = "Import volume";
  request.button = "Import";
  request.kinds = {"vdb"};
  request.start = editor.document.path().parent_path();
  request.done = [&editor](const fs::path& path) { editor.drops.take({path}); };
  editor.browser.open(editor, std::move(request));
}

}  // namespace pileus::editor
