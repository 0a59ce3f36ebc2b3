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

/// How far a picture is from a noisy reference that comes in two independent halves.
struct ScaledRelMse {
  double value = 0;          ///< noise can bring it below 0; infinite where a value that counts is not finite
  double standardError = 0;  ///< of value; infinite of a single pixel
  double meanA = 0, meanB = 0;  ///< over RGB and the pixels that count
  double ratio = 1;             ///< meanA / meanB; 1 where both are black
  std::size_t pixels = 0;       ///< that count
};

/// Scaled relMSE of the beauties: the mean over RGB and the pixels with alpha of `a` above 0.01 (all of them
/// where it has no alpha) of (a - b1)(a - b2) / (b^2 + 0.01 m^2), b the mean of b1 and b2, m the mean of b
/// over those pixels and all channels. The noise of b1 and b2 drops out of the product, and by the product
/// alone: in b below the line it adds about 1.5 s^4, s being the relative standard deviation of a half. The
/// standard error comes from the spread over blocks of 4 x 4 pixels, so that errors which neighbours share
/// count; m is taken as known, and what of the spread is the picture's own error counts too, so that it is
/// rather too large. Where there is one block alone it comes from the spread over pixels. Error (Input) where
/// sizes, data windows or colours differ, or no pixel counts.
Result<ScaledRelMse> scaledRelMse(const Image& a, const Image& b1, const Image& b2);

/// Means of the beauty over blocks of `edge` x `edge` pixels; what is left at the right and below is left
/// out.
Image blocksOf(const Image& picture, int edge);

}  // namespace pileus::image
