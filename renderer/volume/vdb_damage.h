#pragma once
// What betrays a damaged .vdb file before, or although, OpenVDB reads it.
#include <filesystem>
#include <optional>
#include <string>

#include "renderer/base/math.h"

namespace pileus::volume {

/// Empty: the file is as long as its header says. Throws what OpenVDB throws on a header that it refuses.
std::string whatIsMissing(const std::filesystem::path& path);
/// file_bbox is never trusted, but one that claims an absurd size for a tree that holds nothing betrays a
/// damaged file; an empty or inverted one only says that there is nothing.
std::optional<std::string> absurdBounds(ivec3 lowest, ivec3 highest);

}  // namespace pileus::volume
