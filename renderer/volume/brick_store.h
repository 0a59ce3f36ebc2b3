#pragma once
// A BrickGrid as one seekable file: header, metadata, tables, then payloads aligned to 4 KiB so that they can
// be mapped and streamed. Little-endian. Everything is covered by checksums: a damaged file is an error,
// never a wrong picture.
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/result.h"
#include "renderer/volume/brick_grid.h"

namespace pileus::volume {

inline constexpr std::uint32_t kStoreVersion = 1;

struct StoredGrid {
  GridPtr grid;
  std::vector<std::string> notes;  ///< warnings of the import, shown again whenever the file is used
};

/// Temporary file beside the target, then rename. Error (Input): the path and the reason.
Result<void> writeStore(const std::filesystem::path& path, const BrickGrid& grid,
                        const std::vector<std::string>& notes = {});
/// Its bytes, in order, to `sink` until that says false.
bool writeStoreTo(const BrickGrid& grid, const std::vector<std::string>& notes,
                  const std::function<bool(std::string_view)>& sink);
/// Maps the file; the grid keeps it mapped. Error (Input): missing, another version, damaged (what is wrong).
Result<StoredGrid> readStore(const std::filesystem::path& path);
/// What a process that was killed while it wrote that store has left of it.
void removeTemporaries(const std::filesystem::path& store, long process);
/// Deletes the files of `folder` used longest ago until they take at most maxBytes together, and what was
/// begun long ago and never finished.
void pruneStores(const std::filesystem::path& folder, std::uint64_t maxBytes);

}  // namespace pileus::volume
