#include "editor/parameters/data_behind.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "editor/document/session.h"
#include "editor/parameters/parameter_room.h"
#include "editor/parameters/parameters.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"
#include "nodes/declare/value.h"

namespace pileus::editor {
namespace {

double numberOf(const ParamWidget& w, const std::string& id) {
  const nodes::Node* node = nodes::findNode(w.room.session.document.graph(), w.target.nodes.front());
  const nodes::NodeType* type = node ? nodes::findNodeType(node->type) : nullptr;
  const nodes::ParamSpec* spec = type ? type->param(id) : nullptr;
  if (!spec) return 0;
  const std::string name = w.room.session.document.scopedName(w.target.nodes.front());
  const nodes::SocketValue* linked = w.room.shown.preview.evaluator().input(name, id);
  if (const double* v = linked ? std::get_if<double>(linked) : nullptr) return *v;
  const nodes::ParamValue value = nodes::paramValue(*node, *spec, w.room.clock.frame);
  const double* number = std::get_if<double>(&value);
  return number ? *number : 0;
}

const volume::InstanceList* inputOf(const ParamWidget& w) {
  const nodes::SocketValue* value = w.room.shown.preview.evaluator().input(
      w.room.session.document.scopedName(w.target.nodes.front()), w.target.spec->data.input);
  const auto* volumes = value ? std::get_if<nodes::VolumeValue>(value) : nullptr;
  return volumes ? &volumes->items : nullptr;
}

}  // namespace

DataBehind dataBehind(const ParamWidget& w) {
  DataBehind data;
  const nodes::DataRange& range = w.target.spec->data;
  if (range.input.empty()) return {0, 1.0, nullptr};
  data.lowest = numberOf(w, range.lowest);
  const double highest = numberOf(w, range.highest);
  if (highest > 0) data.highest = highest;
  if (const volume::InstanceList* volumes = inputOf(w)) {
    data.histogram = histogramOf(w.room.parameters.densities, *volumes);
    double most = 0;
    for (const volume::Instance& i : *volumes) most = std::max(most, volume::largestDensity(i));
    if (!data.highest && most > 0) data.highest = most;
  }
  return data;
}

void drawHistogram(const ParamWidget& w, const DataBehind& data, ImVec2 lo, ImVec2 hi) {
  if (!data.histogram || !data.highest || *data.highest <= data.lowest) return;
  const int columns = std::max(1, static_cast<int>(hi.x - lo.x) / 2);
  std::vector<double> counts(static_cast<std::size_t>(columns));
  const double width = (*data.highest - data.lowest) / columns;
  for (int i = 0; i < columns; ++i) {
    const double from = data.lowest + i * width;
    // What lies beyond the range counts as its ends.
    counts[static_cast<std::size_t>(i)] = data.histogram->between(
        i == 0 ? 0 : from,
        i + 1 == columns ? std::max(data.histogram->highest, *data.highest) : from + width);
  }
  const double most = *std::max_element(counts.begin(), counts.end());
  if (!(most > 0)) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 color = faded(palette::kVolumeSocket, 0.38f);
  const float each = (hi.x - lo.x) / static_cast<float>(columns);
  int shown = 0;
  for (int i = 0; i < columns; ++i) {
    const double count = counts[static_cast<std::size_t>(i)];
    if (!(count > 0)) continue;
    const auto height =
        static_cast<float>(std::log1p(count) / std::log1p(most)) * (hi.y - lo.y - w.room.ui.theme.px(3));
    const float x = lo.x + each * static_cast<float>(i);
    draw->AddRectFilled({x, hi.y - height}, {x + each, hi.y}, color);
    ++shown;
  }
  w.room.ui.trace.note("histogram/" + w.target.spec->id, std::to_string(shown));
}

void drawRange(const ParamWidget& w, const DataBehind& data, float width) {
  const Theme& theme = w.room.ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const std::string left = fmt::format("{:.4g}", data.lowest);
  const std::string right =
      data.highest ? fmt::format("{:.4g}", *data.highest) : "largest " + w.target.spec->data.what;
  const std::string middle = w.target.spec->data.input.empty() ? "" : w.target.spec->data.what + " in";
  ImDrawList* draw = ImGui::GetWindowDrawList();
  drawText(draw, theme.small, {at.x, at.y}, palette::kTextFaint, left, 0.4f * width);
  const float end = textWidth(theme.small, right), half = 0.5f * textWidth(theme.small, middle);
  drawText(draw, theme.small, {at.x + width - end, at.y}, palette::kTextFaint, right, width);
  if (0.5f * width > half + end)
    drawText(draw, theme.small, {at.x + 0.5f * width - half, at.y}, palette::kTextFaint, middle, width);
  ImGui::Dummy({width, theme.small->FontSize});
  w.room.ui.trace.note("range/" + w.target.spec->id, left + " .. " + right);
}

void followField(const ParamWidget& w, const NumberEdit& edit) {
  if (edit.finished) endParamEdit(w.room.ui, w.room.session, w.room.parameters, w.target, edit.cancelled);
  Parameters& panel = w.room.parameters;
  if (edit.refused)
    panel.refusedKey = w.target.key(), panel.refusedAt = ImGui::GetTime();
  else if ((edit.changed || edit.finished) && panel.refusedKey == w.target.key())
    panel.refusedKey.clear();
}

template <class E>
std::optional<E> shapeField(const ParamWidget& w, E now, float width) {
  std::optional<E> chosen;
  std::string_view shown;
  for (const auto& item : enumInfo(static_cast<E*>(nullptr)))
    if (item.value == now) shown = item.label;
  const bool open = beginCombo(w.room.ui.theme, "##shape", shown, width);
  if (!open) w.room.ui.trace.item("shape/" + w.target.spec->id);
  if (!open) return chosen;
  for (const auto& item : enumInfo(static_cast<E*>(nullptr))) {
    if (ImGui::Selectable(std::string(item.label).c_str(), item.value == now)) chosen = item.value;
    w.room.ui.trace.item("choice/" + std::string(item.id));
    if (ImGui::IsItemHovered()) tooltip(w.room.ui.theme, item.help);
  }
  ImGui::EndCombo();
  return chosen;
}

template std::optional<nodes::CurveShape> shapeField(const ParamWidget&, nodes::CurveShape, float);
template std::optional<nodes::RampShape> shapeField(const ParamWidget&, nodes::RampShape, float);

}  // namespace pileus::editor
