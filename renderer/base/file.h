#pragma once
// Files: whole reads, atomic writes, the XDG folders.
#include <filesystem>
#include <string>
#include <string_view>

#include "renderer/base/hash.h"
#include "renderer/base/result.h"

namespace pileus {

/// The whole file. Error (Input) names the path and the reason.
Result<std::string> readFile(const std::filesystem::path& path, std::size_t maxBytes = std::size_t(1) << 30);
/// A file beside `target` that was not there before, open for writing (-1: errno says why not); to be renamed
/// or removed. Its name begins with the target's, ".tmp" and the process's number. No link is followed and
/// nobody else's file is taken.
struct Temporary {
  int fd = -1;
  std::filesystem::path path;
};
Temporary createTemporary(const std::filesystem::path& target, unsigned mode);
/// Temporary file beside the target, fsync, rename: the target is the old content or the new, never a part.
/// Keeps the target's permissions, and a link a link, also where what it names is not there yet; a file that
/// is set read-only is an error. What is no file on a disk (isStream) is written to as it is.
Result<void> writeFileAtomic(const std::filesystem::path& target, std::string_view content);
/// A device, a pipe or a socket: there, but neither a file nor a folder, and no place for either.
bool isStream(const std::filesystem::path& path);
/// What a chain of links ends at, whether it is there or not; `path` itself where it is no link.
std::filesystem::path linkTarget(const std::filesystem::path& path);
/// All of it, into an open file. False: errno says why not.
bool writeAll(int file, std::string_view content);
/// Key of (absolute path, size, modification time): what a file input contributes to a content key. Missing
/// file: a key of its path.
Key fileStamp(const std::filesystem::path& path);
/// $XDG_CACHE_HOME/pileus or ~/.cache/pileus, created; falls back to a folder under the system's temporary
/// one that nobody else can look into or has had a hand in.
std::filesystem::path cacheFolder();
/// $XDG_CONFIG_HOME/pileus or ~/.config/pileus, created; same fallback.
std::filesystem::path configFolder();
/// $XDG_STATE_HOME/pileus or ~/.local/state/pileus, created; same fallback.
std::filesystem::path stateFolder();
/// The running executable (/proc/self/exe).
std::filesystem::path executablePath();

}  // namespace pileus
