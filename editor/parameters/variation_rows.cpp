#include "editor/parameters/variation_rows.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/document/graph_pictures.h"
#include "editor/document/session.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/shown.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "nodes/file/serialize.h"
#include "renderer/base/hash.h"

namespace pileus::editor {
namespace {

constexpr char kMerge[] = "blend variations";

/// Where the picture of some values is kept: by what they are, so that it goes with them under any name.
std::filesystem::path pictureKey(const nodes::Variation& v) {
  return "/variation/" + Hasher().add(nodes::graphText(v.values)).key().hex();
}

void follow(const ParameterRoom& room) {
  VariationRows& rows = room.parameters.variations;
  const nodes::Document& document = room.session.document;
  if (rows.revision == document.revision() && rows.generation == room.session.generation) return;
  rows.revision = document.revision(), rows.generation = room.session.generation;
  // A blend changes values, not what is kept of them.
  const auto kept = document.root().unknown.find("variations");
  const std::string text = kept == document.root().unknown.end() ? std::string() : kept->second;
  if (text == std::exchange(rows.text, text)) return;
  Result<std::vector<nodes::Variation>> all = nodes::variationsOf(document.root());
  rows.error = all ? "" : all.error().message;
  rows.all = all ? std::move(*all) : std::vector<nodes::Variation>();
  rows.pictures.clear();
  for (const nodes::Variation& v : rows.all) rows.pictures.push_back(pictureKey(v));
  rows.at = std::clamp(rows.at, 0.0, std::max(0.0, static_cast<double>(rows.all.size()) - 1));
}

void keep(const ParameterRoom& room, const std::vector<nodes::Variation>& all, const std::string& label) {
  tryEditRoot(room.session, room.ui.messages, nodes::withVariations(room.session.document.root(), all),
              label);
  room.session.document.endMerge();
}

void blend(const ParameterRoom& room, double at, bool dragging) {
  const VariationRows& rows = room.parameters.variations;
  const nodes::Graph& root = room.session.document.root();
  tryEditRoot(room.session, room.ui.messages, nodes::withValues(root, nodes::blendedValues(rows.all, at)),
              "Blend variations", kMerge);
  if (dragging) room.shown.preview.touch();
}

void drawThumbnail(const ParameterRoom& room, const std::filesystem::path& picture, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 hi = {at.x + size.x, at.y + size.y};
  draw->AddRectFilled(at, hi, palette::kPictureEmpty, room.ui.theme.px(3));
  const GraphPictures::Shown shown = room.pictures.file(picture);
  if (shown.texture != 0)
    draw->AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(shown.texture)), at, hi,
                          {0, 0}, {1, 1}, IM_COL32_WHITE, room.ui.theme.px(3));
  ImGui::Dummy(size);
}

/// Returns whether the list was changed: nothing more is drawn of it then.
bool drawRow(const ParameterRoom& room, std::size_t i) {
  Ui& ui = room.ui;
  const Theme& theme = ui.theme;
  VariationRows& rows = room.parameters.variations;
  const nodes::Variation& variation = rows.all[i];
  ImGui::PushID(static_cast<int>(i));
  const std::string trace = fmt::format("variation/{}", i);
  drawThumbnail(room, rows.pictures[i], {theme.px(80), theme.px(45)});
  ImGui::SameLine(0, theme.space(2));
  ImGui::BeginGroup();
  const bool naming = rows.naming == i;
  std::string name = naming ? rows.name : variation.name;
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##name", &name);
  ui.trace.item(trace + "/name");
  bool changed = false;
  if (ImGui::IsItemActive()) rows.naming = i, rows.name = name;
  if (naming && ImGui::IsItemDeactivated()) {
    rows.naming = ~std::size_t(0);
    if (!name.empty() && name != variation.name) {
      std::vector<nodes::Variation> all = rows.all;
      all[i].name = name;
      keep(room, all, "Rename variation");
      changed = true;
    }
  }
  const auto button = [&](const char* label, const char* id, const char* help) {
    const bool pressed = ImGui::SmallButton(label);
    ui.trace.item(trace + "/" + id);
    if (ImGui::IsItemHovered()) tooltip(theme, help);
    ImGui::SameLine(0, theme.px(4));
    return pressed;
  };
  if (button("Use", "use", "All parameters as they were when it was taken. One undo takes it back.")) {
    rows.at = static_cast<double>(i);
    blend(room, rows.at, false);
    room.session.document.endMerge();
    changed = true;
  } else if (button("Replace", "replace", "Takes the values and the picture as they are now.")) {
    std::vector<nodes::Variation> all = rows.all;
    all[i].values = nodes::valuesOf(room.session.document.root());
    room.pictures.keep(room.shown.displayed.texture, pictureKey(all[i]));
    keep(room, all, "Replace " + all[i].name);
    changed = true;
  } else if (button("Delete", "delete", "Undo brings it back.")) {
    std::vector<nodes::Variation> all = rows.all;
    const std::string gone = variation.name;
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    keep(room, all, "Delete " + gone);
    changed = true;
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return changed;
}

/// From the first to the last; its places are those of the rows.
void drawSlider(const ParameterRoom& room) {
  Ui& ui = room.ui;
  VariationRows& rows = room.parameters.variations;
  if (rows.all.size() < 2) return;
  const double last = static_cast<double>(rows.all.size() - 1);
  NumberField field;
  field.hardMin = field.softMin = 0, field.hardMax = field.softMax = last;
  ImGui::TextDisabled("Blend");
  ImGui::SameLine(0, ui.theme.space(2));
  double at = rows.at;
  const NumberEdit edit =
      numberField(ui.fields.number, ui.theme, "variation blend", at, field, ImGui::GetContentRegionAvail().x);
  ui.trace.item("variation/blend");
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    tooltip(
        ui.theme,
        "0 is the first variation, 1 the second, and so on; between them all parameters are. Angles go the "
        "short way, choices change half way.");
  if (edit.changed) {
    rows.at = at;
    blend(room, at, edit.dragging);
  }
  if (edit.finished) room.session.document.endMerge();
  const auto i = static_cast<std::size_t>(std::min(std::floor(rows.at), last - 1));
  ImGui::TextDisabled("%s", fmt::format("{:.0f} % {}, {:.0f} % {}", 100 * (1 - (rows.at - double(i))),
                                        rows.all[i].name, 100 * (rows.at - double(i)), rows.all[i + 1].name)
                                .c_str());
}

}  // namespace

void takeVariation(const ParameterRoom& room) {
  follow(room);
  VariationRows& rows = room.parameters.variations;
  if (!rows.error.empty()) return room.ui.messages.error("No variation was taken: " + rows.error);
  std::vector<nodes::Variation> all = rows.all;
  all.push_back({nodes::freeVariationName(all), nodes::valuesOf(room.session.document.root())});
  room.pictures.keep(room.shown.displayed.texture, pictureKey(all.back()));
  keep(room, all, "Take " + all.back().name);
  rows.at = static_cast<double>(all.size() - 1);
  room.ui.messages.note("Took " + all.back().name + ": the values of all parameters.");
}

void drawVariationRows(const ParameterRoom& room) {
  Ui& ui = room.ui;
  follow(room);
  const VariationRows& rows = room.parameters.variations;
  ImGui::Dummy({0, ui.theme.space(2)});
  ImGui::PushFont(ui.theme.strong);
  ImGui::TextUnformatted("Variations");
  ImGui::PopFont();
  if (!rows.error.empty()) {
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s. They are kept as they are.", rows.error.c_str());
    ImGui::PopTextWrapPos();
    return;
  }
  if (ImGui::Button("Take")) ui.requests.push(RunCommand{"variations.take"});
  ui.trace.item("variation/take");
  if (ImGui::IsItemHovered())
    tooltip(ui.theme,
            "Keeps the values of all parameters in the document, with what the viewport shows. A slider "
            "blends those "
            "that were taken.");
  drawSlider(room);
  for (std::size_t i = 0; i < rows.all.size(); ++i)
    if (drawRow(room, i)) return;
}

}  // namespace pileus::editor
