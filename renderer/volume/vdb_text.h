#pragma once
// Words about .vdb files for messages and listings.
#include <string>
#include <string_view>

namespace pileus::volume {

/// Text from a hostile file: printable, on one line, not too long.
std::string cleanText(std::string_view text, std::size_t longest = 120);
/// OpenVDB's type of a transform in plain words.
std::string transformWords(const std::string& mapType);

}  // namespace pileus::volume
