#pragma once
// Hue and saturation of linear colours, and their intensity (the largest channel, without limit). Pure.
#include "renderer/base/math.h"

namespace pileus::editor {

struct Hsv {
  double hue = 0;         ///< turns, 0..1: red at 0
  double saturation = 0;  ///< 0..1
  double value = 1;       ///< the largest channel
};

/// Of a colour without negative channels. Grey has no hue and black no saturation: they are those of `like`.
Hsv hsvOf(const dvec3& rgb, const Hsv& like = {});
dvec3 rgbOf(const Hsv& hsv);

}  // namespace pileus::editor
