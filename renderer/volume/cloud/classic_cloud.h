#pragma once
// The classic clouds: trees of balls under cell noise. Kept as they were, voxel for voxel.
#include <memory>

#include "renderer/volume/cloud/procedural.h"

namespace pileus::volume {

class ClassicCloud {
 public:
  /// `voxel`: their edge in metres. Cancelled, it holds what stands so far.
  ClassicCloud(const CloudParams& params, float voxel, JobControl& control);
  ~ClassicCloud();

  /// Fills the 16^3 voxels of a brick, those below `voxels` alone. False where all are 0, or when cancelled;
  /// `out` may then hold anything.
  bool brick(ivec3 brick, ivec3 voxels, float* out, JobControl& control) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace pileus::volume
