#include "renderer/volume/brick_store.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>

#include "renderer/base/byte_stream.h"
#include "renderer/base/file.h"
#include "renderer/volume/brick_builder.h"

namespace fs = std::filesystem;

namespace pileus::volume {
namespace {

static_assert(std::endian::native == std::endian::little, "the store is written as it lies in memory");

constexpr char kMagic[8] = {'P', 'I', 'L', 'E', 'U', 'S', 'B', 'R'};
constexpr std::uint64_t kAlignment = 4096;

struct Header {
  char magic[8];
  std::uint32_t version, payloadCount;
  std::uint64_t fileSize, metaSize, tableSize, payloadOffset;
  Key metaKey;  ///< of metadata and tables, which follow the header in this order
  Key content;  ///< BrickGrid::content
  Key ownKey;   ///< of the header before this field
};
static_assert(sizeof(Header) == 96 && std::is_trivially_copyable_v<Header>);

Key keyOfHeader(const Header& h) {
  return hashBytes({reinterpret_cast<const std::byte*>(&h), offsetof(Header, ownKey)});
}

std::string metadata(const BrickGrid& g, const std::vector<std::string>& notes) {
  ByteWriter w;
  w.put(g.name);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) w.put(g.worldFromIndex[c][r]);
  for (int a = 0; a < 3; ++a) w.put(g.origin[a]).put(g.indexBounds.min[a]).put(g.indexBounds.max[a]);
  w.put(g.voxelSize).put(g.minimum).put(g.maximum).put(g.activeVoxels);
  w.put(static_cast<std::uint32_t>(g.levels.size()));
  for (const Level& level : g.levels) w.put(level.bricks.x).put(level.bricks.y).put(level.bricks.z);
  w.put(static_cast<std::uint32_t>(notes.size()));
  for (const std::string& n : notes) w.put(n);
  return w.bytes();
}

/// Null: well-formed. Otherwise what is wrong.
const char* parseMetadata(std::string_view bytes, BrickGrid& g, std::vector<std::string>& notes) {
  ByteReader r(bytes);
  g.name = r.takeText();
  for (int c = 0; c < 4; ++c)
    for (int row = 0; row < 4; ++row) g.worldFromIndex[c][row] = r.take<double>();
  for (int a = 0; a < 3; ++a) {
    g.origin[a] = r.take<int>();
    g.indexBounds.min[a] = r.take<double>();
    g.indexBounds.max[a] = r.take<double>();
  }
  g.voxelSize = r.take<double>();
  g.minimum = r.take<float>();
  g.maximum = r.take<float>();
  g.activeVoxels = r.take<std::uint64_t>();
  const auto levels = r.take<std::uint32_t>();
  if (!r.ok() || levels > 32) return "its metadata is damaged";
  for (std::uint32_t l = 0; l < levels; ++l) {
    ivec3 size;
    for (int a = 0; a < 3; ++a) size[a] = r.take<int>();
    const bool sane =
        glm::all(glm::greaterThan(size, ivec3(0))) && glm::all(glm::lessThanEqual(size, ivec3(1 << 16)));
    if (!sane || (l > 0 && size != (g.levels.back().bricks + 1) / 2)) return "its level sizes are damaged";
    g.levels.push_back({size, {}});
  }
  const auto count = r.take<std::uint32_t>();
  for (std::uint32_t i = 0; i < count && r.ok(); ++i) notes.push_back(r.takeText());
  return r.ok() && r.done() ? nullptr : "its metadata is damaged";
}

const char* parseTables(std::string_view bytes, BrickGrid& g) {
  std::uint64_t wanted = 0;
  for (const Level& level : g.levels)
    wanted += std::uint64_t(level.bricks.x) * std::uint64_t(level.bricks.y) * std::uint64_t(level.bricks.z) *
              sizeof(Brick);
  if (wanted != bytes.size()) return "its tables have the wrong size";
  for (Level& level : g.levels) {
    level.table.resize(std::size_t(level.bricks.x) * std::size_t(level.bricks.y) *
                       std::size_t(level.bricks.z));
    std::memcpy(level.table.data(), bytes.data(), level.table.size() * sizeof(Brick));
    bytes.remove_prefix(level.table.size() * sizeof(Brick));
    for (const Brick& b : level.table) {
      if (b.payload != kConstantBrick && b.payload >= g.payloadCount)
        return "a brick points outside the file";
      if (!std::isfinite(b.offset) || !std::isfinite(b.scale)) return "a brick's range is not a number";
    }
  }
  return nullptr;
}

struct Mapping {
  const std::byte* data = nullptr;
  std::size_t size = 0;
  ~Mapping() {
    if (data) ::munmap(const_cast<std::byte*>(data), size);
  }
};

/// Nothing is written to a store for so long without a pause.
constexpr std::chrono::hours kLongestWrite{1};

bool isTemporary(const fs::path& path) { return path.extension().string().starts_with(".tmp"); }

}  // namespace

bool writeStoreTo(const BrickGrid& grid, const std::vector<std::string>& notes,
                  const std::function<bool(std::string_view)>& sink) {
  std::string front = metadata(grid, notes);
  Header h{};
  std::memcpy(h.magic, kMagic, sizeof kMagic);
  h.version = kStoreVersion;
  h.payloadCount = grid.payloadCount;
  h.metaSize = front.size();
  for (const Level& level : grid.levels)
    front.append(reinterpret_cast<const char*>(level.table.data()), level.table.size() * sizeof(Brick));
  h.tableSize = front.size() - h.metaSize;
  h.payloadOffset = (sizeof h + front.size() + kAlignment - 1) / kAlignment * kAlignment;
  const std::size_t payloadSize = std::size_t(grid.payloadCount) * kStoredVoxels;
  h.fileSize = h.payloadOffset + payloadSize;
  h.metaKey = hashBytes({reinterpret_cast<const std::byte*>(front.data()), front.size()});
  h.content = grid.content;
  h.ownKey = keyOfHeader(h);
  front.insert(0, reinterpret_cast<const char*>(&h), sizeof h);
  front.resize(static_cast<std::size_t>(h.payloadOffset), '\0');
  return sink(front) && sink({reinterpret_cast<const char*>(grid.payload.get()), payloadSize});
}

Result<void> writeStore(const fs::path& path, const BrickGrid& grid, const std::vector<std::string>& notes) {
  const auto [fd, temporary] = createTemporary(path, 0644);
  if (fd < 0) return fail(Code::Input, "{}: cannot be written ({})", path.string(), std::strerror(errno));
  bool ok = writeStoreTo(grid, notes, [&](std::string_view bytes) { return writeAll(fd, bytes); });
  int why = errno;
  if (::close(fd) != 0 && ok)
    ok = false, why = errno;  // no fsync: a cache whose damage is noticed and repaired
  if (ok && std::rename(temporary.c_str(), path.c_str()) != 0) ok = false, why = errno;
  if (ok) return {};
  ::unlink(temporary.c_str());
  return fail(Code::Input, "{}: cannot be written ({})", path.string(), std::strerror(why));
}

Result<StoredGrid> readStore(const fs::path& path) {
  const auto damaged = [&](const char* what) { return fail(Code::Input, "{}: {}", path.string(), what); };
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return damaged(std::strerror(errno));
  struct stat st {};
  const bool regular = ::fstat(fd, &st) == 0 && S_ISREG(st.st_mode);
  auto mapping = std::make_shared<Mapping>();
  if (regular && static_cast<std::size_t>(st.st_size) >= sizeof(Header)) {
    mapping->size = static_cast<std::size_t>(st.st_size);
    void* p = ::mmap(nullptr, mapping->size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (p != MAP_FAILED) mapping->data = static_cast<const std::byte*>(p);
  }
  ::close(fd);
  if (!mapping->data) return damaged("too short for a brick store");
  Header h;
  std::memcpy(&h, mapping->data, sizeof h);
  if (std::memcmp(h.magic, kMagic, sizeof kMagic) != 0) return damaged("not a brick store");
  if (h.version != kStoreVersion) return damaged("a brick store of another version");
  if (h.ownKey != keyOfHeader(h)) return damaged("its header is damaged");
  if (h.fileSize != mapping->size) return damaged("it is not as long as its header says");
  const std::uint64_t room = h.fileSize - sizeof h;
  if (h.metaSize > room || h.tableSize > room - h.metaSize ||
      h.payloadOffset < sizeof h + h.metaSize + h.tableSize || h.payloadOffset > h.fileSize ||
      h.payloadOffset % kAlignment != 0 ||
      h.fileSize - h.payloadOffset != std::uint64_t(h.payloadCount) * kStoredVoxels)
    return damaged("its sections do not fit");
  const std::byte* front = mapping->data + sizeof h;
  if (hashBytes({front, static_cast<std::size_t>(h.metaSize + h.tableSize)}) != h.metaKey)
    return damaged("its tables are damaged");
  const std::string_view text(reinterpret_cast<const char*>(front),
                              static_cast<std::size_t>(h.metaSize + h.tableSize));

  StoredGrid stored;
  auto grid = std::make_shared<BrickGrid>();
  grid->payloadCount = h.payloadCount;
  if (const char* what = parseMetadata(text.substr(0, h.metaSize), *grid, stored.notes)) return damaged(what);
  if (const char* what = parseTables(text.substr(h.metaSize), *grid)) return damaged(what);
  if (h.payloadCount > 0) grid->payload = {mapping, mapping->data + h.payloadOffset};
  grid->content = h.content;
  if (contentKeyOf(*grid) != h.content) return damaged("its voxels are damaged");
  stored.grid = std::move(grid);
  return stored;
}

void removeTemporaries(const fs::path& store, long process) {
  const std::string begin = store.filename().string() + fmt::format(".tmp{}-", process);
  std::error_code ec;
  std::vector<fs::path> left;
  for (const auto& e : fs::directory_iterator(store.parent_path(), ec))
    if (e.path().filename().string().starts_with(begin)) left.push_back(e.path());
  for (const fs::path& path : left) fs::remove(path, ec);
}

void pruneStores(const fs::path& folder, std::uint64_t maxBytes) {
  struct Entry {
    fs::file_time_type used;
    std::uint64_t bytes;
    fs::path path;
  };
  std::error_code ec;
  std::vector<Entry> entries;
  std::uint64_t total = 0;
  const auto now = fs::file_time_type::clock::now();
  for (const auto& e : fs::directory_iterator(folder, ec)) {
    std::error_code one;
    if (!e.is_regular_file(one)) continue;
    if (isTemporary(e.path())) {  // being written, or left behind by one that was killed
      if (now - e.last_write_time(one) > kLongestWrite) fs::remove(e.path(), one);
      continue;
    }
    entries.push_back({e.last_write_time(one), e.file_size(one), e.path()});
    total += entries.back().bytes;
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
  for (const Entry& e : entries) {
    if (total <= maxBytes) break;
    if (fs::remove(e.path, ec)) total -= e.bytes;
  }
}

}  // namespace pileus::volume
