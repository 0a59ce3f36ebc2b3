#pragma once
// Stopwatches in milliseconds.
#include <chrono>
#include <ctime>

namespace pileus {

class Stopwatch {
 public:
  double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }
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

/// CPU time of the calling thread.
class ThreadStopwatch {
 public:
  double ms() const { return now() - start_; }

 private:
  static double now() {
    timespec t{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * double(t.tv_sec) + 1e-6 * double(t.tv_nsec);
  }
  double start_ = now();
};

}  // namespace pileus
