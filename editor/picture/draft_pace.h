#pragma once
// How large a draft may be so that it is there in time: learnt from what the last ones took.
#include <algorithm>
#include <cmath>

namespace pileus::editor {

/// Milliseconds of one draft.
struct DraftTimes {
  double total = 0;
  double picture = 0;  ///< of that: the picture's own
  double maps = 0;     ///< everything before it that had to be made anew
};

class DraftPace {
 public:
  static constexpr int kLeastPixels = 2000, kMostPixels = 1 << 23;
  static constexpr int kLeastTexels = 48;

  explicit DraftPace(bool software)
      : pixels_(software ? 25000 : kMostPixels),
        texels_(software ? 128 : 256),
        mostTexels_(software ? 256 : 512) {}

  int pixels() const { return pixels_; }
  int texels() const { return texels_; }

  /// After a whole draft of `pixels` drawn. Steps are bounded, so that one slow frame does not spoil the
  /// next.
  void learn(const DraftTimes& times, int pixels, double targetMs) {
    if (times.maps > 0.6 * targetMs)
      texels_ = std::max(kLeastTexels, texels_ * 2 / 3);
    else if (times.maps > 0 && times.maps < 0.2 * targetMs)
      texels_ = std::min(mostTexels_, texels_ * 3 / 2);
    if (times.picture <= 0 || pixels < 1) return;
    const double room = std::max(targetMs - (times.total - times.picture), 0.3 * targetMs);
    const double wanted = pixels * room / std::max(times.picture, 0.2);
    // A draft that was as large as the whole picture says nothing on how much larger one could be.
    const double from = std::min(static_cast<double>(pixels_), 1.05 * pixels);
    const double next = std::clamp(wanted, 0.35 * from, 1.5 * from);
    // Small corrections are not worth a picture of another size.
    if (next < 0.9 * pixels_ || next > 1.1 * pixels_)
      pixels_ = static_cast<int>(
          std::clamp(next, static_cast<double>(kLeastPixels), static_cast<double>(kMostPixels)));
  }

 private:
  int pixels_, texels_, mostTexels_;
};

}  // namespace pileus::editor
