// The parts of the file dialog: folder and filter, places, the list, the name, the buttons.
#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/preferences/settings.h"
#include "editor/toolkit/draw_text.h"
#include "editor/toolkit/file_browser.h"
#include "editor/toolkit/icons.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/window.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

std::string folderName(const std::string& folder) {
  const std::string name = fs::path(folder).filename().string();
  return name.empty() ? folder : name;
}

/// Columns of the list, from the right.
struct Columns {
  float size, date;  ///< right edges, from the list's left
};
Columns columns(const Theme& theme, float width) { return {width - theme.px(142), width}; }

/// Of the list: what is above and below it keeps its place in a low window too.
float listHeight(const Theme& theme) {
  return std::clamp(ImGui::GetIO().DisplaySize.y - theme.px(250), theme.px(60), theme.px(318));
}

}  // namespace

void FileBrowser::drawTop(Ui& ui, Settings& settings) {
  const Theme& theme = ui.theme;
  ImGui::PushFont(theme.title);
  ImGui::TextUnformatted(request_.title.c_str());
  ImGui::PopFont();
  if (ImGui::Button(icon::kArrowUp)) enter(folder_.parent_path());
  ui.trace.item("browser/up");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Folder above (Alt+Up)");
  ImGui::SameLine();
  std::vector<std::string>& marks = settings.folderBookmarks;
  const auto marked = std::find(marks.begin(), marks.end(), folder_.string());
  ImGui::PushStyleColor(ImGuiCol_Text, marked != marks.end() ? palette::kSelect : palette::kTextDim);
  if (ImGui::Button(icon::kBookmark)) {
    if (marked != marks.end())
      marks.erase(marked);
    else
      marks.push_back(folder_.string());
  }
  ImGui::PopStyleColor();
  ui.trace.item("browser/bookmark");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Keep this folder among the places, or remove it");
  ImGui::SameLine();
  if (request_.saving) {
    if (ImGui::Button(icon::kPlus)) newFolder_ = newFolder_ ? std::nullopt : std::optional<std::string>("");
    ui.trace.item("browser/new folder");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("New folder");
    ImGui::SameLine();
  }
  const float search = theme.px(190);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x - search - theme.space(3);
  editor::drawText(ImGui::GetWindowDrawList(), theme.body,
                   {at.x, at.y + 0.5f * (ImGui::GetFrameHeight() - theme.body->FontSize)}, palette::kTextDim,
                   endOfPath(theme.body, folder_.string(), room), room);
  if (textWidth(theme.body, folder_.string()) > room)
    noteCut(vec(at), {at.x + room, at.y + ImGui::GetFrameHeight()}, folder_.string());
  ImGui::SetCursorScreenPos({at.x + room + theme.space(3), at.y});
  ImGui::SetNextItemWidth(search);
  if (focusFilter_) ui.fields.focusHere();
  focusFilter_ = false;
  if (ImGui::InputTextWithHint("##filter", (std::string(icon::kSearch) + "  Filter (Ctrl+F)").c_str(),
                               &filter_))
    arrange();
  ui.trace.item("browser/filter");
}

/// A line for its name, which Enter makes and goes into.
void FileBrowser::drawNewFolder(Ui& ui) {
  if (!newFolder_) return;
  ImGui::SetNextItemWidth(-1);
  if (newFolder_->empty() && !ImGui::IsAnyItemActive()) ui.fields.focusHere();
  const bool enter = ImGui::InputTextWithHint("##new folder", "Name of the new folder; Enter makes it",
                                              &*newFolder_, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.trace.item("browser/new folder name");
  if (!enter || newFolder_->empty()) return;
  std::error_code ec;
  const fs::path made = folder_ / *newFolder_;
  fs::create_directory(made, ec);
  if (ec) return void(error_ = fmt::format("{} cannot be made: {}.", made.string(), ec.message()));
  newFolder_.reset();
  this->enter(made);
  focusName_ = true;
}

void FileBrowser::drawPlaces(Ui& ui, Settings& settings, const fs::path& document) {
  const Theme& theme = ui.theme;
  ImGui::BeginChild("places", {theme.px(166), listHeight(theme) + theme.px(22)}, false);
  const auto place = [&](const char* mark, const std::string& label, const fs::path& folder) {
    ImGui::PushID(folder.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable("##place", folder == folder_)) enter(folder);
    ui.trace.item("place/" + label);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", folder.c_str());
    editor::drawText(ImGui::GetWindowDrawList(), theme.body, {at.x + theme.px(2), at.y}, palette::kTextDim,
                     mark, width);
    editor::drawText(ImGui::GetWindowDrawList(), theme.body, {at.x + theme.px(26), at.y}, palette::kText,
                     label, width - theme.px(26));
    ImGui::PopID();
  };
  const auto section = [&](const char* title) {
    ImGui::Dummy({0, theme.space(1)});
    ImGui::PushFont(theme.small);
    ImGui::TextDisabled("%s", title);
    ImGui::PopFont();
    ImGui::PushID(title);
  };
  place(icon::kHome, "Home", expandedHome("~"));
  place(icon::kDesktop, "Computer", "/");
  if (!document.empty()) place(icon::kFile, "This document", fs::absolute(document));
  if (!settings.folderBookmarks.empty()) {
    section("Bookmarks");
    for (const std::string& f : std::vector<std::string>(settings.folderBookmarks))
      place(icon::kBookmark, folderName(f), f);
    ImGui::PopID();
  }
  if (!settings.recentFolders.empty()) {
    section("Recent");
    for (const std::string& f : settings.recentFolders) place(icon::kFolder, folderName(f), f);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

void FileBrowser::drawRow(Ui& ui, int row, float width) {
  const Theme& theme = ui.theme;
  const FileEntry& entry = entries_[static_cast<std::size_t>(row)];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(row);
  if (ImGui::Selectable("##row", row == row_,
                        ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
    select(row);
    // Folders open with one click, as they always did; files with two.
    if (entry.folder || ImGui::IsMouseDoubleClicked(0)) go_ = true;
  }
  ui.trace.item("entry/" + entry.name);
  ImGui::PopID();
  if (row == row_ && scrollToRow_) {
    ImGui::SetScrollHereY();
    scrollToRow_ = false;
  }
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const Columns c = columns(theme, width);
  const char* mark = entry.folder ? icon::kFolder : entry.count ? icon::kList : icon::kFile;
  editor::drawText(draw, theme.body, {at.x, at.y}, palette::kTextDim, mark, width);
  editor::drawText(draw, theme.body, {at.x + theme.px(24), at.y},
                   entry.folder ? palette::kText : palette::kTextStrong, entryLabel(entry),
                   c.size - theme.px(24 + 78));
  const auto right = [&](float x, const std::string& text) {
    const float w = textWidth(theme.small, text);
    editor::drawText(draw, theme.small, {at.x + x - w, at.y + theme.px(1)}, palette::kTextFaint, text, w + 1);
  };
  if (!entry.folder) right(c.size, sizeText(entry.bytes));
  right(c.date, dateText(entry.time));
}

void FileBrowser::drawEntries(Ui& ui) {
  const Theme& theme = ui.theme;
  ImGui::BeginGroup();
  const float pad = theme.space(2), whole = ImGui::GetContentRegionAvail().x;
  const float width = whole - 2 * pad - ImGui::GetStyle().ScrollbarSize;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Columns c = columns(theme, width);
  ImGui::PushFont(theme.small);
  const auto head = [&](const char* label, FileOrder order, float right) {
    const std::string text = std::string(label) + (order_ != order ? ""
                                                   : descending_   ? " \xe2\x86\x93"
                                                                   : " \xe2\x86\x91");
    const float w = textWidth(theme.small, text);
    ImGui::SetCursorScreenPos({at.x + pad + (right > 0 ? right - w : 0), at.y});
    if (ImGui::InvisibleButton(label, {w, theme.px(20)})) {
      descending_ = order_ == order ? !descending_ : order != FileOrder::Name;
      order_ = order;
      arrange();
    }
    ui.trace.item(std::string("browser/by ") + label);
    editor::drawText(ImGui::GetWindowDrawList(), theme.small, {ImGui::GetItemRectMin().x, at.y + theme.px(2)},
                     ImGui::IsItemHovered() || order_ == order ? palette::kText : palette::kTextDim, text,
                     w + 1);
  };
  head("Name", FileOrder::Name, 0);
  head("Size", FileOrder::Size, c.size);
  head("Changed", FileOrder::Date, c.date);
  ImGui::PopFont();
  ImGui::SetCursorScreenPos({at.x, at.y + theme.px(22)});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kField);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
  ImGui::BeginChild("entries", {0, listHeight(theme)}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_AlwaysVerticalScrollbar);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries_.size()), ImGui::GetTextLineHeightWithSpacing());
  if (scrollToRow_ && row_ >= 0) clipper.ForceDisplayRangeByIndices(row_, row_ + 1);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) drawRow(ui, i, width);
  if (entries_.empty())
    ImGui::TextDisabled("%s", !filter_.empty()                     ? "Nothing here has that in its name."
                              : request_.kinds.empty() || showAll_ ? "This folder is empty."
                                                                   : "No files of this kind here.");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::EndGroup();
}

void FileBrowser::drawName(Ui& ui) {
  struct Completion {
    const FileBrowser* browser;
  } completion{this};
  const auto complete = [](ImGuiInputTextCallbackData* data) {
    const FileBrowser& b = *static_cast<Completion*>(data->UserData)->browser;
    const std::string typed(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    const std::string longer =
        completedPath(typed, b.folder_, b.showAll_ ? std::vector<std::string>() : b.request_.kinds);
    if (longer == typed) return 0;
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, longer.c_str());
    return 0;
  };
  ImGui::SetNextItemWidth(-1);
  if (focusName_) ui.fields.focusHere();
  focusName_ = false;
  go_ |= ImGui::InputTextWithHint(
      "##name", request_.saving ? "File name (Tab completes)" : "File name or path (Tab completes)", &name_,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
          ImGuiInputTextFlags_CallbackCompletion,
      complete, &completion);
  if (ImGui::IsItemEdited()) row_ = -1;  // Enter means what is typed
  ui.trace.item("browser/name");
}

void FileBrowser::drawNotice(Ui& ui, Settings& settings) {
  if (!error_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(error_.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ui.trace.note("browser error", error_);
  }
  if (!askReplace_) return;
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  ImGui::TextUnformatted(
      fmt::format("{}  {} exists already.", icon::kWarning, replacing_.filename().string()).c_str());
  ImGui::PopStyleColor();
  ImGui::SameLine();
  if (ImGui::Button("Replace")) finish(ui, settings, replacing_);
  ui.trace.item("browser/replace");
}

void FileBrowser::drawBottom(Ui& ui) {
  const Theme& theme = ui.theme;
  if (!request_.kinds.empty()) {
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
    if (ImGui::Checkbox("All files", &showAll_)) arrange();
    ImGui::PopStyleVar();
    ImGui::SameLine();
    ImGui::PushFont(theme.small);
    std::string kinds;
    for (const std::string& k : request_.kinds) kinds += (kinds.empty() ? "else ." : ", .") + k;
    ImGui::TextDisabled("%s", kinds.c_str());
    ImGui::PopFont();
    ImGui::SameLine();
  }
  const float button = theme.px(110);
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2 * button - theme.space(2));
  const bool cancel = ImGui::Button("Cancel", {button, 0});
  ui.trace.item("browser/cancel");
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
  (request_.folder ? here_ : go_) |= ImGui::Button(request_.button.c_str(), {button, 0});
  ImGui::PopStyleColor();
  ui.trace.item("browser/ok");
  if (!cancel && !ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return;
  go_ = false;
  open_ = false;
  ImGui::CloseCurrentPopup();
}

}  // namespace pileus::editor
