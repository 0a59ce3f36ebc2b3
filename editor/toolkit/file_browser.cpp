// The file dialog: what its keys and choices do, and its frame. Its parts: file_browser_draw.cpp.
#include "editor/toolkit/file_browser.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "editor/preferences/settings.h"
#include "editor/toolkit/theme.h"
#include "editor/toolkit/ui.h"
#include "editor/toolkit/window.h"

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

constexpr char kTitle[] = "##file browser";

bool pressed(ImGuiKey key, bool repeat = false) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeat);
}

}  // namespace

void FileBrowser::open(const Settings& settings, BrowserRequest request) {
  request_ = std::move(request);
  open_ = focusName_ = true;
  askReplace_ = showAll_ = go_ = here_ = false;
  error_.clear();
  name_ = request_.name;
  filter_.clear();
  newFolder_.reset();
  std::error_code ec;
  fs::path start = request_.start;
  if (start.empty() && !request_.kinds.empty())
    if (const auto kind = settings.kindFolders.find(request_.kinds.front());
        kind != settings.kindFolders.end())
      start = kind->second;
  if (start.empty() || (!fs::is_directory(start, ec) && !fs::is_directory(start.parent_path(), ec)))
    start = request_.otherwise;
  if (!start.empty() && !fs::is_directory(start, ec)) {
    name_ = start.filename().string();
    start = start.parent_path();
  }
  if (start.empty() || !fs::is_directory(start, ec)) {
    const std::vector<std::string>& recent = settings.recentFolders;
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

void FileBrowser::finish(Ui& ui, Settings& settings, const fs::path& path) {
  remember(settings.recentFolders, path.parent_path().string(), 8);
  if (!request_.kinds.empty()) settings.kindFolders[request_.kinds.front()] = path.parent_path().string();
  open_ = false;
  ImGui::CloseCurrentPopup();
  if (request_.done) ui.requests.push([done = std::move(request_.done), path] { done(path); });
}

fs::path FileBrowser::typedPath() const {
  const fs::path name = expandedHome(name_);
  return name.is_absolute() ? name : folder_ / name;
}

void FileBrowser::choose(Ui& ui, Settings& settings) {
  if (request_.folder && (name_.empty() || !fs::is_directory(typedPath()))) return void(here_ = true);
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
    if (!fs::exists(path, ec)) return finish(ui, settings, path);
    replacing_ = path;
    askReplace_ = true;
    return;
  }
  if (fs::exists(path, ec)) return finish(ui, settings, path);
  const auto sequence = std::find_if(entries_.begin(), entries_.end(), [&](const FileEntry& e) {
    return e.count > 0 && e.name == path.filename().string() && path.parent_path() == folder_;
  });
  if (sequence == entries_.end()) return void(error_ = fmt::format("{} does not exist.", path.string()));
  finish(ui, settings, request_.sequences ? path : folder_ / sequence->firstName);
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

void FileBrowser::draw(Ui& ui, Settings& settings, std::span<const KeyPress> keys, const fs::path& document) {
  const Theme& theme = ui.theme;
  // Also behind a question that stood before it.
  if (open_ && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x * 0.5f, display.y * 0.48f}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(theme.px(820), display.x - theme.px(40)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.space(5), theme.space(4)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
  const bool visible = ImGui::BeginPopupModal(
      kTitle, nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove);
  ImGui::PopStyleVar(2);
  if (!visible) return;
  const ImVec2 lo = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ui.trace.rect("browser", lo, {lo.x + size.x, lo.y + size.y});
  go_ = false;
  for (const KeyPress& key : keys) focusFilter_ |= key.key == 'F' && key.ctrl;
  handleKeys();
  drawTop(ui, settings);
  drawNewFolder(ui);
  drawPlaces(ui, settings, document);
  ImGui::SameLine();
  drawEntries(ui);
  drawName(ui);
  drawNotice(ui, settings);
  if (open_) drawBottom(ui);
  if (open_ && std::exchange(here_, false)) {
    std::error_code ec;
    const bool typed = !name_.empty() && fs::is_directory(typedPath(), ec);
    finish(ui, settings, (typed ? typedPath() : folder_) / "");
  }
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
      choose(ui, settings);
      focusName_ = open_;
    }
  }
  ImGui::EndPopup();
}

}  // namespace pileus::editor
