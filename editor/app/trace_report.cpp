#include "editor/app/trace_report.h"

#include <imgui.h>

#include <nlohmann/json.hpp>

#include "editor/document/session.h"
#include "editor/editor.h"
#include "editor/exchange/messages.h"
#include "editor/picture/exporter.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/ui_trace.h"
#include "editor/toolkit/window.h"
#include "nodes/file/serialize.h"

namespace pileus::editor {

void TraceReport::write(Editor& editor) {
  if (!editor.trace.writes()) return;
  using nlohmann::json;
  const nodes::Document& document = editor.session.document;
  if (document_.empty() || graph_ != document.root()) {
    document_ = json::parse(nodes::graphText(document.root()), nullptr, false)
                    .dump(-1, ' ', false, json::error_handler_t::replace);
    graph_ = document.root();
  }
  json j;
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
  j["answered"] = editor.shown.preview.answered();
  j["pictureFrame"] = editor.shown.preview.frame();
  j["keptBytes"] = editor.shown.preview.evaluator().keptBytes();
  j["playing"] = editor.clock.play.direction();
  j["typing"] = ImGui::GetIO().WantTextInput;
  j["glFaults"] = editor.window.glFaults();
  j["message"] = editor.messages.text();
  editor.trace.end(editor.window.marks(), document_, std::move(j));
}

}  // namespace pileus::editor
