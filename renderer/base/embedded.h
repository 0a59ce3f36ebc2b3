#pragma once
// A file linked into the binary (shaders, fonts, presets, the OCIO config).
#include <string_view>

namespace pileus {

struct EmbeddedFile {
  std::string_view path;  ///< relative, with forward slashes
  std::string_view bytes;
};

}  // namespace pileus
