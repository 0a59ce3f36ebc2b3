#include "renderer/volume/vdb_import.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <fstream>

#include "renderer/base/file.h"
#include "renderer/base/log.h"
#include "renderer/volume/brick_store.h"
#include "renderer/volume/byte_stream.h"
#include "renderer/volume/child_process.h"
#include "renderer/volume/file_kind.h"
#include "renderer/volume/vdb_child.h"
#include "renderer/volume/vdb_damage.h"

namespace fs = std::filesystem;

namespace pileus::volume {
namespace {

constexpr std::uint64_t kCacheBytes = std::uint64_t(16) << 30;
constexpr std::size_t kMaxMessage = 1024;

/// `passing`: the file is not to blame, it may be read later.
Error about(const fs::path& path, Code code, std::string_view reason, bool passing = false) {
  std::string message = fmt::format("{}: {}", path.string(), reason);
  if (message.size() > kMaxMessage) message = message.substr(0, kMaxMessage - 3) + "...";
  return Error{code, std::move(message), passing};
}

/// Behind what is wrong with a file: perhaps its format is one that this build has never seen.
std::string newerFormat(const fs::path& path) {
  const int format = vdbFormatOf(path);
  if (format <= newestVdbFormat()) return {};
  return fmt::format("; it is of file format {}, this Pileus knows formats up to {}", format,
                     newestVdbFormat());
}

/// Printable part of what a library wrote, on one line.
std::string_view lastLine(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
  const auto at = text.rfind('\n');
  return at == std::string_view::npos ? text : text.substr(at + 1);
}

/// Behind the end of a child: what it has begun of a store and not finished.
struct Leftovers {
  fs::path store;
  long process = 0;
  ~Leftovers() {
    if (process > 0 && !store.empty()) removeTemporaries(store, process);
  }
};

/// A file without a name, in memory: where a store goes that finds no room on a disk.
class MemoryFile {
 public:
  MemoryFile() = default;
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    if (file_ >= 0) ::close(file_);
  }
  bool append(std::string_view bytes) {
    if (file_ < 0) file_ = ::memfd_create("bricks", MFD_CLOEXEC);
    return file_ >= 0 && writeAll(file_, bytes);
  }
  bool holdsAny() const { return file_ >= 0; }
  fs::path path() const { return fmt::format("/proc/self/fd/{}", file_); }

 private:
  int file_ = -1;
};

/// What a child works on: for importing, the store it writes and where its bytes go instead.
struct ChildWork {
  fs::path store;
  MemoryFile* instead = nullptr;
};

/// Runs the child to its end and returns the content of its Info or Done message.
Result<std::string> runChild(const fs::path& path, std::vector<std::string> arguments, JobControl& control,
                             const ImportLimits& limits, const ChildWork& into = {}) {
  Leftovers leftovers{into.store, 0};  // cleared after the child's own end
  arguments.push_back(std::to_string(limits.memoryBytes));
  arguments.push_back(std::to_string(static_cast<long>(limits.cpuSeconds)));
  auto started =
      ChildProcess::start(limits.executable.empty() ? executablePath() : limits.executable, arguments);
  if (!started) return about(path, Code::Internal, started.error().message, true);
  ChildProcess& child = *started;
  leftovers.process = child.id();
  const auto begin = std::chrono::steady_clock::now();
  std::optional<Message> answer;
  for (bool open = true; open;) {
    open = child.read(std::chrono::milliseconds(20));
    if (control.cancelled()) return fail(Code::Cancelled, "cancelled");  // the destructor kills
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > limits.wallSeconds)
      return about(path, Code::Input, fmt::format("reading it took longer than {} s", limits.wallSeconds),
                   true);
    while (true) {
      auto message = takeMessage(child.out);
      if (!message) return message.error();
      if (!*message) break;
      if ((*message)->kind == MessageKind::Progress)
        control.progress(ByteReader((*message)->content).take<double>());
      else if ((*message)->kind == MessageKind::Store) {
        if (!into.instead || !into.instead->append((*message)->content))
          return about(
              path, Code::Internal,
              fmt::format("its bricks fit neither into the cache nor into memory ({})", std::strerror(errno)),
              true);
      } else
        answer = std::move(**message);
    }
  }
  const int status = child.wait();
  if (answer && answer->kind == MessageKind::Error) {
    ByteReader r(answer->content);
    const auto code = r.take<std::int32_t>();
    return about(path, code >= 1 && code <= 6 ? static_cast<Code>(code) : Code::Internal,
                 r.takeText() + newerFormat(path));
  }
  if (WIFSIGNALED(status)) {
    const int s = WTERMSIG(status);
    if (s == SIGXCPU)
      return about(path, Code::Input, fmt::format("reading it took longer than {} s", limits.cpuSeconds),
                   true);
    return about(path, Code::Input,
                 fmt::format("the file is damaged: its reader was stopped by signal {} ({}){}", s,
                             ::strsignal(s), newerFormat(path)));
  }
  if (answer && WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::move(answer->content);
  return about(path, Code::Internal,
               fmt::format("its reader ended with status {} and no answer; {}", status, lastLine(child.err)),
               true);
}

/// What a store keeps beside the grid: warnings, and after a mark the names of the file's other grids.
ImportedGrid fromStore(GridPtr grid, std::vector<std::string> notes) {
  ImportedGrid out;
  out.grid = std::move(grid);
  for (std::string& note : notes) {
    if (note == kWasLevelSet) {
      out.levelSet = true;
      continue;
    }
    if (note.starts_with(kOtherGrid))
      out.others.push_back(note.substr(kOtherGrid.size()));
    else
      out.warnings.push_back(std::move(note));
  }
  return out;
}

fs::path storeFolder() {
  const fs::path folder = cacheFolder() / "bricks";
  std::error_code ec;
  fs::create_directories(folder, ec);
  return folder;
}

}  // namespace

Result<VdbInfo> inspectVdb(const fs::path& path, JobControl& control, const ImportLimits& limits) {
  if (auto refused = whyNotVdb(path)) return about(path, Code::Input, *refused);
  PILEUS_TRY(const std::string content,
             runChild(path, {"import", "inspect", path.string()}, control, limits));
  auto info = decodeInfo(content);
  if (!info) return about(path, Code::Internal, "its reader's answer is malformed");
  return std::move(*info);
}

Result<ImportedGrid> importVdb(const fs::path& path, const std::string& gridName, JobControl& control,
                               const ImportLimits& limits, LevelSets levelSets) {
  if (auto refused = whyNotVdb(path)) return about(path, Code::Input, *refused);
  static constexpr std::string_view kReading = "vdb 3";  // another, once other bricks are made of a file
  const std::string surfaces(enumId(levelSets));
  const Key key =
      Hasher().add(fileStamp(path)).add(gridName).add(surfaces).add(kStoreVersion).add(kReading).key();
  const fs::path folder = storeFolder(), store = folder / (key.hex() + ".bricks");
  std::error_code ec;
  if (fs::exists(store, ec)) {
    if (auto stored = readStore(store)) {
      fs::last_write_time(store, fs::file_time_type::clock::now(), ec);  // used now: pruned last
      return fromStore(stored->grid, std::move(stored->notes));
    } else {
      log::info("reading {} again, because its cached bricks cannot be used: {}", path.string(),
                stored.error().message);
    }
  }
  MemoryFile memory;
  PILEUS_TRY(const std::string unwritten,
             runChild(path, {"import", "grid", path.string(), gridName, store.string(), surfaces}, control,
                      limits, {store, &memory}));
  auto stored = readStore(memory.holdsAny() ? memory.path() : store);
  if (!stored)
    return about(path, Code::Internal,
                 fmt::format("its bricks cannot be read back: {}", stored.error().message), true);
  ImportedGrid out = fromStore(stored->grid, std::move(stored->notes));
  if (memory.holdsAny())
    out.warnings.push_back(fmt::format("the file is read without the cache, each time anew: {}", unwritten));
  else
    pruneStores(folder, kCacheBytes);
  return out;
}

}  // namespace pileus::volume
