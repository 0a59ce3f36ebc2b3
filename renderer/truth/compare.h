#pragma once
// A picture against the truth: the same scene and camera with every shadow marched, or by unbiased paths.
// Both pictures are made region by region in step, so that in a march their noise is the same and their
// difference is the shadows' alone, and beside them the error of the shadows themselves along the camera
// rays, which are always compared with marched ones. GL thread.
#include <array>
#include <memory>

#include "renderer/truth/shadow_error.h"
#include "renderer/truth/truth_picture.h"

namespace pileus::truth {

/// Of |difference|.
struct ErrorFigures {
  double mean = 0, p95 = 0, maximum = 0;
};

struct CompareFigures {
  ErrorFigures
      shadow;  ///< |dT| over the light-ray samples in media that the picture's rays meet, all lights alike
  double leak = 0,
         dark = 0;         ///< means of max(dT, 0) and max(-dT, 0) weighted by how much of a sample is seen
  double samples = 0;      ///< those the shadow's figures stand on
  ErrorFigures radiance;   ///< |dL|, mean of RGB, over the pixels where the truth covers something
  double relMse = 0;       ///< of radiance, as image::compare has it; against the judge scaled relMSE
  int pictureSamples = 0;  ///< finished samples a pixel the radiance figures stand on
};

/// The scene with every shadow replaced by a march through its volumes, steps of `stepScale` voxels.
view::RenderScene truthOf(const view::RenderScene& scene, double stepScale = 0.5);

/// Which of its pictures a comparison begins with.
enum class CompareOrder {
  Together,   ///< the figures are of the same samples all the time
  TruthFirst  ///< a whole truth is there before anything else, also before maps that the picture would need
};

class ComparePass {
 public:
  explicit ComparePass(const view::RenderScene& scene, TruthKind kind = TruthKind::Marched,
                       CompareOrder order = CompareOrder::Together);
  /// Works for about `ms` milliseconds (at least one region); the fraction done, 1 = finished.
  Result<double> step(const shadow::Gpu& gpu, double ms);
  double fraction() const { return fraction_; }
  /// Null until their first region is drawn; improving until step() said 1.
  std::shared_ptr<const view::Picture> mapped() const { return mapped_.picture(); }
  std::shared_ptr<const view::Picture> truth() const { return truth_.picture(); }
  /// Whole passes over the picture: then nothing of it is missing.
  bool truthWhole() const { return truth() && truth()->samples > 0; }
  bool pictureWhole() const { return truthWhole() && mapped() && mapped()->samples > 0; }
  bool shadowWhole() const { return error_.fraction() >= 1; }
  const ShadowErrorPass& shadowError() const { return error_; }
  const CompareFigures& figures() const { return figures_; }
  const view::RenderScene& scene() const { return scene_; }
  TruthKind kind() const { return kind_; }
  /// Samples that the truth has in the end.
  int truthSamples() const { return truth_.picture() ? truth_.picture()->scene->options.samples : 0; }

 private:
  Result<void> measureRadiance();
  view::RenderScene scene_;
  TruthKind kind_;
  CompareOrder order_;
  AnyPass mapped_, truth_;
  ShadowErrorPass error_;
  CompareFigures figures_;
  double mappedFraction_ = 0, truthFraction_ = 0, pictureFraction_ = 0, fraction_ = 0;
};

/// The colour of an error e in [-1, 1]: from blue (too dark) over near black to red (light leaks), linear
/// steps of display values.
vec3 falseColour(double e);

/// Draws what a comparison shows, ready for the display.
class CompareDisplay {
 public:
  enum class Show { RadianceError, ShadowError, WorstError, MappedTransmittance, TrueTransmittance };
  /// The error `scale` is shown in the colours' ends. The texture (RGBA8, of the pass's size, row 0 on top)
  /// stays the display's own and valid until the next call with the same slot; 0 while there is nothing to
  /// show.
  Result<unsigned> draw(gl::ShaderLibrary& shaders, const ComparePass& pass, Show show, double scale,
                        int slot = 0);

 private:
  std::array<gl::Texture, 2> targets_;
  gl::Texture colours_;
};

}  // namespace pileus::truth
