#pragma once
// llvmpipe ends all loops of a shader invocation, without a word, once they have run 65535 times in total,
// and drivers of GPUs end what takes seconds. The dispatches a march takes to stay below, by what it may cost
// (shaders/lib/resume.glsl), and on a GPU by what they took. GL thread.
#include "renderer/gl/buffer.h"
#include "renderer/gl/context.h"
#include "renderer/gl/pace.h"
#include "renderer/gl/shader_library.h"

namespace pileus::residency {

/// Upper bounds, in loop iterations.
struct MarchCost {
  double pixel = 0;                       ///< the whole of one ray
  int stretch = 0, step = 0, sample = 0;  ///< of their lists and lights, without shadow marches
  int reached = 1;                        ///< lights of which something is kept from step to step
};

/// Whether marches run in one dispatch each, and if they do not, the states they are kept in.
class MarchBudget {
 public:
  /// In one dispatch up to here: the estimate is a bound, but drivers count loops we do not.
  static constexpr double kOneDispatch = 40000;
  /// Iterations a lane may begin more work with: 8 lanes x (kLane + the longest march through a volume) <
  /// 65535.
  static constexpr int kLane = 3500;
  /// Where only time counts.
  static constexpr int kLeastLane = 256, kMostLane = 1 << 20;

  static constexpr int kNever = -1;
  /// `lane` kNever: one dispatch whatever it costs; > 0: pauses on every device, wherever a lane has run so
  /// many iterations (for tests).
  void plan(const MarchCost& cost, const gl::DeviceInfo& device, int lane = 0);
  bool resumes() const { return pace_.now > 0; }
  /// Variant constant REACHED of lib/resume.glsl.
  int reached() const { return cost_.reached; }
  /// Before each dispatch over `pixels` pixels of a region; sets the uniforms of lib/resume.glsl.
  Result<void> bind(gl::Program& program, int pixels);
  /// How long that dispatch took: on a GPU the next one's lanes get more or less to do.
  void took(double ms) { pace_.took(ms); }
  /// Behind it: the region's pixels that have to go on. Waits for the dispatch.
  int unfinished();

 private:
  MarchCost cost_;
  gl::Pace pace_{0, 0, 0};  ///< iterations of a lane; 0: one dispatch whatever it costs
  int dispatched_ = 0;      ///< of the region at work: 0, its first dispatch is still to come
  gl::Buffer states_{"march states"};
};

}  // namespace pileus::residency
