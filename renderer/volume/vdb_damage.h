#pragma once
// What betrays a damaged .vdb file before, or although, OpenVDB reads it.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/math.h"
#include "renderer/base/result.h"

namespace pileus::volume {

/// The newest file format that is known here: 224.
int newestVdbFormat();
struct ListedGrid {
  std::string name;     ///< as OpenVDB addresses it
  std::string strange;  ///< its type, if nobody here knows it: it must not be read
};
/// What the header lists (nothing for a file that was written to a stream). Error (Input): the file is not as
/// long as its header says. Throws what OpenVDB throws on a header that it refuses.
Result<std::vector<ListedGrid>> listGrids(const std::filesystem::path& path);
/// file_bbox is never trusted, but one that claims an absurd size for a tree that holds nothing betrays a
/// damaged file; an empty or inverted one only says that there is nothing.
std::optional<std::string> absurdBounds(ivec3 lowest, ivec3 highest);

}  // namespace pileus::volume
