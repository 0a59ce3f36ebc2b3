#include "editor/start/preset_gallery.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/document/preset_shelf.h"
#include "editor/preferences/settings.h"
#include "editor/start/start_room.h"
#include "editor/start/start_view.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/widgets.h"

namespace pileus::editor {

void heading(const Theme& theme, const char* text) {
  ImGui::PushFont(theme.strong);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
  ImGui::Dummy({0, theme.px(2)});
}

/// A picture with rounded corners, cut to fill its place; a cloud where there is none.
void drawPicture(const Theme& theme, const GraphPictures::Shown& shown, ImVec2 lo, ImVec2 hi, bool grey) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float r = theme.px(4);
  draw->AddRectFilled(lo, hi, palette::kPictureEmpty, r);
  if (shown.texture == 0 || grey) {
    ImFont* font = theme.body;
    const float width = textWidth(font, icon::kPicture);
    drawText(draw, font, {0.5f * (lo.x + hi.x - width), 0.5f * (lo.y + hi.y - font->FontSize)},
             palette::kTextFaint, icon::kPicture, 100);
    return;
  }
  const float place = (hi.x - lo.x) / (hi.y - lo.y), own = float(shown.size.x) / float(shown.size.y);
  ImVec2 a(0, 0), b(1, 1);
  if (own > place)
    a.x = 0.5f - 0.5f * place / own, b.x = 1 - a.x;
  else
    a.y = 0.5f - 0.5f * own / place, b.y = 1 - a.y;
  draw->AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(shown.texture)), lo, hi, a,
                        b, IM_COL32_WHITE, r);
}

namespace {

/// A preset as the gallery shows it.
struct Card {
  std::string_view id, name, about;
  const nodes::PresetEntry* own = nullptr;
  const char* shipped = nullptr;
};

std::string badgeOf(const nodes::PresetEntry& e) {
  if (e.kind == nodes::PresetKind::Nodes) return e.nodes == 1 ? "1 node" : fmt::format("{} nodes", e.nodes);
  if (e.kind != nodes::PresetKind::Parameters) return {};
  const nodes::NodeType* type = nodes::findNodeType(e.type);
  return type ? type->label : e.type;
}

/// What can be done with one of one's own.
void drawCardMenu(Ui& ui, const nodes::PresetEntry& e, Choice& choice) {
  using How = ChangePreset::How;
  if (!ImGui::BeginPopup("card")) return;
  const auto row = [&](const char* mark, const char* label, const char* trace, bool enabled = true) {
    const bool chosen = ImGui::MenuItem(fmt::format("{}  {}", mark, label).c_str(), nullptr, false, enabled);
    ui.trace.item(std::string("gallery/menu/") + trace);
    return chosen;
  };
  const bool scene = e.kind == nodes::PresetKind::Document;
  if (row(icon::kFolderOpen, scene ? "Open" : "Add to the graph", "use", e.fault.empty()))
    choice = UsePreset{e.file, {}, {}};
  if (row(icon::kPencil, "Rename and describe\xe2\x80\xa6", "describe", e.writable && e.fault.empty()))
    ui.requests.push(ChangePreset{e.file, How::Describe});
  if (row(icon::kTrash, "Delete", "delete", e.writable)) ui.requests.push(ChangePreset{e.file, How::Delete});
  if (row(icon::kFolder, "Show in folder", "reveal")) ui.requests.push(ChangePreset{e.file, How::Reveal});
  if (!e.writable) ImGui::TextDisabled("This preset is read-only.");
  ImGui::EndPopup();
}

/// A word over a corner of the picture.
void drawBadge(const Theme& theme, ImVec2 at, const std::string& text, float room) {
  const float pad = theme.px(6), width = std::min(textWidth(theme.small, text), room - 4 * pad) + 2 * pad;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, {at.x + width, at.y + theme.small->FontSize + theme.px(6)}, IM_COL32(0, 0, 0, 170),
                      theme.px(4));
  drawText(draw, theme.small, {at.x + pad, at.y + theme.px(3)}, IM_COL32(235, 235, 235, 255), text,
           width - 2 * pad + 1);
}

void drawCard(const StartRoom& room, const Card& card, float width, Choice& choice) {
  Ui& ui = room.ui;
  const Theme& theme = ui.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float picture = std::round(width * 9 / 16), pad = theme.px(4), height = picture + theme.px(50);
  ImGui::PushID(card.id.data(), card.id.data() + card.id.size());
  const bool broken = card.own && !card.own->fault.empty();
  if (ImGui::InvisibleButton("preset", {width, height}) && !broken)
    choice = card.own ? Request(UsePreset{card.own->file, {}, {}}) : Request(OpenPreset{card.shipped});
  const bool visible = ImGui::IsItemVisible(), hovered = ImGui::IsItemHovered();
  ui.trace.item(fmt::format("start/preset/{}", card.id));
  if (card.own && hovered && ImGui::IsMouseClicked(1)) ImGui::OpenPopup("card");
  if (visible) {
    ImDrawList* draw = ImGui::GetWindowDrawList();
    drawPicture(
        theme,
        card.own ? room.pictures.beside(card.own->file, card.own->stamp) : room.pictures.preset(card.shipped),
        at, {at.x + width, at.y + picture}, broken);
    if (hovered)
      draw->AddRect({at.x - pad / 2, at.y - pad / 2}, {at.x + width + pad / 2, at.y + picture + pad / 2},
                    palette::kAccent, theme.px(5), 0, theme.px(2));
    if (card.own)
      if (const std::string badge = badgeOf(*card.own); !badge.empty() && !broken)
        drawBadge(theme, {at.x + theme.px(6), at.y + theme.px(6)}, badge, width);
    drawText(draw, theme.body, {at.x, at.y + picture + theme.px(6)}, palette::kText, card.name, width);
    drawText(draw, theme.small, {at.x, at.y + picture + theme.px(25)},
             broken ? palette::kWarning : palette::kTextDim, card.about, width);
    if (hovered && card.own)
      tooltip(theme, broken ? card.own->fault
                            : fmt::format("{}\n{}{}{}", card.own->name, card.own->about,
                                          card.own->about.empty() ? "" : "\n",
                                          nodes::presetTagList(card.own->tags)));
  }
  if (card.own) drawCardMenu(ui, *card.own, choice);
  ImGui::PopID();
}

void drawCards(const StartRoom& room, const std::vector<Card>& cards, Choice& choice) {
  const Theme& theme = room.ui.theme;
  const float space = ImGui::GetContentRegionAvail().x - theme.space(4), gap = theme.space(4);
  const int columns = std::clamp(static_cast<int>(space / theme.px(210)), 1, 4);
  const float width =
      std::floor((space - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, theme.space(2)});
  ImGui::Dummy({0, theme.px(1)});
  ImGui::Indent(theme.px(2));
  int i = 0;
  for (const Card& card : cards) {
    if (i++ % columns != 0) ImGui::SameLine();
    drawCard(room, card, width, choice);
  }
  ImGui::Unindent(theme.px(2));
  ImGui::PopStyleVar();
}

/// The folders whose presets are shown, beside one's own.
void drawFolders(const StartRoom& room) {
  Ui& ui = room.ui;
  if (ImGui::Button(fmt::format("{}  Folders", icon::kFolder).c_str())) ImGui::OpenPopup("folders");
  ui.trace.item("gallery/folders");
  if (!ImGui::BeginPopup("folders")) return;
  std::vector<std::string>& folders = room.settings.presetFolders;
  ImGui::TextDisabled("Presets are shown from your own folder and from these:");
  int gone = -1;
  for (int i = 0; i < static_cast<int>(folders.size()); ++i) {
    ImGui::PushID(i);
    if (ImGui::SmallButton(icon::kTimes)) gone = i;
    ui.trace.item(fmt::format("gallery/folder/{}/remove", i));
    if (ImGui::IsItemHovered()) tooltip(ui.theme, "Shows them no longer. Nothing is deleted.");
    ImGui::SameLine();
    ImGui::TextUnformatted(folders[static_cast<std::size_t>(i)].c_str());
    ImGui::PopID();
  }
  if (folders.empty()) ImGui::TextUnformatted("None yet.");
  ImGui::Separator();
  commandMenuItem(ui, "presets.add_folder");
  commandMenuItem(ui, "presets.reveal");
  ImGui::EndPopup();
  if (gone < 0) return;
  folders.erase(folders.begin() + gone);
  room.presets.refresh(presetFolders(room.settings));
}

/// The tags there are; one of them may be chosen.
void drawTags(const StartRoom& room, const std::vector<std::string>& tags) {
  Ui& ui = room.ui;
  const Theme& theme = ui.theme;
  std::string& chosen = room.start.tag;
  if (!chosen.empty() && std::find(tags.begin(), tags.end(), chosen) == tags.end()) chosen.clear();
  const float height = theme.small->FontSize + theme.px(6), pad = theme.px(8);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (const std::string& tag : tags) {
    const float width = textWidth(theme.small, tag) + 2 * pad;
    if (!first) ImGui::SameLine(0, theme.px(4));
    if (!first && ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
    first = false;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(tag.c_str(), {width, height})) chosen = chosen == tag ? "" : tag;
    ui.trace.item("gallery/tag/" + tag);
    const bool on = chosen == tag, over = ImGui::IsItemHovered();
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled(at, {at.x + width, at.y + height},
                        on     ? palette::kAccentDim
                        : over ? palette::kButtonHover
                               : palette::kButton,
                        0.5f * height);
    drawText(draw, theme.small, {at.x + pad, at.y + theme.px(3)},
             on ? palette::kTextStrong : palette::kTextDim, tag, width);
  }
}

bool hasTag(const std::vector<std::string>& tags, std::string_view tag) {
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

}  // namespace

void drawGallery(const StartRoom& room, Choice& choice) {
  Ui& ui = room.ui;
  const Theme& theme = ui.theme;
  StartView& start = room.start;
  heading(theme, "Begin with a scene");
  const float folders = textWidth(theme.body, std::string(icon::kFolder) + "  Folders") + theme.space(6);
  ImGui::SetNextItemWidth(std::max(theme.px(120), ImGui::GetContentRegionAvail().x - folders));
  ImGui::InputTextWithHint("##gallery", "Search presets by name, sentence and tag", &start.query);
  ui.trace.item("gallery/search");
  ImGui::SameLine();
  drawFolders(room);
  std::vector<std::string> tags = room.presets.tags();
  std::vector<Card> shipped, own, broken;
  for (const PresetText& p : galleryTexts()) {
    const std::vector<std::string> these = nodes::presetTags(p.tags);
    for (const std::string& tag : these)
      if (!hasTag(tags, tag)) tags.push_back(tag);
    if ((start.tag.empty() || hasTag(these, start.tag)) &&
        presetFits(fmt::format("{} {} {}", p.name, p.about, p.tags), start.query))
      shipped.push_back({p.file, p.name, p.about, nullptr, p.file});
  }
  std::sort(tags.begin(), tags.end());
  for (const nodes::PresetEntry& e : room.presets.entries()) {
    if (!e.fault.empty())
      broken.push_back({e.file.native(), e.name, "cannot be read", &e, nullptr});
    else if ((start.tag.empty() || hasTag(e.tags, start.tag)) && presetFits(e, start.query))
      own.push_back({e.file.native(), e.name, e.about, &e, nullptr});
  }
  drawTags(room, tags);
  ImGui::Dummy({0, theme.px(2)});
  ImGui::BeginChild("gallery");
  if (!own.empty()) {
    heading(theme, "Mine");
    drawCards(room, own, choice);
    ImGui::Dummy({0, theme.space(2)});
    if (!shipped.empty()) heading(theme, "Shipped with Pileus");
  }
  drawCards(room, shipped, choice);
  if (!broken.empty() && start.query.empty() && start.tag.empty()) {
    heading(theme, "Damaged");
    drawCards(room, broken, choice);
  }
  if (own.empty() && shipped.empty()) ImGui::TextDisabled("No preset has these words.");
  ImGui::EndChild();
}

}  // namespace pileus::editor
