#pragma once
// The density of clouds as a pure function of position, size of the voxels and time: no state, nothing stored
// but where the clouds stand. Bricks can be evaluated one by one, in any order and at any level of detail.
#include <memory>

#include "renderer/base/jobs.h"
#include "renderer/volume/cloud/procedural.h"

namespace pileus::volume {

/// Positions are metres from the box's lowest corner. Nothing is outside the box.
class CloudField {
 public:
  virtual ~CloudField() = default;

  /// Density at p as voxels of that edge [m] see it: what they cannot carry is replaced by its mean.
  virtual float density(vec3 p, float voxel) const = 0;

  /// The same at 16^3 points `voxel` apart from `first` on, x fastest. False where all are 0; `out` is then
  /// left as it was.
  virtual bool brick(vec3 first, float voxel, float* out) const = 0;
};

/// The field of any genus but the classic one. May take a moment where thousands of clouds are placed;
/// cancelled, it holds those that stand so far.
std::unique_ptr<const CloudField> cloudField(const CloudParams& params, JobControl& control);

/// Those it is made of; one per genus.
std::unique_ptr<const CloudField> cumulusField(const CloudParams& params, JobControl& control);
std::unique_ptr<const CloudField> stratusField(const CloudParams& params);
std::unique_ptr<const CloudField> cirrusField(const CloudParams& params);

}  // namespace pileus::volume
