#pragma once
// What passes share that march camera rays through the media of a scene (lib/camera_march.glsl). GL thread.
#include <span>
#include <vector>

#include "renderer/residency/region_run.h"
#include "renderer/shadow/gpu.h"
#include "renderer/view/light_set.h"
#include "renderer/view/render_scene.h"

namespace pileus::view {

/// Uniforms of lib/camera.glsl, places relative to `origin`.
void setCamera(gl::Program& program, const RenderOptions& options, const dvec3& origin);
/// Shaders count positions from here: the eye, or what of the drawn media is nearest to it. Seen from far
/// away the light on them is looked up as exactly as from near by.
dvec3 originOf(const RenderOptions& options, const LightSet& lights);

class CameraMarch {
 public:
  /// Uploads the bricks of these lights' volumes for about `ms` milliseconds; go on once its fraction is 1.
  Result<residency::Residency> prepare(const shadow::Gpu& gpu, const RenderOptions& options,
                                       const LightSet& lights, double ms);
  /// Lists of what is drawn: the same, whichever lights there are.
  void list(const RenderOptions& options, const LightSet& lights);
  /// How marches under these lights pause; `lane` as in MarchBudget::plan(), `reached` as in MarchCost.
  void plan(residency::MarchBudget& budget, const RenderOptions& options, const LightSet& lights,
            const gl::DeviceInfo& device, int lane, int reached = 1) const;
  /// The variant of an entry for what is listed and these lights, with `defines` of its own; current, with
  /// volumes, lists, camera and solids bound. The lights are the caller's to bind, with run.origin() and
  /// before: what they have in the run's table is bound with it.
  Result<gl::Program*> bind(const shadow::Gpu& gpu, const char* entry, const RenderOptions& options,
                            const LightSet& lights, const residency::MarchBudget& budget,
                            const gl::Defines& defines = {});

  residency::RegionRun run;

 private:
  std::vector<residency::PixelBounds> bounds_;  ///< of the drawn volumes
};

}  // namespace pileus::view
