#pragma once
// Images in memory: ordered named layers of float pixels, scene-linear, top row first.
#include <map>
#include <string>
#include <vector>

#include "renderer/base/math.h"
#include "renderer/base/result.h"

namespace pileus::image {

/// A layer "" holds the beauty (R,G,B,A without prefix in files); others are written as name.R etc.
struct Layer {
  std::string name;
  int channels = 4;           ///< 1 (Y), 3 (RGB) or 4 (RGBA, premultiplied)
  std::vector<float> pixels;  ///< height * width * channels, interleaved
  bool data = false;          ///< measures, no colours: written in 32 bits, one channel is called Z
};

struct Chromaticities {
  vec2 red{0.713f, 0.293f}, green{0.165f, 0.830f}, blue{0.128f, 0.044f},
      white{0.32168f, 0.33767f};  ///< ACEScg (AP1, D60)
};

struct Image {
  ivec2 size{0};
  ivec2 dataOrigin{0};        ///< data window min; display window is [0, displaySize)
  ivec2 displaySize{0};       ///< 0 = same as size
  std::vector<Layer> layers;  ///< at least the beauty
  Chromaticities chromaticities;
  std::map<std::string, std::string> metadata;  ///< string attributes

  const Layer* layer(std::string_view name) const {
    for (const Layer& l : layers)
      if (l.name == name) return &l;
    return nullptr;
  }
};

}  // namespace pileus::image
