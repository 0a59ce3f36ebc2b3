#include "editor/toolkit/ui_trace.h"

#include <imgui_internal.h>

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "editor/app/editor.h"
#include "editor/toolkit/window.h"
#include "nodes/file/serialize.h"

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
  const auto dump = [](const json& j) { return j.dump(-1, ' ', false, json::error_handler_t::replace); };
  const nodes::Document& document = editor.document;
  if (!graph_ || *graph_ != document.root()) {
    // The document in its own file format: what a save would write.
    document_ = dump(json::parse(nodes::graphText(document.root()), nullptr, false));
    graph_ = std::make_shared<nodes::Graph>(document.root());
  }
  json j;
  j["rects"] = rects_;
  j["notes"] = notes_;
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
  j["typing"] = ImGui::GetIO().WantTextInput;
  j["message"] = editor.messages.text();
  std::string text =
      fmt::format("\"marks\":{},\"document\":{},{}", editor.window->marks(), document_, dump(j).substr(1));
  if (text == last_) return;
  last_ = std::move(text);
  // Whole or not at all, but not safe from a power cut: nobody reads it after one.
  const std::filesystem::path fresh = path_.string() + ".new";
  std::ofstream(fresh) << fmt::format("{{\"time\":{:.4f},", ImGui::GetTime()) << last_;
  std::error_code ec;
  std::filesystem::rename(fresh, path_, ec);
  if (ec) last_.clear();
}

}  // namespace pileus::editor
