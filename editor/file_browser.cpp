#include "editor/file_browser.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/icons.h"
#include "editor/widgets.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr char kTitle[] = "##file browser";

bool pressed(ImGuiKey key, bool repeat = false) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeat);
}

std::string folderName(const std::string& folder) {
  const std::string name = fs::path(folder).filename().string();
  return name.empty() ? folder : name;
}

/// Columns of the list, from the right.
struct Columns {
  float size, date;  ///< right edges, from the list's left
};
Columns columns(const Theme& theme, float width) { return {width - theme.px(142), width}; }

}  // namespace

void FileBrowser::open(Editor& editor, BrowserRequest request) {
  request_ = std::move(request);
  open_ = appear_ = focusName_ = true;
  askReplace_ = showAll_ = go_ = false;
  error_.clear();
  name_.clear();
  filter_.clear();
  std::error_code ec;
  fs::path start = request_.start;
  if (!start.empty() && !fs::is_directory(start, ec)) {
    name_ = start.filename().string();
    start = start.parent_path();
  }
  if (start.empty() || !fs::is_directory(start, ec)) {
    const std::vector<std::string>& recent = editor.settings.recentFolders;
    const auto alive = std::find_if(recent.begin(), recent.end(),
                                    [&](const std::string& f) { return fs::is_directory(f, ec); });
    start = alive != recent.end() ? fs::path(*alive) : fs::current_path(ec);
  }
  enter(start);
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code ec;
  fs::path whole = fs::weakly_canonical(fs::absolute(folder, ec), ec);
  if (ec) whole = folder;
  if (!fs::is_directory(whole, ec)) return void(error_ = fmt::format("{} is not a folder.", whole.string()));
  folder_ = whole;
  filter_.clear();
  refresh();
}

void FileBrowser::refresh() {
  error_.clear();
  Result<std::vector<FileEntry>> found = listFolder(folder_);
  all_ = found ? std::move(*found) : std::vector<FileEntry>();
  if (!found) error_ = found.error().message;
  arrange();
}

void FileBrowser::arrange() {
  entries_ = filtered(all_, showAll_ ? std::vector<std::string>() : request_.kinds, filter_);
  if (!request_.saving) entries_ = foldSequences(std::move(entries_));
  sortEntries(entries_, order_, descending_);
  row_ = -1;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (!entries_[i].folder && entries_[i].name == name_) row_ = static_cast<int>(i), scrollToRow_ = true;
}

void FileBrowser::select(int row) {
  if (row < 0 || row >= static_cast<int>(entries_.size())) return;
  row_ = row;
  const FileEntry& entry = entries_[static_cast<std::size_t>(row)];
  if (!entry.folder) name_ = entry.name;
  error_.clear();
}

void FileBrowser::finish(Editor& editor, const fs::path& path) {
  remember(editor.settings.recentFolders, path.parent_path().string(), 8);
  open_ = false;
  ImGui::CloseCurrentPopup();
  const auto done = std::move(request_.done);  // it may open the browser again
  if (done) done(path);
}

fs::path FileBrowser::typedPath() const {
  const fs::path name = expandedHome(name_);
  return name.is_absolute() ? name : folder_ / name;
}

void FileBrowser::choose(Editor& editor) {
  if (name_.empty()) return void(error_ = "Type or choose a name.");
  fs::path path = typedPath();
  std::error_code ec;
  if (fs::is_directory(path, ec)) {
    name_.clear();
    return enter(path);
  }
  if (request_.saving) {
    if (!hasKind(path.filename().string(), request_.kinds)) path += "." + request_.kinds.front();
    if (!fs::is_directory(path.parent_path(), ec))
      return void(error_ = fmt::format("The folder {} does not exist.", path.parent_path().string()));
    if (!fs::exists(path, ec)) return finish(editor, path);
    replacing_ = path;
    askReplace_ = true;
    return;
  }
  if (fs::exists(path, ec)) return finish(editor, path);
  const auto sequence = std::find_if(entries_.begin(), entries_.end(), [&](const FileEntry& e) {
    return e.count > 0 && e.name == path.filename().string() && path.parent_path() == folder_;
  });
  if (sequence == entries_.end()) return void(error_ = fmt::format("{} does not exist.", path.string()));
  finish(editor, request_.sequences ? path : folder_ / sequence->firstName);
}

void FileBrowser::handleKeys() {
  const ImGuiIO& io = ImGui::GetIO();
  const int last = static_cast<int>(entries_.size()) - 1;
  const int step = (pressed(ImGuiKey_DownArrow, true) ? 1 : 0) - (pressed(ImGuiKey_UpArrow, true) ? 1 : 0);
  if (io.KeyAlt && step < 0) return enter(folder_.parent_path());
  const int page = (pressed(ImGuiKey_PageDown, true) ? 10 : 0) - (pressed(ImGuiKey_PageUp, true) ? 10 : 0);
  if ((step || page) && last >= 0) {
    select(std::clamp(row_ < 0 ? (step + page > 0 ? 0 : last) : row_ + step + page, 0, last));
    scrollToRow_ = true;
  }
}

void FileBrowser::drawTop(Editor& editor) {
  const Theme& theme = editor.theme;
  ImGui::PushFont(theme.title);
  ImGui::TextUnformatted(request_.title.c_str());
  ImGui::PopFont();
  if (ImGui::Button(icon::kArrowUp)) enter(folder_.parent_path());
  editor.trace.item("browser/up");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Folder above (Alt+Up)");
  ImGui::SameLine();
  std::vector<std::string>& marks = editor.settings.folderBookmarks;
  const auto marked = std::find(marks.begin(), marks.end(), folder_.string());
  ImGui::PushStyleColor(ImGuiCol_Text, marked != marks.end() ? palette::kSelect : palette::kTextDim);
  if (ImGui::Button(icon::kBookmark)) {
    if (marked != marks.end())
      marks.erase(marked);
    else
      marks.push_back(folder_.string());
  }
  ImGui::PopStyleColor();
  editor.trace.item("browser/bookmark");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Keep this folder among the places, or remove it");
  ImGui::SameLine();
  const float search = theme.px(190);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x - search - theme.space(3);
  // The end of a long path says more than its beginning.
  std::string shown = folder_.string();
  while (shown.size() > 4 && textWidth(theme.body, "\xe2\x80\xa6" + shown) > room) {
    const std::size_t slash = shown.find('/', 1);
    shown = slash == std::string::npos ? shown.substr(4) : shown.substr(slash);
  }
  if (shown != folder_.string()) shown = "\xe2\x80\xa6" + shown;
  editor::drawText(ImGui::GetWindowDrawList(), theme.body,
                   {at.x, at.y + 0.5f * (ImGui::GetFrameHeight() - theme.body->FontSize)}, palette::kTextDim,
                   shown, room);
  ImGui::SetCursorScreenPos({at.x + room + theme.space(3), at.y});
  ImGui::SetNextItemWidth(search);
  if (focusFilter_) ImGui::SetKeyboardFocusHere();
  focusFilter_ = false;
  if (ImGui::InputTextWithHint("##filter", (std::string(icon::kSearch) + "  Filter (Ctrl+F)").c_str(),
                               &filter_))
    arrange();
  editor.trace.item("browser/filter");
}

void FileBrowser::drawPlaces(Editor& editor) {
  const Theme& theme = editor.theme;
  ImGui::BeginChild("places", {theme.px(166), theme.px(340)}, false);
  const auto place = [&](const char* mark, const std::string& label, const fs::path& folder) {
    ImGui::PushID(folder.c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable("##place", folder == folder_)) enter(folder);
    editor.trace.item("place/" + label);
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
  if (!editor.document.path().empty())
    place(icon::kFile, "This document", fs::absolute(editor.document.path()).parent_path());
  if (!editor.settings.folderBookmarks.empty()) {
    section("Bookmarks");
    for (const std::string& f : std::vector<std::string>(editor.settings.folderBookmarks))
      place(icon::kBookmark, folderName(f), f);
    ImGui::PopID();
  }
  if (!editor.settings.recentFolders.empty()) {
    section("Recent");
    for (const std::string& f : editor.settings.recentFolders) place(icon::kFolder, folderName(f), f);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

void FileBrowser::drawRow(Editor& editor, int row, float width) {
  const Theme& theme = editor.theme;
  const FileEntry& entry = entries_[static_cast<std::size_t>(row)];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushID(row);
  if (ImGui::Selectable("##row", row == row_,
                        ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
    select(row);
    // Folders open with one click, as they always did; files with two.
    if (entry.folder || ImGui::IsMouseDoubleClicked(0)) go_ = true;
  }
  editor.trace.item("entry/" + entry.name);
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

void FileBrowser::drawEntries(Editor& editor) {
  const Theme& theme = editor.theme;
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
    editor.trace.item(std::string("browser/by ") + label);
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
  ImGui::BeginChild("entries", {0, theme.px(318)}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_AlwaysVerticalScrollbar);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(entries_.size()), ImGui::GetTextLineHeightWithSpacing());
  if (scrollToRow_ && row_ >= 0) clipper.ForceDisplayRangeByIndices(row_, row_ + 1);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) drawRow(editor, i, width);
  if (entries_.empty())
    ImGui::TextDisabled("%s", !filter_.empty()                     ? "Nothing here has that in its name."
                              : request_.kinds.empty() || showAll_ ? "This folder is empty."
                                                                   : "No files of this kind here.");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::EndGroup();
}

void FileBrowser::drawName(Editor& editor) {
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
  if (focusName_) ImGui::SetKeyboardFocusHere();
  focusName_ = false;
  go_ |= ImGui::InputTextWithHint(
      "##name", request_.saving ? "File name (Tab completes)" : "File name or path (Tab completes)", &name_,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
          ImGuiInputTextFlags_CallbackCompletion,
      complete, &completion);
  if (ImGui::IsItemEdited()) row_ = -1;  // Enter means what is typed
  editor.trace.item("browser/name");
}

void FileBrowser::drawNotice(Editor& editor) {
  if (!error_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(error_.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    editor.trace.note("browser error", error_);
  }
  if (!askReplace_) return;
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  ImGui::TextUnformatted(
      fmt::format("{}  {} exists already.", icon::kWarning, replacing_.filename().string()).c_str());
  ImGui::PopStyleColor();
  ImGui::SameLine();
  if (ImGui::Button("Replace")) finish(editor, replacing_);
  editor.trace.item("browser/replace");
}

void FileBrowser::drawBottom(Editor& editor) {
  const Theme& theme = editor.theme;
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
  editor.trace.item("browser/cancel");
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
  go_ |= ImGui::Button(request_.button.c_str(), {button, 0});
  ImGui::PopStyleColor();
  editor.trace.item("browser/ok");
  if (!cancel && !pressed(ImGuiKey_Escape)) return;
  go_ = false;
  open_ = false;
  ImGui::CloseCurrentPopup();
}

void FileBrowser::draw(Editor& editor) {
  const Theme& theme = editor.theme;
  if (appear_) ImGui::OpenPopup(kTitle);
  appear_ = false;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.48f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(theme.px(820), display.x - theme.px(40)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(5), theme.space(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
  const bool visible = ImGui::BeginPopupModal(
      kTitle, nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar(2);
  if (!visible) return;
  go_ = false;
  for (const KeyPress& key : editor.window->keys()) focusFilter_ |= key.key == 'F' && key.ctrl;
  handleKeys();
  drawTop(editor);
  drawPlaces(editor);
  ImGui::SameLine();
  drawEntries(editor);
  drawName(editor);
  drawNotice(editor);
  if (open_) drawBottom(editor);
  if (open_ && go_) {
    askReplace_ = false;
    const FileEntry* entry = row_ >= 0 && row_ < static_cast<int>(entries_.size())
                                 ? &entries_[static_cast<std::size_t>(row_)]
                                 : nullptr;
    // Arrows may stand on a folder while the name is that of a file.
    if (entry && entry->folder) {
      const fs::path into = folder_ / entry->name;
      enter(into);
      focusName_ = true;
    } else {
      choose(editor);
      focusName_ = open_;
    }
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
