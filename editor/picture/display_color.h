#pragma once
// Scene-linear colours as the viewport shows them: through the display, view and look of the picture beside
// them. Kept until one of these changes.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/math.h"

namespace pileus::image {
class ColorConfig;
}

namespace pileus::editor {

struct Shown;

struct DisplayColors {
  std::weak_ptr<const image::ColorConfig> config;
  std::string transform;                               ///< display, view and look
  std::vector<std::pair<dvec3, std::uint32_t>> known;  ///< of this transform
  unsigned revision = 0;                               ///< changes with the transform
};

/// Follows the viewport's transform; once a frame before colours are asked for.
void updateDisplayColors(const Shown& shown, DisplayColors& colors);
/// Red in the lowest byte, alpha 1.
std::uint32_t displayColor(const Shown& shown, DisplayColors& colors, const dvec3& linear);
/// Many at once, not kept: RGBA, in place.
void toDisplay(const Shown& shown, std::span<vec4> colors);

}  // namespace pileus::editor
