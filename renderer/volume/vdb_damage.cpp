#include "renderer/volume/vdb_damage.h"

#include <fmt/core.h>
#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <openvdb/io/Stream.h>

#include <fstream>

#include "renderer/volume/brick_builder.h"
#include "renderer/volume/vdb_text.h"

namespace pileus::volume {
namespace {

/// OpenVDB does not notice a file that ends too early: it goes on with zeros. This reads the header strictly
/// and compares where the grids should end with where the file does.
class Extent : private openvdb::io::Archive {
 public:
  std::string read(const std::filesystem::path& path) {
    const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path));
    std::ifstream is(path, std::ios::binary);
    try {
      is.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
      readHeader(is);
      setFormatVersion(is);
      setLibraryVersion(is);
      openvdb::MetaMap metadata;
      metadata.readMeta(is);
      if (!inputHasGridOffsets()) {  // written to a stream: only reading it through tells
        is.seekg(0);
        openvdb::io::Stream whole(is, false);
        return {};
      }
      for (auto n = readGridCount(is); n > 0; --n) {
        openvdb::io::GridDescriptor grid;
        grid.read(is);
        if (grid.getGridPos() < 0 || grid.getEndPos() < grid.getGridPos())
          return "is damaged: a grid's position in the file is absurd";
        if (grid.getEndPos() > size)
          return fmt::format("is truncated: grid '{}' ends at byte {}, but the file has {}",
                             cleanText(grid.gridName()), grid.getEndPos(), size);
        grid.seekToEnd(is);
      }
    } catch (const std::ios_base::failure&) {
      return fmt::format("is truncated: it ends after {} bytes, within the description of its grids", size);
    }
    return {};
  }
};

}  // namespace

std::string whatIsMissing(const std::filesystem::path& path) { return Extent().read(path); }

std::optional<std::string> absurdBounds(ivec3 lowest, ivec3 highest) {
  std::int64_t largest = 0;
  for (int a = 0; a < 3; ++a) {
    const std::int64_t extent = std::int64_t(highest[a]) - lowest[a] + 1;
    if (extent <= 0) return std::nullopt;
    largest = std::max(largest, extent);
  }
  if (largest <= BuildLimits{}.extent) return std::nullopt;
  return fmt::format("it claims bounds {} voxels wide, but holds no voxels: the file is damaged", largest);
}

}  // namespace pileus::volume
