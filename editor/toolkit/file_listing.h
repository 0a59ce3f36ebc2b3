#pragma once
// What a folder holds, as file lists show it: chosen by kind and text, numbered files folded into sequences,
// sorted. And completion of typed paths. No interface; errors are values.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/result.h"

namespace pileus::editor {

struct FileEntry {
  std::string name;  ///< of a sequence: "smoke.####.vdb"
  bool folder = false;
  std::uintmax_t bytes = 0;            ///< of all files of a sequence
  std::int64_t time = 0;               ///< of the last change, seconds since 1970; the newest of a sequence
  int first = 0, last = 0, count = 0;  ///< of a sequence; count 0 = a single file
  std::string firstName;               ///< of a sequence: its first file
};

enum class FileOrder { Name, Date, Size };

/// Everything that is not hidden.
Result<std::vector<FileEntry>> listFolder(const std::filesystem::path& folder);
/// Is the ending one of `kinds` (without dot, lower case)? No kinds: always.
bool hasKind(const std::string& name, const std::vector<std::string>& kinds);
/// Folders, and files of the kinds, whose name holds every word of `filter`, in any case.
std::vector<FileEntry> filtered(const std::vector<FileEntry>& entries, const std::vector<std::string>& kinds,
                                const std::string& filter);
/// Two or more files that differ in the last number of their names become one entry; documents never do.
std::vector<FileEntry> foldSequences(std::vector<FileEntry> entries);
/// Folders first, then as ordered; names by their numbers ("a2" before "a10").
void sortEntries(std::vector<FileEntry>& entries, FileOrder order, bool descending);
/// "smoke.####.vdb  [1-120]" or, with gaps, "[1-120, 97 files]".
std::string entryLabel(const FileEntry& entry);
/// Does "smoke.####.vdb" or "smoke.%04d.vdb" name this file?
bool matchesPattern(const std::string& pattern, const std::string& name);
bool isPattern(const std::string& name);

std::string sizeText(std::uintmax_t bytes);
/// "2026-11-24 15:08"; local time.
std::string dateText(std::int64_t seconds);

/// The same name with the next number that no file has: "a_v009.json" gives "a_v010.json", "a.json"
/// "a_v002.json".
std::filesystem::path nextVersion(const std::filesystem::path& file);

/// "~" and "~/x" with the home folder in its place.
std::string expandedHome(const std::string& path);
/// The path with as much added as all matching files and folders of the kinds have in common; a single folder
/// gets its slash. Relative ones start in `folder`. The same text if nothing matches.
std::string completedPath(const std::string& typed, const std::filesystem::path& folder,
                          const std::vector<std::string>& kinds);

}  // namespace pileus::editor
