#pragma once
// How much work a dispatch is given, by how long the last one took: a GPU answers nothing else meanwhile, and
// drivers end what takes seconds. A value; pure.
#include <algorithm>

namespace pileus::gl {

struct Pace {
  static constexpr double kWantedMs = 20;  ///< grows while a dispatch takes less than half of it
  static constexpr double kLongMs = 100;   ///< shrinks above

  int now = 1, least = 1, most = 1;  ///< in units of whoever asks

  void took(double ms) {
    int next = now;
    if (ms < kWantedMs / 2)
      next = now <= most / 2 ? 2 * now : most;
    else if (ms > kLongMs)
      next = ms > 4 * kLongMs ? now / 4 : now / 2;
    now = std::clamp(next, least, most);
  }
};

}  // namespace pileus::gl
