#pragma once
// Stopwatches in milliseconds.
#include <chrono>
#include <ctime>

namespace pileus {

class Stopwatch {
 public:
  double ms() const { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count(); }
  void restart() { start_ = std::chrono::steady_clock::now(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// CPU time of this process, all threads together: what other programs do meanwhile hardly counts.
class CpuStopwatch {
 public:
  double ms() const { return 1e3 * double(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace pileus
