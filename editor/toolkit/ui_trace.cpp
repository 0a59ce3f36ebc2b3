#include "editor/toolkit/ui_trace.h"

#include <imgui_internal.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

#include "renderer/base/file.h"

namespace pileus::editor {

UiTrace::UiTrace() {
  if (const char* path = std::getenv("PILEUS_UI_TRACE")) path_ = path;
}

void UiTrace::item(std::string name) {
  if (on() && !ImGui::GetCurrentWindow()->Hidden)
    rect(std::move(name), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void UiTrace::end(nlohmann::json state) {
  using nlohmann::json;
  state["rects"] = rects_;
  state["notes"] = notes_;
  const json timing = std::exchange(state["uiMs"], nullptr);  // differs every time: no reason to write
  std::string text = state.dump(1, ' ', false, json::error_handler_t::replace);
  if (text == last_) return;
  last_ = std::move(text);
  state["uiMs"] = timing;
  if (!writeFileAtomic(path_, state.dump(1, ' ', false, json::error_handler_t::replace))) last_.clear();
}

}  // namespace pileus::editor
