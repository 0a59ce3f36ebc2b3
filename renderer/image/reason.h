#pragma once
// Messages of other libraries, made safe to show: their length and bytes may come from a hostile file.
#include <string>
#include <string_view>

namespace pileus::image {

/// At most 1 KB on one line: control characters and runs of white space become one space, bytes outside ASCII
/// '?'.
inline std::string clampReason(std::string_view text) {
  constexpr std::size_t kLongest = 1024;
  std::string out;
  for (const char c : text) {
    if (out.size() >= kLongest) return out + "...";
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte == 0x7f) {
      if (!out.empty() && out.back() != ' ') out += ' ';
    } else {
      out += byte < 0x80 ? c : '?';
    }
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

}  // namespace pileus::image
