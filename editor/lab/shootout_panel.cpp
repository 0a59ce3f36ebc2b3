#include "editor/lab/shootout_panel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "editor/document/session.h"
#include "editor/lab/lab.h"
#include "editor/lab/lab_room.h"
#include "editor/picture/shown.h"
#include "editor/time/clock.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/run_row.h"
#include "editor/toolkit/segments.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "renderer/truth/compare.h"

namespace pileus::editor {
namespace {

constexpr int kFirstSlot = 16;  // of the display's textures: two per entry

struct Column {
  const char* name;
  float width;  ///< design pixels
  double (*value)(const truth::ShootoutEntry&);
  std::string (*text)(double);
};

std::string small(double v) {
  return v == 0 ? "0" : v < 1e-3 ? fmt::format("{:.1e}", v) : fmt::format("{:.4f}", v);
}
std::string plain(double v) {
  return v >= 100 ? fmt::format("{:.0f}", v) : v >= 10 ? fmt::format("{:.1f}", v) : fmt::format("{:.2f}", v);
}

double lookups(const truth::ShootoutEntry& e) {
  double ns = 0;
  for (const truth::ShadowMeasure& m : e.lights) ns += m.nsPerLookup;
  return ns / static_cast<double>(std::max<std::size_t>(e.lights.size(), 1));
}

constexpr int kNameColumn = 1;
const Column kColumns[] = {
    {"", 60, nullptr, nullptr},
    {"Representation", 250, nullptr, nullptr},
    {"mean |\xce\x94T|", 84, [](const truth::ShootoutEntry& e) { return e.worst().error.mean; }, small},
    {"95 %", 76, [](const truth::ShootoutEntry& e) { return e.worst().error.p95; }, small},
    {"max", 76, [](const truth::ShootoutEntry& e) { return e.worst().error.maximum; }, small},
    {"relMSE", 78, [](const truth::ShootoutEntry& e) { return e.relMse; }, small},
    {"build ms", 78, [](const truth::ShootoutEntry& e) { return e.buildMs(); }, plain},
    {"ns/lookup", 82, lookups, plain},
    {"bytes/texel", 90, [](const truth::ShootoutEntry& e) { return e.worst().bytesPerTexel; }, plain},
    {"MiB", 70, [](const truth::ShootoutEntry& e) { return static_cast<double>(e.bytes()) / (1 << 20); },
     plain},
};

/// Without a texture where memory is out.
gl::Texture upload(ivec2 size, const std::vector<float>& rgba) {
  auto made = gl::Texture::create(GL_TEXTURE_2D, GL_RGBA32F, ivec3(size, 1), "shoot-out picture");
  if (!made) return {};
  gl::Texture t = std::move(*made);
  glTextureSubImage2D(t.id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, rgba.data());
  t.filter(GL_LINEAR);
  return t;
}

/// Full colour at a quarter of the truth's 99th percentile: the same for all.
double errorScale(const image::Image& truth) {
  std::vector<float> brightness;
  for (std::size_t i = 0; i + 3 < truth.layers[0].pixels.size(); i += 4)
    brightness.push_back(truth.layers[0].pixels[i + 1]);
  if (brightness.empty()) return 1;
  const auto at =
      brightness.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(brightness.size() - 1));
  std::nth_element(brightness.begin(), at, brightness.end());
  return std::max(0.25 * static_cast<double>(*at), 1e-9);
}

void takePictures(ShootoutPanel& panel) {
  const std::vector<truth::ShootoutEntry>& entries = panel.run->entries();
  while (panel.pictures.size() < entries.size()) {
    const image::Image& own = entries[panel.pictures.size()].picture;
    const image::Image& truth = entries.front().picture;
    ShootoutPanel::Pictures& out = panel.pictures.emplace_back();
    if (own.layers.empty() || truth.layers.empty()) continue;
    const std::vector<float>& a = own.layers[0].pixels;
    const std::vector<float>& b = truth.layers[0].pixels;
    const double scale = errorScale(truth);
    std::vector<float> error(a.size(), 1.0f);
    for (std::size_t i = 0; i + 3 < std::min(a.size(), b.size()); i += 4) {
      const double d = 0.2722287 * static_cast<double>(a[i] - b[i]) +
                       0.6740818 * static_cast<double>(a[i + 1] - b[i + 1]) +
                       0.0536895 * static_cast<double>(a[i + 2] - b[i + 2]);
      const vec3 c = truth::falseColour(d / scale);
      for (int k = 0; k < 3; ++k) error[i + static_cast<std::size_t>(k)] = c[k];
    }
    out.picture = upload(own.size, a);
    out.error = upload(own.size, error);
  }
}

ImTextureID textureId(unsigned texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

/// The picture through the viewport's display transform; small, so it is drawn anew each frame it is seen.
unsigned shown(const Session& session, const Clock& clock, Shown& shown, const Lab& lab, std::size_t entry,
               ivec2 size, int offset) {
  const gl::Texture& picture = lab.shootout.pictures[entry].picture;
  if (!picture || !shown.displayed.colors) return 0;
  const auto texture = shown.displayed.display.draw(
      picture, ivec2(picture.size()), size, *shown.displayed.colors, displaySettings(session, clock, shown),
      kFirstSlot + 2 * static_cast<int>(entry) + offset);
  return texture ? *texture : 0;
}

void drawLarge(const LabRoom& room, const truth::ShootoutEntry& e, std::size_t index) {
  const Theme& theme = room.ui.theme;
  const ShootoutPanel::Pictures& p = room.lab.shootout.pictures[index];
  if (!p.picture) return;
  const ivec2 size = ivec2(p.picture.size());
  const ImVec2 box(static_cast<float>(size.x), static_cast<float>(size.y));
  ImGui::BeginTooltip();
  ImGui::PushFont(theme.strong);
  ImGui::TextUnformatted(e.name.c_str());
  ImGui::PopFont();
  if (const unsigned t = shown(room.session, room.clock, room.shown, room.lab, index, size, 1))
    ImGui::Image(textureId(t), box);
  if (e.group != truth::ShootoutGroup::Truth) {
    ImGui::SameLine();
    ImGui::Image(textureId(p.error.id()), box);
  }
  ImGui::PushFont(theme.small);
  for (const truth::ShadowMeasure& m : e.lights)
    ImGui::TextDisabled("%s", fmt::format("{}{}, {} texels: mean {}, 95 % {}, max {}",
                                          e.lights.size() > 1 ? fmt::format("Light {}: ", m.light + 1) : "",
                                          shadow::describe(m.spec), shadow::resolutionOf(m.spec),
                                          small(m.error.mean), small(m.error.p95), small(m.error.maximum))
                                  .c_str());
  ImGui::PopFont();
  ImGui::EndTooltip();
}

/// Entries in the order of the table: the truth first.
std::vector<std::size_t> orderOf(const ShootoutPanel& panel) {
  const std::vector<truth::ShootoutEntry>& entries = panel.run->entries();
  const truth::ShootoutGroup wanted = panel.show == ShootoutShow::Defaults
                                          ? truth::ShootoutGroup::Defaults
                                          : truth::ShootoutGroup::EqualMemory;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < std::min(entries.size(), panel.pictures.size()); ++i)
    if (entries[i].group == wanted) order.push_back(i);
  const Column& column = kColumns[static_cast<std::size_t>(
      std::clamp(panel.column, 0, static_cast<int>(std::size(kColumns)) - 1))];
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto less = [&](std::size_t x, std::size_t y) {
      return column.value ? column.value(entries[x]) < column.value(entries[y])
                          : panel.column == kNameColumn && x < y;
    };
    return panel.descending ? less(b, a) : less(a, b);
  });
  if (!entries.empty() && entries.front().group == truth::ShootoutGroup::Truth && !panel.pictures.empty())
    order.insert(order.begin(), 0);
  return order;
}

void drawCells(const LabRoom& room, const truth::ShootoutEntry& e, std::size_t index, float height,
               const std::vector<double>& best) {
  const Theme& theme = room.ui.theme;
  const bool truth = e.group == truth::ShootoutGroup::Truth;
  ImGui::TableNextColumn();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float aspect =
      room.lab.shootout.pictures[index].picture
          ? static_cast<float>(e.picture.size.x) / static_cast<float>(std::max(e.picture.size.y, 1))
          : 1.78f;
  const vec2 thumb(std::min(height * aspect, theme.px(58)), height);
  if (const unsigned t = shown(room.session, room.clock, room.shown, room.lab, index, ivec2(thumb), 0))
    ImGui::GetWindowDrawList()->AddImage(textureId(t), at, {at.x + thumb.x, at.y + thumb.y});
  ImGui::Dummy(im(thumb));
  const float down = 0.5f * (height - theme.body->FontSize);
  ImGui::TableNextColumn();
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + down);
  ImGui::PushStyleColor(ImGuiCol_Text, truth ? palette::kTextDim : palette::kText);
  ImGui::TextUnformatted(e.name.c_str());
  ImGui::PopStyleColor();
  for (std::size_t c = kNameColumn + 1; c < std::size(kColumns); ++c) {
    ImGui::TableNextColumn();
    const double value = kColumns[c].value(e);
    if (truth) continue;
    const std::string text = kColumns[c].text(value);
    const float w = textWidth(theme.body, text), space = ImGui::GetContentRegionAvail().x;
    const ImVec2 cell = ImGui::GetCursorScreenPos();
    drawText(ImGui::GetWindowDrawList(), theme.body, {cell.x + space - w, cell.y + down},
             !truth && value <= best[c] ? palette::kGood : palette::kText, text, w + 1);
  }
}

void drawTable(const LabRoom& room, vec2 lo, vec2 hi) {
  const Theme& theme = room.ui.theme;
  ShootoutPanel& panel = room.lab.shootout;
  ImGui::SetCursorScreenPos(im(lo));
  const ImGuiTableFlags flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_BordersInnerH |
                                ImGuiTableFlags_PadOuterX;
  ImGui::PushStyleColor(ImGuiCol_TableHeaderBg, palette::kBar);
  ImGui::PushStyleColor(ImGuiCol_TableBorderStrong, palette::kLine);
  const bool open = ImGui::BeginTable("shootout", static_cast<int>(std::size(kColumns)), flags, im(hi - lo));
  ImGui::PopStyleColor(2);
  if (!open) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (std::size_t c = 0; c < std::size(kColumns); ++c) {
    const Column& column = kColumns[c];
    ImGuiTableColumnFlags f = c == 0 ? ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_NoSort
                                     : ImGuiTableColumnFlags_WidthStretch;
    if (c == 2) f |= ImGuiTableColumnFlags_DefaultSort;
    ImGui::TableSetupColumn(column.name, f, c == 0 ? theme.px(column.width) : column.width);
  }
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (int c = 0; c < static_cast<int>(std::size(kColumns)); ++c) {
    ImGui::TableSetColumnIndex(c);
    ImGui::PushID(c);
    // Over figures names stand at the right, as they do.
    const std::string name = kColumns[static_cast<std::size_t>(c)].name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float space = ImGui::GetContentRegionAvail().x - (c == panel.column ? theme.px(18) : 0),
                w = textWidth(theme.small, name);
    ImGui::TableHeader("##header");
    room.ui.trace.item(fmt::format("shootout/column/{}", c));
    drawText(ImGui::GetWindowDrawList(), theme.small,
             {c > kNameColumn ? at.x + std::max(space - w, 0.0f) : at.x,
              at.y + 0.5f * (theme.body->FontSize - theme.small->FontSize)},
             c == panel.column ? palette::kText : palette::kTextDim, name, w + 1);
    ImGui::PopID();
  }
  if (ImGuiTableSortSpecs* sort = ImGui::TableGetSortSpecs(); sort && sort->SpecsDirty) {
    if (sort->SpecsCount > 0)
      panel.column = sort->Specs[0].ColumnIndex,
      panel.descending = sort->Specs[0].SortDirection == ImGuiSortDirection_Descending;
    sort->SpecsDirty = false;
  }
  const std::vector<truth::ShootoutEntry>& entries = panel.run->entries();
  const std::vector<std::size_t> order = orderOf(panel);
  std::vector<double> best(std::size(kColumns), std::numeric_limits<double>::infinity());
  for (const std::size_t i : order)
    for (std::size_t c = kNameColumn + 1; c < std::size(kColumns); ++c)
      if (entries[i].group != truth::ShootoutGroup::Truth)
        best[c] = std::min(best[c], kColumns[c].value(entries[i]));
  const float height = theme.px(32);
  std::string names;
  for (const std::size_t i : order) {
    ImGui::TableNextRow(0, height);
    const float top = ImGui::GetCursorScreenPos().y;
    drawCells(room, entries[i], i, height, best);
    names += entries[i].name + "\n";
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsWindowHovered() && mouse.y >= top && mouse.y < top + height + theme.px(6) &&
        mouse.x > lo.x && mouse.x < lo.x + theme.px(330))
      drawLarge(room, entries[i], i);
    room.ui.trace.rect(fmt::format("shootout/row/{}", entries[i].name), {lo.x, top}, {hi.x, top + height});
  }
  room.ui.trace.note("shootout rows", names);
  ImGui::EndTable();
}

bool ready(const Shown& shown) {
  const auto& picture = shown.preview.picture();
  return picture && picture->scene && !shown.preview.draft();
}

}  // namespace

void startShootout(const Shown& shown, Lab& lab) {
  if (!ready(shown)) return;
  ShootoutPanel& panel = lab.shootout;
  panel.scene = shown.preview.picture()->scene;
  panel.error.clear();
  panel.pictures.clear();
  panel.fraction = 0;
  truth::ShootoutOptions options;
  const vec2 size(panel.scene->options.size);
  options.size = glm::max(ivec2(glm::round(size * (320 / size.x))), ivec2(8));
  options.points.count = 8000;
  options.truth = panel.truth;
  if (shown.renderer.device().software) options.resolution = 256;
  panel.run = std::make_unique<truth::Shootout>(*panel.scene, options);
  panel.running = true;
}

void stopShootout(Lab& lab) { lab.shootout.running = false; }

void stepShootout(Ui& ui, const Shown& shown, Lab& lab, double ms) {
  ShootoutPanel& panel = lab.shootout;
  const Result<double> done = panel.run->step(shown.renderer.gpu(), ms);
  if (!done) {
    panel.running = false;
    panel.error = done.error().message;
    ui.messages.error("Shoot-out: " + panel.error);
    return;
  }
  panel.fraction = *done;
  takePictures(panel);
  if (*done >= 1) {
    panel.running = false;
    ui.messages.info(fmt::format("Shoot-out complete: {} points in the media.", panel.run->pointCount()));
  }
}

void drawShootout(const LabRoom& room, float right, vec2 lo, vec2 hi) {
  const Theme& theme = room.ui.theme;
  ShootoutPanel& panel = room.lab.shootout;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  segments(room.ui, "shootout/show", panel.show);
  ImGui::SameLine(0, theme.space(3));
  segments(room.ui, "shootout/truth", panel.truth);
  ImGui::SameLine(0, theme.space(4));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const RunClick click =
      runRow(room.ui, "shootout", "Run", panel.running, ready(room.shown), !room.shown.preview.settled(),
             panel.fraction, panel.run ? panel.run->doing() : "", right - at.x - theme.space(2));
  if (click == RunClick::Start) startShootout(room.shown, room.lab);
  if (click == RunClick::Stop) stopShootout(room.lab);
  const auto& picture = room.shown.preview.picture();
  std::string note = panel.error;
  if (note.empty() && panel.run && !panel.running && picture && picture->scene != panel.scene)
    note = "Measured on an earlier state of the scene.";
  if (!panel.running && !note.empty())
    drawText(draw, theme.small,
             {at.x + theme.px(84) + theme.space(3),
              at.y + 0.5f * (ImGui::GetFrameHeight() - theme.small->FontSize)},
             panel.error.empty() ? palette::kTextDim : palette::kError, note,
             std::max(right - at.x - theme.px(100), 1.0f));
  room.ui.trace.note("shootout note", note);
  if (!panel.run)
    drawText(draw, theme.body, {lo.x + theme.space(3), lo.y + theme.space(2)}, palette::kTextDim,
             "Builds every shadow representation for this picture's lights, and measures error against exact "
             "transmittance, time and memory.",
             hi.x - lo.x - theme.space(6));
  if (panel.run && !panel.pictures.empty())
    drawTable(room, {lo.x + theme.space(2), lo.y}, hi - vec2(theme.space(2), theme.space(1)));
}

}  // namespace pileus::editor
