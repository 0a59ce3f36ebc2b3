#include "editor/file_browser.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>

#include "editor/editor.h"
#include "editor/graph_view/canvas_view.h"
#include "editor/icons.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr char kTitle[] = "##file browser";

std::string lowered(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool hasKind(const std::string& name, const std::vector<std::string>& kinds) {
  if (kinds.empty()) return true;
  const std::string text = lowered(name);
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const std::string& k) { return text.ends_with("." + k); });
}

fs::path homeFolder() {
  const char* home = std::getenv("HOME");
  return home && *home ? fs::path(home) : fs::path("/");
}

std::string sizeText(std::uintmax_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (bytes < 1024) return fmt::format("{} B", bytes);
  if (bytes < 1024 * 1024) return fmt::format("{:.0f} KiB", value / 1024);
  if (bytes < 1024ull * 1024 * 1024) return fmt::format("{:.1f} MiB", value / (1024 * 1024));
  return fmt::format("{:.2f} GiB", value / (1024.0 * 1024 * 1024));
}

}  // namespace

void FileBrowser::open(Editor& editor, BrowserRequest request) {
  request_ = std::move(request);
  open_ = appear_ = focusName_ = true;
  askReplace_ = showAll_ = false;
  error_.clear();
  name_.clear();
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
  refresh();
}

void FileBrowser::refresh() {
  entries_.clear();
  error_.clear();
  std::error_code ec;
  fs::directory_iterator it(folder_, fs::directory_options::skip_permission_denied, ec);
  if (ec) error_ = fmt::format("This folder cannot be read: {}", ec.message());
  for (; !ec && it != fs::directory_iterator(); it.increment(ec)) {
    Entry entry;
    entry.name = it->path().filename().string();
    if (entry.name.starts_with(".")) continue;
    std::error_code each;
    entry.folder = it->is_directory(each);
    if (!entry.folder) entry.bytes = it->file_size(each);
    if (entry.folder || showAll_ || hasKind(entry.name, request_.kinds)) entries_.push_back(std::move(entry));
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    if (a.folder != b.folder) return a.folder;
    const std::string x = lowered(a.name), y = lowered(b.name);
    return x != y ? x < y : a.name < b.name;
  });
}

void FileBrowser::finish(Editor& editor, const fs::path& path) {
  remember(editor.settings.recentFolders, path.parent_path().string(), 8);
  open_ = false;
  ImGui::CloseCurrentPopup();
  const auto done = std::move(request_.done);  // it may open the browser again
  if (done) done(path);
}

void FileBrowser::choose(Editor& editor) {
  if (name_.empty()) return void(error_ = "Type or choose a name.");
  std::string name = name_;
  if (name.starts_with("~/")) name = (homeFolder() / name.substr(2)).string();
  fs::path path = fs::path(name).is_absolute() ? fs::path(name) : folder_ / name;
  std::error_code ec;
  if (fs::is_directory(path, ec)) {
    name_.clear();
    return enter(path);
  }
  if (!request_.saving) {
    if (!fs::exists(path, ec)) return void(error_ = fmt::format("{} does not exist.", path.string()));
    return finish(editor, path);
  }
  if (!hasKind(path.filename().string(), request_.kinds)) path += "." + request_.kinds.front();
  if (!fs::is_directory(path.parent_path(), ec))
    return void(error_ = fmt::format("The folder {} does not exist.", path.parent_path().string()));
  if (fs::exists(path, ec)) {
    replacing_ = path;
    askReplace_ = true;
    return;
  }
  finish(editor, path);
}

void FileBrowser::drawPlaces(Editor& editor) {
  const Theme& theme = editor.theme;
  ImGui::BeginChild("places", {theme.px(170), theme.px(320)}, false);
  const auto place = [&](const char* mark, const std::string& label, const fs::path& folder) {
    ImGui::PushID(folder.c_str());
    if (ImGui::Selectable(fmt::format("{}  {}", mark, label).c_str(), folder == folder_)) enter(folder);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", folder.c_str());
    ImGui::PopID();
  };
  place(icon::kHome, "Home", homeFolder());
  place(icon::kDesktop, "Computer", "/");
  if (!editor.document.path().empty())
    place(icon::kFile, "This document", fs::absolute(editor.document.path()).parent_path());
  ImGui::Dummy({0, theme.space(1)});
  ImGui::TextDisabled("Recent");
  for (const std::string& folder : editor.settings.recentFolders)
    place(icon::kFolder, fs::path(folder).filename().empty() ? folder : fs::path(folder).filename().string(),
          folder);
  ImGui::EndChild();
}

void FileBrowser::drawEntries(Editor& editor) {
  const Theme& theme = editor.theme;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kField);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(2), theme.space(2)});
  ImGui::BeginChild("entries", {0, theme.px(320)}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  fs::path into;
  bool chosen = false;
  for (const Entry& entry : entries_) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const std::string label = fmt::format("{}  {}", entry.folder ? icon::kFolder : icon::kFile, entry.name);
    if (ImGui::Selectable(("##" + entry.name).c_str(), !entry.folder && entry.name == name_,
                          ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
      if (!entry.folder) name_ = entry.name, error_.clear();
      if (entry.folder)
        into = folder_ / entry.name;
      else if (ImGui::IsMouseDoubleClicked(0))
        chosen = true;
    }
    editor.trace.item("entry/" + entry.name);
    editor::drawText(ImGui::GetWindowDrawList(), theme.body, {at.x, at.y},
                     entry.folder ? palette::kText : palette::kTextStrong, label, width - theme.px(80));
    if (!entry.folder) {
      const std::string size = sizeText(entry.bytes);
      const float w = textWidth(theme.small, size);
      editor::drawText(ImGui::GetWindowDrawList(), theme.small, {at.x + width - w, at.y + theme.px(1)},
                       palette::kTextFaint, size, w + 1);
    }
  }
  if (entries_.empty())
    ImGui::TextDisabled(
        "%s", request_.kinds.empty() || showAll_ ? "This folder is empty." : "No files of this kind here.");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  if (!into.empty()) enter(into);
  if (chosen) choose(editor);
}

void FileBrowser::draw(Editor& editor) {
  const Theme& theme = editor.theme;
  if (appear_) ImGui::OpenPopup(kTitle);
  appear_ = false;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.48f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(theme.px(760), display.x - theme.px(40)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(5), theme.space(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
  const bool visible = ImGui::BeginPopupModal(
      kTitle, nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar(2);
  if (!visible) return;
  ImGui::PushFont(theme.title);
  ImGui::TextUnformatted(request_.title.c_str());
  ImGui::PopFont();
  if (ImGui::Button(icon::kArrowUp)) enter(folder_.parent_path());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Folder above");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", folder_.c_str());
  drawPlaces(editor);
  ImGui::SameLine();
  drawEntries(editor);
  if (!open_) return ImGui::EndPopup();

  ImGui::SetNextItemWidth(-1);
  if (focusName_) ImGui::SetKeyboardFocusHere();
  focusName_ = false;
  const bool enterKey =
      ImGui::InputTextWithHint("##name", request_.saving ? "File name" : "File name or path", &name_,
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  editor.trace.item("browser/name");
  bool go = enterKey;
  if (!error_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(error_.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    editor.trace.note("browser error", error_);
  }
  if (askReplace_) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::TextUnformatted(
        fmt::format("{}  {} exists already.", icon::kWarning, replacing_.filename().string()).c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (ImGui::Button("Replace")) finish(editor, replacing_);
    editor.trace.item("browser/replace");
    if (!open_) return ImGui::EndPopup();
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
  if (!request_.kinds.empty() && ImGui::Checkbox("All files", &showAll_)) refresh();
  ImGui::PopStyleVar();
  const float button = theme.px(110);
  if (!request_.kinds.empty()) ImGui::SameLine();
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2 * button - theme.space(2));
  const bool cancel = ImGui::Button("Cancel", {button, 0});
  editor.trace.item("browser/cancel");
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentDim);
  go |= ImGui::Button(request_.button.c_str(), {button, 0});
  ImGui::PopStyleColor();
  editor.trace.item("browser/ok");
  if (go) {
    askReplace_ = false;
    choose(editor);
  } else if (cancel || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
