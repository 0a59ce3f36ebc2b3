#pragma once
// Names as files and searches take them. ASCII letters alone have two cases; other bytes stay.
#include <string>
#include <string_view>

namespace pileus {

inline char lowered(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

inline std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = lowered(c);
  return out;
}

/// Its ASCII letters and digits, and one `gap` for all that stands between them: "Dusk / low sun" is
/// "Dusk-low-sun".
inline std::string plainName(std::string_view name, char gap) {
  std::string out;
  for (const char c : name) {
    const char low = lowered(c);
    if ((low >= 'a' && low <= 'z') || (c >= '0' && c <= '9'))
      out += c;
    else if (!out.empty() && out.back() != gap)
      out += gap;
  }
  while (!out.empty() && out.back() == gap) out.pop_back();
  return out;
}

}  // namespace pileus
