#pragma once
// A finished picture against the judge: the same scene by unbiased paths, and how far from them it is; beside
// them the judge's light by orders of scattering. GL thread.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/image/metrics.h"
#include "renderer/view/path_trace.h"

namespace pileus::truth {

struct JudgeOptions {
  int bounces = 0;    ///< as view::PathOptions has it
  int samples = 256;  ///< of the judge and of each order; 2 or more
  double seconds =
      0;  ///< for all of it, behind whole samples: half the judge's, half the orders'; 0: no limit
};

/// Over RGB and the pixels that scaled relMSE counts.
struct JudgedMean {
  double value = 0, standardError = 0;
};

struct JudgedOrder {
  std::string layer;  ///< "order3_4"
  std::string label;  ///< "3-4"
  JudgedMean mean;
  int samples = 0;
  image::Layer pixels;
};

struct JudgeFigures {
  image::ScaledRelMse scaled;
  JudgedMean judge;
  double ratioError = 0;  ///< standard error of scaled.ratio, by the judge's noise
  double noise = 0;       ///< sqrt(mean variance of pixel means) / mean, of the judge
  double noiseBias = 0;   ///< about what that noise adds to scaled relMSE; more samples where it counts
  int samples = 0;
  bool endedByTime = false;
  long violations = 0, endless = 0;  ///< as view::PathStatistics has them, of all that was traced
};

class JudgePass {
 public:
  /// `picture`: the beauty first, of the scene's size, read back from what was rendered of the scene.
  JudgePass(image::Image picture, view::RenderScene scene, const JudgeOptions& options);
  /// Works for about `ms` milliseconds (at least one dispatch); the fraction done, 1 = finished. Error
  /// (Input): no pixel of the picture counts, sizes differ, or the time was enough for a single sample.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  double fraction() const;
  /// What it is at: "Tracing the judge".
  std::string doing() const;
  /// Of the judge: once its paths are traced (then fraction() is above 0 for the orders alone).
  const JudgeFigures& figures() const { return figures_; }
  /// Those within the bounces, which together are the judge; complete once step() said 1.
  const std::vector<JudgedOrder>& orders() const { return orders_; }
  /// The picture, and as layers the judge, the difference (picture less judge), the judge's variance and the
  /// orders; once step() said 1.
  image::Image picture() const;

 private:
  bool done() const { return at_ > 0 && (at_ > orders_.size() || orders_.size() == 1); }
  void begin();
  Result<void> take();
  Result<void> measure();
  JudgedMean meanOf(const image::Layer& pixels, const image::Layer& variance) const;
  image::Image picture_;
  view::RenderScene scene_;
  JudgeOptions options_;
  std::optional<view::PathTracePass> pass_;
  std::size_t at_ = 0;  ///< 0: the judge, then the orders
  double part_ = 0;
  image::Layer judge_, variance_;
  std::vector<JudgedOrder> orders_;
  JudgeFigures figures_;
};

}  // namespace pileus::truth
