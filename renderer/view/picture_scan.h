#pragma once
// What is in a picture as a whole: how often which exposure occurs, and how far its depths reach. From a
// reduced copy, read without waiting; made anew only when the picture has changed. GL thread, but scanTexels.
#include <array>
#include <memory>
#include <span>

#include "renderer/view/picture.h"
#include "renderer/view/texel_reader.h"

namespace pileus::view {

/// Bins of exposure: stops around middle grey.
struct Histogram {
  static constexpr int kBins = 96;
  static constexpr double kLowest = -10, kHighest = 8;
  /// Red, green, blue and luminance: parts of all texels looked at.
  std::array<std::array<float, kBins>, 4> parts{};
  float black = 0;  ///< part of texels whose luminance is below the first bin, black ones included
  static double stopOf(int bin) { return kLowest + (kHighest - kLowest) * (bin + 0.5) / kBins; }
};

struct ScanResult {
  Histogram histogram;
  vec2 depth{0};      ///< of a depth layer: of all but the outermost hundredths; 0 0: nothing there
  vec4 lo{0}, hi{0};  ///< smallest and largest finite values
  std::size_t texels = 0, notFinite = 0;
};
ScanResult scanTexels(std::span<const vec4> texels);

class PictureScan {
 public:
  /// Begins a scan if `picture` has changed since the last one, at most every `restMs` while it still
  /// improves; takes in the one on its way. True: there is a new result.
  bool follow(const std::shared_ptr<const Picture>& picture, double nowMs, double restMs = 250);
  bool busy() const { return reader_.busy(); }
  /// Null before the first.
  const ScanResult* result() const { return result_ ? &*result_ : nullptr; }
  void forget() { result_.reset(), scanned_.reset(), reader_.forget(); }

 private:
  TexelReader reader_;
  Picture reduced_;
  std::weak_ptr<const Picture> scanned_;
  int samples_ = -1;
  double fraction_ = -1, at_ = -1e9;
  std::optional<ScanResult> result_;
};

}  // namespace pileus::view
