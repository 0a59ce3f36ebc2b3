#pragma once
// GPU milliseconds of a span of commands, read when the result is there (a frame or two later on a GPU, at
// once on llvmpipe).
#include <epoxy/gl.h>

#include <deque>

namespace pileus::gl {

class GpuTimer {
 public:
  GpuTimer() = default;
  ~GpuTimer();
  GpuTimer(const GpuTimer&) = delete;
  GpuTimer& operator=(const GpuTimer&) = delete;
  void begin();
  void end();
  /// Sum of the spans that finished since the last call; never waits.
  double takeMs();

 private:
  std::deque<GLuint> waiting_;
};

}  // namespace pileus::gl
