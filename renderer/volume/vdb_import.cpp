#include "renderer/volume/vdb_import.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

#include "renderer/base/file.h"
#include "renderer/base/log.h"
#include "renderer/volume/brick_store.h"
#include "renderer/volume/file_kind.h"
#include "renderer/volume/vdb_child.h"
#include "renderer/volume/vdb_damage.h"

namespace fs = std::filesystem;

namespace pileus::volume {
namespace {

constexpr std::uint64_t kCacheBytes = std::uint64_t(16) << 30;

/// Behind what is wrong with a file: perhaps its format is one that this build has never seen.
std::string newerFormat(const fs::path& path) {
  const int format = vdbFormatOf(path);
  if (format <= newestVdbFormat()) return {};
  return fmt::format("; it is of file format {}, this Pileus knows formats up to {}", format,
                     newestVdbFormat());
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
  ImportWatch watch;
  watch.started = [&](long process) { leftovers.process = process; };
  watch.suffix = [&] { return newerFormat(path); };
  watch.store = [&](std::string_view part) -> Result<void> {
    if (into.instead && into.instead->append(part)) return {};
    return aboutFile(
        path, Code::Internal,
        fmt::format("its bricks fit neither into the cache nor into memory ({})", std::strerror(errno)),
        true);
  };
  return runImportChild(path, std::move(arguments), control, limits, watch);
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
  if (auto refused = whyNotVdb(path)) return aboutFile(path, Code::Input, *refused);
  PILEUS_TRY(const std::string content, runChild(path, {"inspect", path.string()}, control, limits));
  auto info = decodeInfo(content);
  if (!info) return aboutFile(path, Code::Internal, "its reader's answer is malformed");
  return std::move(*info);
}

Result<ImportedGrid> importVdb(const fs::path& path, const std::string& gridName, JobControl& control,
                               const ImportLimits& limits, LevelSets levelSets) {
  if (auto refused = whyNotVdb(path)) return aboutFile(path, Code::Input, *refused);
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
             runChild(path, {"grid", path.string(), gridName, store.string(), surfaces}, control, limits,
                      {store, &memory}));
  auto stored = readStore(memory.holdsAny() ? memory.path() : store);
  if (!stored)
    return aboutFile(path, Code::Internal,
                     fmt::format("its bricks cannot be read back: {}", stored.error().message), true);
  ImportedGrid out = fromStore(stored->grid, std::move(stored->notes));
  if (memory.holdsAny())
    out.warnings.push_back(fmt::format("the file is read without the cache, each time anew: {}", unwritten));
  else
    pruneStores(folder, kCacheBytes);
  return out;
}

}  // namespace pileus::volume
