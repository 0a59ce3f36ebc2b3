#include "editor/parameters/eyedropper.h"

#include <epoxy/gl.h>
#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/parameters/color_picker.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/ui.h"

namespace pileus::editor {
namespace {

/// The texel under the pointer; nothing where it holds no finite colour.
std::optional<dvec3> texelAt(const view::Picture& picture, vec2 uv) {
  const ivec2 p = glm::clamp(ivec2(uv * vec2(picture.size)), ivec2(0), picture.size - 1);
  float rgba[4] = {};
  glGetTextureSubImage(picture.color.id(), 0, p.x, p.y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT, sizeof rgba, rgba);
  if (!std::isfinite(rgba[0]) || !std::isfinite(rgba[1]) || !std::isfinite(rgba[2])) return std::nullopt;
  return dvec3(rgba[0], rgba[1], rgba[2]);
}

void take(const ParameterRoom& room, const dvec3& seen) {
  const ParamTarget target = *room.parameters.eyedropper.target;
  dvec3 color =
      glm::clamp(glm::max(seen, dvec3(0)), dvec3(target.spec->hardMin), dvec3(target.spec->hardMax));
  for (int i = 0; i < 3; ++i) color[i] = std::round(color[i] * 1e5) / 1e5;
  const auto into = std::exchange(room.parameters.eyedropper.into, {});
  changeParam(
      room, target,
      [&](const nodes::ParamValue& own) -> nodes::ParamValue { return into ? into(own, color) : color; },
      false);
  room.parameters.eyedropper.target.reset();
}

}  // namespace

void drawEyedropper(const ParameterRoom& room) {
  Eyedropper& dropper = room.parameters.eyedropper;
  if (!dropper.target) return;
  const auto& picture = room.shown.preview.picture();
  if (!picture || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
    return dropper.target.reset();
  room.ui.messages.hint("Click in the picture to take its colour.");
  for (std::size_t i = 0; i < room.shown.places.size() && dropper.target; ++i) {
    const ScreenRect r = room.shown.places[i];
    ImGui::SetNextWindowPos({r.min.x, r.min.y});
    ImGui::SetNextWindowSize({std::max(r.max.x - r.min.x, 1.0f), std::max(r.max.y - r.min.y, 1.0f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin(("##eyedropper" + std::to_string(i)).c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    const bool clicked = ImGui::InvisibleButton("picture", ImGui::GetContentRegionAvail());
    if (ImGui::IsItemHovered()) {
      const ImVec2 mouse = ImGui::GetIO().MousePos;
      ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
      const vec2 uv = (vec2(mouse.x, mouse.y) - r.min) / glm::max(r.max - r.min, vec2(1));
      if (const auto seen = texelAt(*picture, uv)) {
        ImGui::BeginTooltip();
        colorSwatch(room.ui.theme, room.shown, room.parameters, "seen", *seen,
                    {room.ui.theme.px(40), room.ui.theme.px(20)});
        ImGui::SameLine();
        ImGui::Text("%.4g  %.4g  %.4g", seen->x, seen->y, seen->z);
        ImGui::EndTooltip();
        if (clicked) take(room, *seen);
      }
    }
    ImGui::End();
  }
}

}  // namespace pileus::editor
