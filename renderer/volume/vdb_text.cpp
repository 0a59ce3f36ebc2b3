#include "renderer/volume/vdb_text.h"

#include <map>

namespace pileus::volume {

namespace {

/// How many bytes the character at `at` has in UTF-8; 0: none begins there.
std::size_t characterAt(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : (first & 0xF0) == 0xE0        ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xC0) != 0x80) return 0;
  if (length > 2) {  // no longer than needed, no half of a pair, none beyond the last
    const unsigned char second = byte(at + 1);
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F))
      return 0;
  }
  return length;
}

bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = characterAt(text, i);
    if (n == 0) return false;
    i += n;
  }
  return true;
}

std::string fromLatin1(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    if (u < 0x80)
      out += c;
    else
      out += {static_cast<char>(0xC0 | (u >> 6)), static_cast<char>(0x80 | (u & 0x3F))};
  }
  return out;
}

}  // namespace

std::string cleanText(std::string_view raw, std::size_t longest) {
  const std::string text = isUtf8(raw) ? std::string(raw) : fromLatin1(raw);
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = characterAt(text, i);
    if (i + n > longest) return out + "...";
    const auto u = static_cast<unsigned char>(text[i]);
    const bool control = u < 32 || u == 127 || (u == 0xC2 && static_cast<unsigned char>(text[i + 1]) < 0xA0);
    out += control ? "?" : text.substr(i, n);
    i += n;
  }
  return out;
}

std::string transformWords(const std::string& mapType) {
  static const std::map<std::string, std::string> words = {
      {"UniformScaleMap", "uniform scale"},
      {"UniformScaleTranslateMap", "uniform scale and translation"},
      {"ScaleMap", "scale"},
      {"ScaleTranslateMap", "scale and translation"},
      {"TranslationMap", "translation"},
      {"UnitaryMap", "rotation"},
      {"AffineMap", "affine"},
      {"NonlinearFrustumMap", "frustum (not affine)"}};
  const auto it = words.find(mapType);
  return it == words.end() ? cleanText(mapType) : it->second;
}

}  // namespace pileus::volume
