#include "editor/start/start_view.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "editor/document/crash_log.h"
#include "editor/document/graph_pictures.h"
#include "editor/preferences/settings.h"
#include "editor/start/preset_gallery.h"
#include "editor/start/start_room.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "renderer/base/child_process.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr float kLeft = 292, kWidth = 1060, kHeight = 680;  // design pixels

std::string ago(std::int64_t time) {
  const auto now =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
          .count();
  const std::int64_t seconds = std::max<std::int64_t>(0, now - time);
  if (seconds < 90) return "a moment ago";
  if (seconds < 5400) return fmt::format("{} minutes ago", (seconds + 30) / 60);
  if (seconds < 129600) return fmt::format("{} hours ago", (seconds + 1800) / 3600);
  return fmt::format("{} days ago", (seconds + 43200) / 86400);
}

std::string nameOf(const Lost& lost) {
  return lost.original.empty() ? "an unnamed document" : lost.original.filename().string();
}

bool wideButton(Ui& ui, const char* icon, const char* label, const char* trace, bool primary = false) {
  const Theme& theme = ui.theme;
  if (primary) {
    ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::kAccentHover);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0, 0.5f});
  const bool pressed = ImGui::Button(fmt::format("  {}   {}", icon, label).c_str(), {-1, theme.px(34)});
  ImGui::PopStyleVar();
  if (primary) ImGui::PopStyleColor(2);
  ui.trace.item(std::string("start/") + trace);
  return pressed;
}

void drawRecent(Ui& ui, const Settings& settings, GraphPictures& pictures, const StartView& start,
                Choice& choice) {
  const Theme& theme = ui.theme;
  heading(theme, "Recent");
  if (settings.recentFiles.empty()) {
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("What you save or open appears here.");
    ImGui::PopTextWrapPos();
    return;
  }
  int row = 0;
  for (const std::string& file : settings.recentFiles) {
    const auto& missing = start.found.missing;
    const bool gone = std::find(missing.begin(), missing.end(), file) != missing.end();
    const fs::path path = file;
    ImGui::PushID(row);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = theme.px(46), width = ImGui::GetContentRegionAvail().x;
    if (ImGui::InvisibleButton("recent", {width, height}) && !gone) choice = OpenFile{path};
    const bool hovered = ImGui::IsItemHovered();
    ui.trace.item(fmt::format("start/recent/{}", row));
    ImDrawList* draw = ImGui::GetWindowDrawList();
    if (hovered && !gone)
      draw->AddRectFilled(at, {at.x + width, at.y + height}, palette::kRowHover, theme.px(4));
    const float pad = theme.px(4), picture = theme.px(68);
    drawPicture(theme, gone ? GraphPictures::Shown{} : pictures.file(path), {at.x + pad, at.y + pad},
                {at.x + pad + picture, at.y + height - pad}, gone);
    const float x = at.x + picture + theme.space(4), room = at.x + width - x - pad;
    drawText(draw, theme.body, {x, at.y + theme.px(6)}, gone ? palette::kTextFaint : palette::kText,
             path.filename().string(), room);
    drawText(draw, theme.small, {x, at.y + theme.px(25)}, palette::kTextFaint,
             gone ? "is not there any more" : path.parent_path().string(), room);
    if (hovered) ImGui::SetTooltip("%s", file.c_str());
    ImGui::PopID();
    ++row;
  }
}

void drawLeft(Ui& ui, Settings& settings, GraphPictures& pictures, const StartView& start, Choice& choice) {
  const Theme& theme = ui.theme;
  ImGui::PushFont(theme.title);
  ImGui::TextUnformatted("Pileus");
  ImGui::PopFont();
  ImGui::TextDisabled("Light in clouds and smoke");
  ImGui::Dummy({0, theme.space(2)});
  if (wideButton(ui, icon::kFile, "New", "new")) choice = RunCommand{"file.new"};
  if (wideButton(ui, icon::kFolderOpen, "Open\xe2\x80\xa6", "open")) choice = RunCommand{"file.open"};
  if (wideButton(ui, icon::kCloud, "Import VDB\xe2\x80\xa6", "import"))
    choice = RunCommand{"file.import_vdb"};
  if (wideButton(ui, icon::kInfo, "Take the tour, four steps", "tour", !settings.tourSeen))
    choice = RunCommand{"help.tour"};
  ImGui::Dummy({0, theme.space(2)});
  const float footer =
      ImGui::GetFrameHeight() + theme.px(2) + 2 * ImGui::GetStyle().ItemSpacing.y + theme.px(2);
  ImGui::BeginChild("recent list", {0, std::max(theme.px(60), ImGui::GetContentRegionAvail().y - footer)});
  drawRecent(ui, settings, pictures, start, choice);
  ImGui::EndChild();
  ImGui::Dummy({0, theme.px(2)});
  ImGui::Checkbox("Show at start", &settings.showStart);
  ui.trace.item("start/show");
}

/// Unsaved work and crash reports, above everything else.
void drawNotices(Ui& ui, StartView& start, Choice& choice) {
  const Theme& theme = ui.theme;
  StartFindings& found = start.found;
  if (found.lost.empty() && found.crashes.empty()) return;
  const float row = ImGui::GetFrameHeight() + theme.space(2);
  const std::size_t shown = std::min<std::size_t>(found.lost.size(), 3);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kWarningBack);
  ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, theme.px(6));
  ImGui::BeginChild("notices",
                    {0, row * static_cast<float>(shown + (found.crashes.empty() ? 0u : 1u)) + theme.space(4)},
                    true, ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
  int erase = -1;
  for (std::size_t i = 0; i < shown; ++i) {
    const Lost& lost = found.lost[i];
    const std::string name = nameOf(lost);
    ImGui::PushID(static_cast<int>(i));
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s  Unsaved work of %s, %s", icon::kWarning, name.c_str(), ago(lost.time).c_str());
    ui.trace.note("start/lost", name);
    const float button = theme.px(96), right = ImGui::GetWindowContentRegionMax().x - 2 * theme.space(2);
    ImGui::SameLine(right - button * 3.2f);
    if (ImGui::Button("Open", {button, 0})) choice = OpenLost{std::make_shared<Lost>(lost)};
    ui.trace.item(fmt::format("start/lost/{}/open", i));
    ImGui::SameLine();
    if (ImGui::Button("Show in folder", {button * 1.2f, 0})) showInFolder(ui, lost.file);
    ui.trace.item(fmt::format("start/lost/{}/folder", i));
    ImGui::SameLine();
    if (ImGui::Button("Discard", {button, 0})) erase = static_cast<int>(i);
    ui.trace.item(fmt::format("start/lost/{}/discard", i));
    ImGui::PopID();
  }
  if (!found.crashes.empty()) {
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%s  Pileus ended unexpectedly. A report was written: %s", icon::kInfo,
                found.crashes.front().filename().c_str());
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - 2 * theme.space(2) - theme.px(116));
    if (ImGui::Button("Show report", {theme.px(116), 0})) showInFolder(ui, found.crashes.front());
    ui.trace.item("start/crash");
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::Dummy({0, theme.space(1)});
  if (erase < 0) return;
  removeLost(found.lost[static_cast<std::size_t>(erase)]);
  found.lost.erase(found.lost.begin() + erase);
}

StartFindings look(const std::vector<std::string>& recent) {
  StartFindings out;
  out.lost = findLost();
  out.crashes = crash::takeNewReports();
  std::error_code ec;
  for (const std::string& file : recent)
    if (!fs::exists(file, ec)) out.missing.push_back(file);
  return out;
}

/// Over a file that was asked for nothing opens by itself.
void offerLost(Ui& ui, const std::vector<Lost>& lost) {
  const std::string more = lost.size() > 1 ? fmt::format(" and {} more", lost.size() - 1) : "";
  ui.messages.offer(fmt::format("Unsaved work of {}{}, {}, is kept. Help > Start View has it, too.",
                                nameOf(lost.front()), more, ago(lost.front().time)),
                    "Show", "help.start");
}

void takeFindings(Ui& ui, StartView& start) {
  if (!start.search || !start.search->done()) return;
  start.found = *start.search->result();
  start.search.reset();
  if (!start.found.lost.empty() && start.fileGiven)
    offerLost(ui, start.found.lost);
  else if (!start.found.lost.empty() && !start.open)
    openStart(start);
  for (const fs::path& report : start.found.crashes)
    ui.messages.warn("Pileus ended unexpectedly last time. A report was written: " + report.string());
}

}  // namespace

void showInFolder(Ui& ui, const fs::path& path) {
  const std::string folder = path.parent_path().string();
  (void)startDetached("xdg-open", {folder});
  ui.messages.info("In " + folder);
}

const std::vector<PresetText>& galleryTexts() {
  static const std::vector<PresetText> texts = {
      {"default.json", "Broken cumulus", "One cloud in another's shadow", "cloud, evening"},
      {"cumulus.json", "One cumulus", "Seen close, all orders of scattering", "cloud, morning"},
      {"dawn-cumulus.json", "Dawn", "Cumulus just after the sun has risen", "cloud, morning"},
      {"god-rays.json", "God rays", "A broken deck, haze, deep maps", "cloud, shafts"},
      {"anvil-at-sunset.json", "Anvil at sunset", "A storm of eleven kilometres", "cloud, storm, evening"},
      {"storm-front.json", "Storm front", "A shelf and the towers behind it", "cloud, storm"},
      {"sea-of-clouds.json", "Sea of clouds", "Stratocumulus from above, a low sun", "cloud, morning"},
      {"mares-tails.json", "Mares' tails", "Cirrus against the evening", "cloud, evening"},
      {"valley-fog.json", "Valley fog", "Ridges out of a bank of stratus", "fog, morning"},
      {"city-fog.json", "City fog", "Street lamps, a map for each", "fog, night, spot"},
      {"light-shafts.json", "Light shafts", "A spot light through a cloud", "shafts, spot"},
      {"two-lights.json", "Two lights", "Magenta and teal, a map for each", "spot, colour"},
      {"smoke-column.json", "Smoke column", "A tower of ash, late in the day", "smoke, evening"},
      {"ink-in-water.json", "Ink in water", "Absorption before a bright wall", "ink, colour"},
      {"nebula.json", "Nebula", "Three stars in coloured dust", "night, colour"},
      {"shadows-across-gaps.json", "Across gaps", "Four shapes in each other's shadow", "measure"},
      {"paper-figure-2.json", "The paper's figure 2", "Two media far apart, three maps", "measure"},
      {"paper-fourier.json", "As in the paper", "Fourier coefficients, 4 and 8", "measure"},
      {"compare-representations.json", "Four shadows", "One scene, four representations", "measure"},
  };
  return texts;
}

void beginStart(const Settings& settings, StartView& start, bool fileGiven) {
  start.search = std::make_unique<Job<StartFindings>>(
      [recent = settings.recentFiles](JobControl&) -> Result<StartFindings> { return look(recent); });
  start.fileGiven = fileGiven;
  if (!fileGiven && settings.showStart) openStart(start);
}

void openStart(StartView& start) { start.open = start.appearing = true; }

void drawStart(const StartRoom& room) {
  Ui& ui = room.ui;
  StartView& start = room.start;
  takeFindings(ui, start);
  if (!start.open || ui.modals.anyOpen() || ui.modals.browser.isOpen()) return;
  const Theme& theme = ui.theme;
  if (!ImGui::IsPopupOpen("Start")) ImGui::OpenPopup("Start");
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 size = {std::min(theme.px(kWidth), display.x - theme.space(10)),
                       std::min(theme.px(kHeight), display.y - theme.space(14))};
  ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(6), theme.space(5)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(10));
  const bool shown = ImGui::BeginPopupModal("Start", nullptr,
                                            ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar |
                                                ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar(2);
  if (!shown) return;
  ui.trace.rect("start", ImGui::GetWindowPos(),
                {ImGui::GetWindowPos().x + size.x, ImGui::GetWindowPos().y + size.y});
  Choice choice;
  drawNotices(ui, start, choice);
  ImGui::BeginChild("left", {theme.px(kLeft), 0});
  drawLeft(ui, room.settings, room.pictures, start, choice);
  ImGui::EndChild();
  ImGui::SameLine(0, theme.space(8));
  ImGui::BeginChild("right", {0, 0});
  drawGallery(room, choice);
  ImGui::EndChild();
  const ImVec2 lo = ImGui::GetWindowPos(), hi = {lo.x + size.x, lo.y + size.y};
  const bool beside = ImGui::IsMouseClicked(0) && !ImGui::IsMouseHoveringRect(lo, hi, false);
  const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (choice || (!start.appearing && (beside || escape))) {
    start.open = false;
    ImGui::CloseCurrentPopup();
  }
  start.appearing = false;
  ImGui::EndPopup();
  if (choice) ui.requests.push(std::move(*choice));
}

}  // namespace pileus::editor
