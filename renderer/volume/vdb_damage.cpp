#include "renderer/volume/vdb_damage.h"

#include <fmt/core.h>
#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/util/Name.h>

#include <fstream>
#include <string_view>

#include "renderer/volume/brick_builder.h"
#include "renderer/volume/vdb_text.h"

namespace pileus::volume {
namespace {

/// OpenVDB reads no description of grids in which one is of a type it does not know. It is told of a type by
/// that name; none of its voxels are ever read.
struct Stranger : openvdb::FloatGrid {
  static void introduce(const std::string& type) {
    openvdb::GridBase::registerGrid(type,
                                    []() -> openvdb::GridBase::Ptr { return openvdb::FloatGrid::create(); });
  }
};

/// OpenVDB does not notice a file that ends too early: it goes on with zeros. This reads the header strictly
/// and compares where the grids should end with where the file does.
class Extent : private openvdb::io::Archive {
 public:
  Result<std::vector<ListedGrid>> read(const std::filesystem::path& path) {
    std::vector<ListedGrid> grids;
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
        return grids;
      }
      for (auto n = readGridCount(is); n > 0; --n) {
        openvdb::io::GridDescriptor grid;
        const std::string strange = readOne(is, grid);
        if (grid.getGridPos() < 0 || grid.getEndPos() < grid.getGridPos())
          return fail(Code::Input, "is damaged: a grid's position in the file is absurd");
        if (grid.getEndPos() > size)
          return fail(Code::Input, "is truncated: grid '{}' ends at byte {}, but the file has {}",
                      cleanText(grid.gridName()), grid.getEndPos(), size);
        grids.push_back({openvdb::io::GridDescriptor::nameAsString(grid.uniqueName()), strange});
        grid.seekToEnd(is);
      }
    } catch (const std::ios_base::failure&) {
      return fail(Code::Input, "is truncated: it ends after {} bytes, within the description of its grids",
                  size);
    }
    return grids;
  }

 private:
  /// The name of its type, if nobody here knows it.
  static std::string readOne(std::istream& is, openvdb::io::GridDescriptor& grid) {
    const auto begin = is.tellg();
    try {
      grid.read(is);
      return {};
    } catch (const openvdb::LookupError&) {
      static constexpr std::string_view kHalf = "_HalfFloat";  // how the type of numbers kept in halves ends
      is.seekg(begin);
      openvdb::readString(is);
      std::string type = openvdb::readString(is);
      if (type.ends_with(kHalf)) type.resize(type.size() - kHalf.size());
      if (openvdb::GridBase::isRegistered(type)) throw;
      Stranger::introduce(type);
      is.seekg(begin);
      grid.read(is);
      return type;
    }
  }
};

}  // namespace

Result<std::vector<ListedGrid>> listGrids(const std::filesystem::path& path) { return Extent().read(path); }

int newestVdbFormat() { return openvdb::OPENVDB_FILE_VERSION; }

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
