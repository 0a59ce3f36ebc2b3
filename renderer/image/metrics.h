#pragma once
// Differences between pictures.
#include <vector>

#include "renderer/image/image.h"

namespace pileus::image {

struct ChannelDifference {
  std::string channel;  ///< "R", "layer.R"
  double rmse = 0, maximum = 0, mean = 0;  ///< of |a - b|
};

struct Difference {
  double rmse = 0;    ///< over RGB of the beauty, all pixels
  double relMse = 0;  ///< mean over RGB and pixels with reference alpha > 0.01 of (a-b)^2 / (b^2 + 0.01); b is the reference
  double maximum = 0; ///< largest |a - b| over all channels
  std::vector<ChannelDifference> channels;
};

/// a against the reference b. Error (Input) where sizes or channels differ.
Result<Difference> compare(const Image& a, const Image& b);

}  // namespace pileus::image
