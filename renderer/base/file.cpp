#include "renderer/base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace fs = std::filesystem;

namespace pileus {
namespace {

std::string reason() { return std::strerror(errno); }

/// Ours alone, and made so where it is not there yet: in the system's temporary folder anybody may have put
/// something else under its name.
bool isPrivate(const fs::path& folder) {
  if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return false;
  struct stat st {};
  if (::lstat(folder.c_str(), &st) != 0 || !S_ISDIR(st.st_mode) || st.st_uid != ::getuid()) return false;
  if ((st.st_mode & 022) != 0) return false;  // what is in it may be another's
  return (st.st_mode & 077) == 0 || ::chmod(folder.c_str(), 0700) == 0;
}

fs::path temporaryFolder(const std::string& name) {
  constexpr int kTries = 16;
  std::error_code ec;
  const fs::path base = fs::temp_directory_path(ec) / name;
  for (int i = 0; i < kTries; ++i)
    if (const fs::path folder = i == 0 ? base : fs::path(base.string() + fmt::format("-{}", i));
        isPrivate(folder))
      return folder;
  std::string fresh = base.string() + "-XXXXXX";
  return ::mkdtemp(fresh.data()) ? fs::path(fresh) : base;
}

fs::path xdgFolder(const char* variable, const char* underHome) {
  std::error_code ec;
  fs::path base;
  if (const char* value = std::getenv(variable); value && *value == '/')
    base = value;
  else if (const char* home = std::getenv("HOME"); home && *home)
    base = fs::path(home) / underHome;
  if (!base.empty()) {
    const fs::path folder = base / "pileus";
    if (fs::create_directories(folder, ec);
        fs::is_directory(folder, ec) && ::access(folder.c_str(), W_OK) == 0)
      return folder;
  }
  std::string name = fmt::format("pileus-{}-{}", ::getuid(), underHome + 1);
  std::replace(name.begin(), name.end(), '/', '-');
  return temporaryFolder(name);
}

}  // namespace

Result<std::string> readFile(const fs::path& path, std::size_t maxBytes) {
  std::error_code ec;
  if (fs::is_directory(path, ec)) return fail(Code::Input, "{}: is a folder, not a file", path.string());
  std::ifstream in(path, std::ios::binary);
  if (!in) return fail(Code::Input, "{}: cannot be opened ({})", path.string(), reason());
  std::string content;
  char chunk[65536];
  while (in.read(chunk, sizeof chunk) || in.gcount() > 0) {
    content.append(chunk, static_cast<std::size_t>(in.gcount()));
    if (content.size() > maxBytes)
      return fail(Code::Input, "{}: larger than {} MiB", path.string(), maxBytes >> 20);
  }
  if (in.bad()) return fail(Code::Input, "{}: cannot be read ({})", path.string(), reason());
  return content;
}

Temporary createTemporary(const fs::path& target, unsigned mode) {
  constexpr int kTries = 1000;
  static std::atomic<int> counter{0};
  Temporary out;
  for (int i = 0; out.fd < 0 && i < kTries; ++i) {
    out.path = target.string() + fmt::format(".tmp{}-{}", ::getpid(), counter++);
    out.fd = ::open(out.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (out.fd < 0 && errno != EEXIST) break;
  }
  return out;
}

bool writeAll(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = ::write(file, content.data(), content.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

bool isStream(const fs::path& path) {
  struct stat st {};
  return ::stat(path.c_str(), &st) == 0 && !S_ISREG(st.st_mode) && !S_ISDIR(st.st_mode);
}

fs::path linkTarget(const fs::path& path) {
  constexpr int kLongestChain = 40;  // as the kernel has it
  fs::path end = path;
  std::error_code ec;
  for (int i = 0; i < kLongestChain && fs::is_symlink(fs::symlink_status(end, ec)); ++i) {
    const fs::path next = fs::read_symlink(end, ec);
    if (ec) break;
    end = next.is_absolute() ? next : end.parent_path() / next;
  }
  return end;
}

Result<void> writeFileAtomic(const fs::path& target, std::string_view content) {
  const auto refused = [&](std::string_view why) {
    return fail(Code::Input, "{}: cannot be written ({})", target.string(), why);
  };
  if (isStream(target)) {
    const int fd = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd < 0) return refused(reason());
    const bool ok = writeAll(fd, content);
    const std::string why = ok ? "" : reason();
    ::close(fd);
    if (!ok) return refused(why);
    return {};
  }
  const fs::path path = linkTarget(target);
  struct stat old {};
  const bool replaces = ::stat(path.c_str(), &old) == 0;
  // Renaming needs no leave of the file that is replaced, so it is asked here, the superuser too: whoever
  // takes the right to write away means it.
  if (replaces && ((old.st_mode & 0222) == 0 || ::access(path.c_str(), W_OK) != 0))
    return refused("it is read-only");
  const auto [fd, temporary] = createTemporary(path, replaces ? 0600 : 0666);
  if (fd < 0) return refused(reason());
  if (replaces) {  // the owner and what nobody else may are no reason to fail
    if (old.st_gid != ::getegid()) (void)!::fchown(fd, static_cast<uid_t>(-1), old.st_gid);
    (void)!::fchmod(fd, old.st_mode & 0777);
  }
  bool ok = writeAll(fd, content) && ::fsync(fd) == 0;
  std::string why = ok ? "" : reason();
  ::close(fd);
  if (ok && std::rename(temporary.c_str(), path.c_str()) != 0) {
    ok = false;
    why = reason();
  }
  if (!ok) {
    ::unlink(temporary.c_str());
    return refused(why);
  }
  // The new name itself reaches the disk with its folder; where folders cannot be synced nothing is lost.
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (const int dir = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); dir >= 0) {
    (void)::fsync(dir);
    ::close(dir);
  }
  return {};
}

Key fileStamp(const fs::path& path) {
  std::error_code ec;
  Hasher h;
  h.add(fs::absolute(path, ec).lexically_normal().string());
  struct stat st {};
  if (::stat(path.c_str(), &st) == 0) h.add(st.st_size).add(st.st_mtim.tv_sec).add(st.st_mtim.tv_nsec);
  return h.key();
}

fs::path cacheFolder() { return xdgFolder("XDG_CACHE_HOME", ".cache"); }
fs::path stateFolder() { return xdgFolder("XDG_STATE_HOME", ".local/state"); }
fs::path configFolder() { return xdgFolder("XDG_CONFIG_HOME", ".config"); }

fs::path executablePath() {
  std::error_code ec;
  return fs::read_symlink("/proc/self/exe", ec);
}

}  // namespace pileus
