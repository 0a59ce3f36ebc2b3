#include "renderer/base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace fs = std::filesystem;

namespace pileus {
namespace {

std::string reason() { return std::strerror(errno); }

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
  const fs::path folder =
      fs::temp_directory_path(ec) /
      fmt::format("pileus-{}{}", ::getuid(), underHome[0] == '.' ? underHome + 1 : underHome);
  fs::create_directories(folder, ec);
  return folder;
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

Result<void> writeFileAtomic(const fs::path& target, std::string_view content) {
  // A link stays a link: what it names is replaced.
  std::error_code ec;
  fs::path path = target;
  if (fs::is_symlink(fs::symlink_status(path, ec)))
    if (const fs::path real = fs::canonical(path, ec); !ec) path = real;
  struct stat old {};
  const mode_t mode = ::stat(path.c_str(), &old) == 0 ? old.st_mode & 0777 : 0644;
  const fs::path temporary = path.string() + fmt::format(".tmp{}", ::getpid());
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode | 0200);
  if (fd < 0) return fail(Code::Input, "{}: cannot be written ({})", path.string(), reason());
  std::size_t done = 0;
  bool ok = true;
  while (ok && done < content.size()) {
    const ssize_t n = ::write(fd, content.data() + done, content.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0)
      ok = false;
    else
      done += static_cast<std::size_t>(n);
  }
  ok = ok && ::fsync(fd) == 0;
  std::string why = ok ? "" : reason();
  ::close(fd);
  if (ok && std::rename(temporary.c_str(), path.c_str()) != 0) {
    ok = false;
    why = reason();
  }
  if (!ok) {
    ::unlink(temporary.c_str());
    return fail(Code::Input, "{}: cannot be written ({})", path.string(), why);
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
