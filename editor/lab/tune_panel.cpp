#include "editor/lab/tune_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "editor/document/session.h"
#include "editor/lab/lab.h"
#include "editor/picture/shown.h"
#include "editor/picture/shown_camera.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/plot.h"
#include "editor/toolkit/run_row.h"
#include "editor/toolkit/segments.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {
namespace {

using truth::TuneBound;
using truth::TuneCandidate;

std::vector<nodes::ShadowGroup> groupsOf(const Session& session, const Shown& shown) {
  const auto& picture = shown.preview.picture();
  if (!picture || !picture->scene || shown.preview.draft()) return {};
  return nodes::shadowGroups(session.document.root(), cameraUser(session, shownView(session, shown)), 1,
                             *picture->scene);
}

std::string groupName(const nodes::ShadowGroup& group) {
  std::string out;
  for (const nodes::ShadowNodes& n : group.nodes) out += (out.empty() ? "" : ", ") + n.node;
  return out;
}

double mebibytes(const TuneCandidate& c) { return static_cast<double>(c.bytes) / (1 << 20); }

/// What the buttons act on: the dot that was clicked, else the best, else the nearest.
std::optional<TuneCandidate> candidate(const TunePanel& panel) {
  if (!panel.run) return std::nullopt;
  if (panel.chosen)
    for (const TuneCandidate& c : panel.run->measured())
      if (c.spec == *panel.chosen) return c;
  const auto best = panel.run->best();
  return best ? best : panel.run->nearest();
}

void chooseGoal(Ui& ui, Lab& lab, float width) {
  const Theme& theme = ui.theme;
  TunePanel& panel = lab.tune;
  constexpr const char* kNames[] = {"95 % of |\xce\x94T| below", "Time below", "Memory below"};
  constexpr const char* kUnits[] = {"", "ms", "MiB"};
  const auto at = static_cast<std::size_t>(panel.goal.bound);
  ImGui::BeginDisabled(panel.running);
  if (beginCombo(theme, "##bound", kNames[at], width * 0.58f)) {
    for (const auto& item : enumInfo(static_cast<TuneBound*>(nullptr))) {
      if (ImGui::Selectable(kNames[static_cast<std::size_t>(item.value)], item.value == panel.goal.bound))
        panel.goal.bound = item.value;
      ui.trace.item("tune/bound/" + std::string(item.id));
      if (ImGui::IsItemHovered()) tooltip(theme, item.help);
    }
    ImGui::EndCombo();
  }
  ui.trace.item("tune/bound");
  ImGui::SameLine();
  NumberField field;
  field.softMin = panel.goal.bound == TuneBound::P95 ? 0.001 : 0.1;
  field.softMax = panel.goal.bound == TuneBound::P95            ? 0.5
                  : panel.goal.bound == TuneBound::Milliseconds ? 1000
                                                                : 1024;
  field.hardMin = 1e-6, field.hardMax = 1e6;
  field.logarithmic = true;
  field.unit = kUnits[at];
  numberField(ui.fields.number, theme, "##limit", panel.limits[at], field, width * 0.42f - theme.space(2));
  ui.trace.item("tune/limit");
  ImGui::EndDisabled();
  panel.goal.limit = panel.limits[static_cast<std::size_t>(panel.goal.bound)];
}

void chooseGroup(Ui& ui, Lab& lab, const std::vector<nodes::ShadowGroup>& groups, float width) {
  TunePanel& panel = lab.tune;
  if (groups.size() < 2) {
    panel.group = 0;
    return;
  }
  panel.group = std::min(panel.group, groups.size() - 1);
  if (beginCombo(ui.theme, "##group", groupName(groups[panel.group]), width)) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (ImGui::Selectable(groupName(groups[i]).c_str(), i == panel.group)) panel.group = i;
    ImGui::EndCombo();
  }
  ui.trace.item("tune/group");
}

void writeChoice(Ui& ui, Session& session, const Lab& lab, const TuneCandidate& c) {
  const TunePanel& panel = lab.tune;
  if (tryEditRoot(session, ui.messages, nodes::writeGroup(session.document.root(), panel.tuned, c.spec),
                  "Tune shadows"))
    ui.messages.note("Written into " + groupName(panel.tuned) + ": " + shadow::describe(c.spec));
}

void drawCandidate(Ui& ui, Session& session, Lab& lab, vec2 at, float width) {
  const Theme& theme = ui.theme;
  TunePanel& panel = lab.tune;
  const auto c = candidate(panel);
  if (!c) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const bool met = truth::meets(*c, panel.goal);
  const std::string head = panel.chosen    ? "Chosen"
                           : panel.running ? "Best so far"
                           : met           ? "Best"
                                           : "Nearest: the bound cannot be met";
  drawText(draw, theme.small, at, met ? palette::kGood : palette::kWarning, head, width);
  at.y += theme.small->FontSize + theme.px(4);
  const std::string what =
      fmt::format("{}, {} texels", shadow::describe(c->spec), shadow::resolutionOf(c->spec));
  const ImVec2 size = theme.body->CalcTextSizeA(theme.body->FontSize, FLT_MAX, width, what.c_str());
  draw->AddText(theme.body, theme.body->FontSize, im(at), palette::kText, what.c_str(), nullptr, width);
  at.y += size.y + theme.px(4);
  const std::string figures = fmt::format("95 % {:.4f}   mean {:.4f}   {:.3g} MiB   {:.3g} ms", c->p95,
                                          c->mean, mebibytes(*c), c->ms());
  drawText(draw, theme.small, at, palette::kTextDim, figures, width);
  at.y += theme.small->FontSize + theme.space(2);
  ui.trace.note("tune head", head);
  ui.trace.note("tune what", what);
  ui.trace.note("tune figures", figures);
  ImGui::SetCursorScreenPos(im(at));
  if (ImGui::Button("Write into nodes", {theme.px(150), 0})) writeChoice(ui, session, lab, *c);
  ui.trace.item("tune/write");
  if (ImGui::IsItemHovered())
    tooltip(theme, "Sets these parameters in " + groupName(panel.tuned) + ", as one undo step");
  if (panel.chosen) {
    ImGui::SameLine();
    if (ImGui::Button("Back to best")) panel.chosen.reset();
    ui.trace.item("tune/best");
  }
}

std::string dotText(const TuneCandidate& c) {
  return fmt::format(
      "{}, {} texels\n95 % {:.4f}, mean {:.4f}, {:.3g} MiB\nbuild {:.3g} ms, {:.3g} ns a lookup",
      shadow::describe(c.spec), shadow::resolutionOf(c.spec), c.p95, c.mean, mebibytes(c), c.buildMs,
      c.nsPerLookup);
}

/// Ranges that hold all that was measured and the bound.
Plot plotOf(const Theme& theme, const Lab& lab, vec2 lo, vec2 hi, const std::vector<TuneCandidate>& all) {
  const truth::TuneGoal& goal = lab.tune.goal;
  Plot plot;
  plot.draw = ImGui::GetWindowDrawList();
  plot.theme = &theme;
  plot.lo = lo + vec2(theme.px(48), theme.px(20)), plot.hi = hi - vec2(theme.px(6), theme.px(22));
  plot.logX = plot.logY = true;
  dvec2 x(1e9, 1e-9), y(1e9, 1e-9);
  for (const TuneCandidate& c : all) {
    x = {std::min(x.x, mebibytes(c)), std::max(x.y, mebibytes(c))};
    y = {std::min(y.x, std::max(c.p95, 1e-5)), std::max(y.y, c.p95)};
  }
  if (goal.bound == TuneBound::P95) y = {std::min(y.x, goal.limit), std::max(y.y, goal.limit)};
  if (goal.bound == TuneBound::Mebibytes) x = {std::min(x.x, goal.limit), std::max(x.y, goal.limit)};
  plot.x = {x.x / 1.3, x.y * 1.3}, plot.y = {y.x / 1.4, y.y * 1.4};
  return plot;
}

void drawCurve(Ui& ui, Lab& lab, vec2 lo, vec2 hi) {
  const Theme& theme = ui.theme;
  TunePanel& panel = lab.tune;
  const std::vector<TuneCandidate>& all = panel.run->measured();
  if (all.empty() || hi.x - lo.x < theme.px(200) || hi.y - lo.y < theme.px(90)) return;
  const Plot plot = plotOf(ui.theme, lab, lo, hi, all);
  drawText(plot.draw, theme.small, {lo.x + theme.px(4), lo.y}, palette::kTextDim,
           "95 % of |\xce\x94T| over memory, log axes: every dot was built and measured", hi.x - lo.x);
  plotFrame(plot, AxisX::Labels, "MiB");
  const ImU32 goalColor = faded(palette::kGood, 0.7f);
  if (panel.goal.bound == TuneBound::P95) {
    const float y = plot.py(panel.goal.limit);
    plot.draw->AddRectFilled({plot.lo.x, y}, im(plot.hi), faded(palette::kGood, 0.05f));
    plot.draw->AddLine({plot.lo.x, y}, {plot.hi.x, y}, goalColor);
  }
  if (panel.goal.bound == TuneBound::Mebibytes) {
    const float x = plot.px(panel.goal.limit);
    plot.draw->AddRectFilled(im(plot.lo), {x, plot.hi.y}, faded(palette::kGood, 0.05f));
    plot.draw->AddLine({x, plot.lo.y}, {x, plot.hi.y}, goalColor);
  }
  std::vector<double> bytes, errors;
  for (const TuneCandidate& c : panel.run->curve())
    bytes.push_back(mebibytes(c)), errors.push_back(std::max(c.p95, 1e-5));
  plotLine(plot, bytes, errors, palette::kAccent, 1.6f * theme.scale);
  const auto shown = candidate(panel);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const TuneCandidate* near = nullptr;
  float nearest = theme.px(10);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const TuneCandidate& c = all[i];
    const vec2 at = plot.at(mebibytes(c), std::max(c.p95, 1e-5));
    const bool onCurve = std::find(bytes.begin(), bytes.end(), mebibytes(c)) != bytes.end() &&
                         std::find(errors.begin(), errors.end(), std::max(c.p95, 1e-5)) != errors.end();
    plotDot(plot, mebibytes(c), std::max(c.p95, 1e-5), onCurve ? palette::kAccent : palette::kTextFaint,
            theme.px(onCurve ? 4 : 3));
    ui.trace.rect(fmt::format("tune/dot/{}", i), im(at - theme.px(3)), im(at + theme.px(3)));
    const float distance = glm::length(vec(mouse) - at);
    if (plot.hovered() && distance < nearest) nearest = distance, near = &c;
  }
  if (shown) {
    const vec2 at = plot.at(mebibytes(*shown), std::max(shown->p95, 1e-5));
    plot.draw->AddCircleFilled(im(at), theme.px(5), palette::kSelect);
    plot.draw->AddCircle(im(at), theme.px(8), palette::kSelect, 0, 1.5f * theme.scale);
  }
  if (near) {
    plot.draw->AddCircle(im(plot.at(mebibytes(*near), std::max(near->p95, 1e-5))), theme.px(7),
                         palette::kText, 0, 1.5f * theme.scale);
    tooltip(theme, dotText(*near));
    if (ImGui::IsMouseClicked(0)) panel.chosen = near->spec;
  }
  ui.trace.rect("tune/curve", im(plot.lo), im(plot.hi));
  ui.trace.note("tune tried", std::to_string(all.size()));
}

}  // namespace

void startTune(const Session& session, const Shown& shown, Lab& lab) {
  TunePanel& panel = lab.tune;
  const std::vector<nodes::ShadowGroup> groups = groupsOf(session, shown);
  if (groups.empty()) return;
  panel.scene = shown.preview.picture()->scene;
  panel.tuned = groups[std::min(panel.group, groups.size() - 1)];
  panel.error.clear();
  panel.chosen.reset();
  panel.fraction = 0;
  truth::TuneOptions options;
  options.points.count = 6000;
  if (shown.renderer.device().software) options.maxResolution = 1024;
  panel.run = std::make_unique<truth::Tuner>(panel.tuned.casters, panel.tuned.nodes.front().spec, panel.goal,
                                             options);
  panel.running = true;
}

void stopTune(Lab& lab) { lab.tune.running = false; }

void stepTune(Ui& ui, const Shown& shown, Lab& lab, double ms) {
  TunePanel& panel = lab.tune;
  const Result<double> done = panel.run->step(shown.renderer.gpu(), ms);
  if (!done) {
    panel.running = false;
    panel.error = done.error().message;
    ui.messages.error("Tune: " + panel.error);
    return;
  }
  panel.fraction = *done;
  if (*done >= 1) panel.running = false;
}

void drawTune(Ui& ui, Session& session, const Shown& shown, Lab& lab, vec2 lo, vec2 hi) {
  const Theme& theme = ui.theme;
  TunePanel& panel = lab.tune;
  const std::vector<nodes::ShadowGroup> groups = groupsOf(session, shown);
  const float left = std::min(theme.px(360), 0.45f * (hi.x - lo.x)), width = left - theme.space(4);
  ImGui::SetCursorScreenPos({lo.x + theme.space(2), lo.y});
  ImGui::BeginGroup();
  chooseGroup(ui, lab, groups, width);
  chooseGoal(ui, lab, width);
  const RunClick click = runRow(ui, "tune", "Tune", panel.running, !groups.empty(), !shown.preview.settled(),
                                panel.fraction, panel.run ? panel.run->doing() : "", width);
  ImGui::EndGroup();
  const float below = ImGui::GetItemRectMax().y + theme.space(3);
  if (click == RunClick::Start) startTune(session, shown, lab);
  if (click == RunClick::Stop) stopTune(lab);
  std::string note = panel.error;
  if (note.empty() && !panel.run)
    note = groups.empty()
               ? (shown.preview.settled() ? "No light of this picture has a shadow map that could be tuned."
                                          : "Waits for the picture.")
               : "Searches the parameters of " + groupName(groups[std::min(panel.group, groups.size() - 1)]) +
                     " that keep the bound most cheaply.";
  if (!note.empty())
    ImGui::GetWindowDrawList()->AddText(theme.small, theme.small->FontSize, {lo.x + theme.space(2), below},
                                        panel.error.empty() ? palette::kTextDim : palette::kError,
                                        note.c_str(), nullptr, width);
  ui.trace.note("tune note", note);
  if (!panel.run) return;
  if (panel.error.empty()) drawCandidate(ui, session, lab, {lo.x + theme.space(2), below}, width);
  drawCurve(ui, lab, {lo.x + left, lo.y - theme.px(4)}, hi - vec2(theme.space(2), theme.space(1)));
}

}  // namespace pileus::editor
