#pragma once
// Words about .vdb files for messages and listings.
#include <string>
#include <string_view>

namespace pileus::volume {

/// Text from a hostile file as UTF-8: printable, on one line, not too long. What is no UTF-8 is read as
/// Latin-1.
std::string cleanText(std::string_view text, std::size_t longest = 120);
/// OpenVDB's type of a transform in plain words.
std::string transformWords(const std::string& mapType);

}  // namespace pileus::volume
