#include "editor/toolkit/ui_trace.h"

#include <imgui_internal.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "editor/app/editor.h"
#include "nodes/file/serialize.h"
#include "renderer/base/file.h"

namespace pileus::editor {

UiTrace::UiTrace() {
  if (const char* path = std::getenv("PILEUS_UI_TRACE")) path_ = path;
}

void UiTrace::item(std::string name) {
  if (on() && !ImGui::GetCurrentWindow()->Hidden)
    rect(std::move(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void UiTrace::end(const Editor& editor) {
  if (path_.empty()) return;
  using nlohmann::json;
  json j;
  j["rects"] = rects_;
  j["notes"] = notes_;
  const nodes::Document& document = editor.document;
  // The document in its own file format: what a save would write.
  j["document"] = json::parse(nodes::graphText(document.root()), nullptr, false);
  j["scope"] = document.scope();
  j["selection"] = document.selection();
  j["dirty"] = document.dirty();
  j["path"] = document.path().string();
  j["undo"] = document.undoLabel();
  j["redo"] = document.redoLabel();
  j["complete"] = editor.preview.settled();
  j["error"] = editor.preview.error();
  j["exporting"] = editor.exporter.active();
  j["frame"] = editor.frame;
  j["pictureFrame"] = editor.preview.frame();
  j["playing"] = editor.timeline.clock.direction();
  j["message"] = editor.messages.text();
  std::string text = j.dump(1, ' ', false, json::error_handler_t::replace);
  if (text == last_) return;
  last_ = std::move(text);
  j["uiMs"] = editor.uiMs;  // differs every time: no reason to write
  if (!writeFileAtomic(path_, j.dump(1, ' ', false, json::error_handler_t::replace))) last_.clear();
}

}  // namespace pileus::editor
