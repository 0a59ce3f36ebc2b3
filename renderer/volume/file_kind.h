#pragma once
// What a file looks like, for the message when it is not what was asked for.
#include <filesystem>
#include <optional>
#include <string>

namespace pileus::volume {

/// Nothing: the file exists, can be read and begins like a VDB. Otherwise why not, and what it looks like
/// instead.
std::optional<std::string> whyNotVdb(const std::filesystem::path& path);

/// The file format that the header of a .vdb file claims; 0: it has none.
int vdbFormatOf(const std::filesystem::path& path);

}  // namespace pileus::volume
