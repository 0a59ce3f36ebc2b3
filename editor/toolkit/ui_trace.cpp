#include "editor/toolkit/ui_trace.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

namespace pileus::editor {

UiTrace::UiTrace() {
  if (const char* path = std::getenv("PILEUS_UI_TRACE")) path_ = path;
}

void UiTrace::item(std::string name) {
  if (on() && !ImGui::GetCurrentWindow()->Hidden)
    rect(std::move(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void UiTrace::end(unsigned long long marks, const std::string& document, nlohmann::json state) {
  state["rects"] = rects_;
  state["notes"] = notes_;
  const std::string rest = state.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).substr(1);
  std::string text = fmt::format("\"marks\":{},\"document\":{},{}", marks, document, rest);
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
