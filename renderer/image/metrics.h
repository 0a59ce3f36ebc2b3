#pragma once
// Differences between pictures.
#include <vector>

#include "renderer/image/image.h"

namespace pileus::image {

struct ChannelDifference {
  std::string channel;                     ///< "R", "layer.R"
  double rmse = 0, maximum = 0, mean = 0;  ///< of |a - b|
};

struct Difference {
  double rmse = 0;     ///< over RGB of the beauty (the first layer where there is none), all pixels
  double relMse = 0;   ///< mean over RGB and pixels with reference alpha > 0.01 of (a-b)^2 / (b^2 + 0.01); b
                       ///< is the reference
  double maximum = 0;  ///< largest |a - b| over all channels
  std::vector<ChannelDifference> channels;
  std::size_t notFinite = 0;  ///< pixels with a value that is not finite, in some layer of either picture
};

/// a against the reference b. Error (Input) where sizes, data windows or channels differ. A value that is not
/// finite equals its like and is infinitely far from all else; a reference without any covered pixel is
/// compared over all pixels.
Result<Difference> compare(const Image& a, const Image& b);

}  // namespace pileus::image
