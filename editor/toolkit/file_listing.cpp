#include "editor/toolkit/file_listing.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <map>
#include <optional>

namespace fs = std::filesystem;

namespace pileus::editor {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::string lowered(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// The last number of a name, before its ending.
struct Numbered {
  std::string head, tail;
  int digits = 0, number = 0;
  bool padded = false;  ///< begins with 0
};

std::optional<Numbered> numbered(const std::string& name) {
  const std::size_t dot = name.find_last_of('.');
  std::size_t end = dot == std::string::npos ? name.size() : dot;
  while (end > 0 && !isDigit(name[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && isDigit(name[begin - 1])) --begin;
  if (begin == end || end - begin > 9) return std::nullopt;
  Numbered n;
  n.head = name.substr(0, begin);
  n.tail = name.substr(end);
  n.digits = static_cast<int>(end - begin);
  n.number = std::atoi(name.substr(begin, end - begin).c_str());
  n.padded = name[begin] == '0' && n.digits > 1;
  return n;
}

/// Text with numbers compared by value.
int compareNames(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const auto run = [](const std::string& s, std::size_t& at) {
        while (at < s.size() && s[at] == '0') ++at;
        const std::size_t from = at;
        while (at < s.size() && isDigit(s[at])) ++at;
        return s.substr(from, at - from);
      };
      const std::string x = run(a, i), y = run(b, j);
      if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
      if (x != y) return x < y ? -1 : 1;
      continue;
    }
    if (a[i] != b[j]) return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]) ? -1 : 1;
    ++i, ++j;
  }
  return a.size() - i == b.size() - j ? 0 : a.size() - i < b.size() - j ? -1 : 1;
}

bool nameBefore(const FileEntry& a, const FileEntry& b) {
  const int order = compareNames(lowered(a.name), lowered(b.name));
  return order != 0 ? order < 0 : a.name < b.name;
}

std::int64_t seconds(fs::file_time_type time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  return std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count();
}

/// Where the placeholder of a pattern begins and how long it is; length 0: none.
std::pair<std::size_t, std::size_t> placeholder(const std::string& pattern) {
  if (const std::size_t hash = pattern.find('#'); hash != std::string::npos) {
    std::size_t n = 0;
    while (hash + n < pattern.size() && pattern[hash + n] == '#') ++n;
    return {hash, n};
  }
  const std::size_t percent = pattern.find('%');
  if (percent == std::string::npos) return {0, 0};
  std::size_t end = percent + 1;
  while (end < pattern.size() && isDigit(pattern[end])) ++end;
  return end < pattern.size() && pattern[end] == 'd' ? std::pair{percent, end + 1 - percent}
                                                     : std::pair<std::size_t, std::size_t>{0, 0};
}

}  // namespace

bool hasKind(const std::string& name, const std::vector<std::string>& kinds) {
  if (kinds.empty()) return true;
  const std::string text = lowered(name);
  return std::any_of(kinds.begin(), kinds.end(),
                     [&](const std::string& k) { return text.ends_with("." + k); });
}

Result<std::vector<FileEntry>> listFolder(const fs::path& folder) {
  std::vector<FileEntry> entries;
  std::error_code ec;
  fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, ec);
  if (ec) return fail(Code::Input, "This folder cannot be read: {}", ec.message());
  for (; !ec && it != fs::directory_iterator(); it.increment(ec)) {
    FileEntry entry;
    entry.name = it->path().filename().string();
    if (entry.name.starts_with(".")) continue;
    std::error_code each;
    entry.folder = it->is_directory(each);
    if (!entry.folder) {
      const std::uintmax_t bytes = it->file_size(each);
      if (!each) entry.bytes = bytes;
    }
    const auto time = it->last_write_time(each);
    if (!each) entry.time = seconds(time);
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<FileEntry> filtered(const std::vector<FileEntry>& entries, const std::vector<std::string>& kinds,
                                const std::string& filter) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : lowered(filter) + " ") {
    if (c != ' ')
      word += c;
    else if (!word.empty())
      words.push_back(std::exchange(word, {}));
  }
  std::vector<FileEntry> out;
  for (const FileEntry& e : entries) {
    if (!e.folder && !hasKind(e.name, kinds)) continue;
    const std::string name = lowered(e.name);
    if (std::all_of(words.begin(), words.end(),
                    [&](const std::string& w) { return name.find(w) != std::string::npos; }))
      out.push_back(e);
  }
  return out;
}

std::vector<FileEntry> foldSequences(std::vector<FileEntry> entries) {
  struct Group {
    std::vector<std::size_t> members;
    int digits = 0;
    bool padded = false, mixed = false;
  };
  std::map<std::pair<std::string, std::string>, Group> groups;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].folder || hasKind(entries[i].name, {"json"})) continue;
    const auto n = numbered(entries[i].name);
    if (!n) continue;
    Group& g = groups[{n->head, n->tail}];
    g.mixed |= !g.members.empty() && g.digits != n->digits;
    g.digits = std::max(g.digits, n->digits);
    g.padded |= n->padded;
    g.members.push_back(i);
  }
  std::vector<bool> gone(entries.size(), false);
  std::vector<FileEntry> folded;
  for (const auto& [ends, g] : groups) {
    if (g.members.size() < 2 || (g.mixed && g.padded)) continue;  // "1", "01": not one sequence
    FileEntry e;
    e.name = ends.first + std::string(g.mixed ? 1u : static_cast<std::size_t>(g.digits), '#') + ends.second;
    for (const std::size_t i : g.members) {
      const int number = numbered(entries[i].name)->number;
      if (e.count == 0 || number < e.first) e.first = number, e.firstName = entries[i].name;
      e.last = e.count == 0 ? number : std::max(e.last, number);
      e.bytes += entries[i].bytes;
      e.time = std::max(e.time, entries[i].time);
      ++e.count;
      gone[i] = true;
    }
    folded.push_back(std::move(e));
  }
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (!gone[i]) folded.push_back(std::move(entries[i]));
  return folded;
}

void sortEntries(std::vector<FileEntry>& entries, FileOrder order, bool descending) {
  std::sort(entries.begin(), entries.end(), [&](const FileEntry& a, const FileEntry& b) {
    if (a.folder != b.folder) return a.folder;
    const FileEntry &x = descending ? b : a, &y = descending ? a : b;
    if (order == FileOrder::Date && x.time != y.time) return x.time < y.time;
    if (order == FileOrder::Size && x.bytes != y.bytes) return x.bytes < y.bytes;
    return order == FileOrder::Name ? nameBefore(x, y) : nameBefore(a, b);
  });
}

std::string entryLabel(const FileEntry& e) {
  if (e.count == 0) return e.name;
  return e.count == e.last - e.first + 1
             ? fmt::format("{}  [{}-{}]", e.name, e.first, e.last)
             : fmt::format("{}  [{}-{}, {} files]", e.name, e.first, e.last, e.count);
}

bool isPattern(const std::string& name) { return placeholder(name).second > 0; }

bool matchesPattern(const std::string& pattern, const std::string& name) {
  const auto [at, length] = placeholder(pattern);
  if (length == 0) return pattern == name;
  const std::string head = pattern.substr(0, at), tail = pattern.substr(at + length);
  if (name.size() <= head.size() + tail.size() || !name.starts_with(head) || !name.ends_with(tail))
    return false;
  const std::string middle = name.substr(head.size(), name.size() - head.size() - tail.size());
  return std::all_of(middle.begin(), middle.end(), isDigit) &&
         (pattern[at] != '#' || length == 1 || middle.size() >= length);
}

std::string sizeText(std::uintmax_t bytes) {
  const auto value = static_cast<double>(bytes);
  if (bytes < 1024) return fmt::format("{} B", bytes);
  if (bytes < 1024 * 1024) return fmt::format("{:.0f} KiB", value / 1024);
  if (bytes < 1024ull * 1024 * 1024) return fmt::format("{:.1f} MiB", value / (1024 * 1024));
  return fmt::format("{:.2f} GiB", value / (1024.0 * 1024 * 1024));
}

std::string dateText(std::int64_t at) {
  const auto time = static_cast<std::time_t>(at);
  std::tm parts{};
  if (!localtime_r(&time, &parts)) return {};
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday,
                     parts.tm_hour, parts.tm_min);
}

fs::path nextVersion(const fs::path& file) {
  const std::string stem = file.stem().string();
  std::size_t begin = stem.find_last_not_of("0123456789");
  begin = begin == std::string::npos ? 0 : begin + 1;
  std::string head = stem.substr(0, begin), digits = stem.substr(begin);
  if (digits.empty() || digits.size() > 8) head = stem + "_v", digits = "001";
  std::error_code ec;
  for (int number = std::stoi(digits) + 1;; ++number) {
    const fs::path next = file.parent_path() /
                          fmt::format("{}{:0{}}{}", head, number, digits.size(), file.extension().string());
    if (!fs::exists(next, ec)) return next;
  }
}

std::string expandedHome(const std::string& path) {
  const char* home = std::getenv("HOME");
  if (!home || !*home || (path != "~" && !path.starts_with("~/"))) return path;
  return home + path.substr(1);
}

std::string completedPath(const std::string& typed, const fs::path& folder,
                          const std::vector<std::string>& kinds) {
  if (typed == "~") return "~/";
  const std::size_t slash = typed.find_last_of('/');
  const std::string head = slash == std::string::npos ? "" : typed.substr(0, slash + 1);
  const std::string start = typed.substr(head.size());
  const fs::path whole = expandedHome(head);
  const auto entries = listFolder(whole.is_absolute() ? whole : folder / whole);
  if (!entries) return typed;
  std::vector<const FileEntry*> matches;
  for (const FileEntry& e : *entries)
    if (e.name.starts_with(start) && (e.folder || hasKind(e.name, kinds))) matches.push_back(&e);
  if (matches.empty()) return typed;
  std::string common = matches[0]->name;
  for (const FileEntry* e : matches) {
    std::size_t n = 0;
    while (n < common.size() && n < e->name.size() && common[n] == e->name[n]) ++n;
    common.resize(n);
  }
  // Never half of a letter.
  while (!common.empty() && common.size() < matches[0]->name.size() &&
         (static_cast<unsigned char>(matches[0]->name[common.size()]) & 0xc0) == 0x80)
    common.pop_back();
  return head + common + (matches.size() == 1 && matches[0]->folder ? "/" : "");
}

}  // namespace pileus::editor
