#pragma once
// The pictures of a shoot-out side by side, each over its signed difference from the truth. Any thread.
#include <string>

#include "renderer/image/color.h"
#include "renderer/image/text.h"
#include "renderer/truth/shootout.h"

namespace pileus::truth {

struct SheetOptions {
  std::string title, subtitle;
  std::string display, view;  ///< "" = the config's default
  double exposure = 0;        ///< stops
};

/// Display-referred. Below each picture: where it is too dark (blue) or lets light leak (red), full colour at
/// a quarter of the truth's 99th percentile of luminance. Error (Arguments) where display or view do not
/// exist.
Result<image::Canvas> contactSheet(const std::vector<ShootoutEntry>& entries,
                                   const image::ColorConfig& config, const SheetOptions& options);

/// `v` in [-1, 1] -> blue, near black, red; clamped. Display-referred.
vec3 signedColor(double v);

}  // namespace pileus::truth
