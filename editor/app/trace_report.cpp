#include "editor/app/trace_report.h"

#include <nlohmann/json.hpp>

#include "editor/document/exporter.h"
#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/ui_trace.h"
#include "nodes/file/serialize.h"

namespace pileus::editor {

void writeTrace(Editor& editor) {
  if (!editor.trace.writes()) return;
  using nlohmann::json;
  json j;
  const nodes::Document& document = editor.session.document;
  // The document in its own file format: what a save would write.
  j["document"] = json::parse(nodes::graphText(document.root()), nullptr, false);
  j["scope"] = document.scope();
  j["selection"] = document.selection();
  j["dirty"] = document.dirty();
  j["path"] = document.path().string();
  j["undo"] = document.undoLabel();
  j["redo"] = document.redoLabel();
  j["complete"] = editor.shown.preview.settled();
  j["error"] = editor.shown.preview.error();
  j["exporting"] = editor.exporter.active();
  j["frame"] = editor.clock.frame;
  j["pictureFrame"] = editor.shown.preview.frame();
  j["playing"] = editor.clock.play.direction();
  j["message"] = editor.messages.text();
  j["uiMs"] = editor.now.uiMs;
  editor.trace.end(std::move(j));
}

}  // namespace pileus::editor
