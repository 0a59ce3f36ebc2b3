#include "renderer/volume/vdb_text.h"

#include <map>

namespace pileus::volume {

std::string cleanText(std::string_view text, std::size_t longest) {
  std::string out;
  for (char c : text.substr(0, longest)) {
    const auto u = static_cast<unsigned char>(c);
    out += u < 32 || u == 127 ? '?' : c;
  }
  if (text.size() > longest) out += "...";
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
