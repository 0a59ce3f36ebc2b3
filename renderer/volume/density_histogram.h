#pragma once
// How often each density occurs in volumes: for what is drawn behind curves. Any thread.
#include <optional>
#include <vector>

#include "renderer/base/jobs.h"
#include "renderer/volume/instance.h"

namespace pileus::volume {

struct DensityHistogram {
  double highest = 0;          ///< the right end of the last bin; the first begins at 0
  std::vector<double> counts;  ///< voxels, without those of no density

  /// Voxels with densities from .. to, parts of bins included.
  double between(double from, double to) const;
};

/// Of grids as remapped, at the finest level with at most some two million voxels; a shape counts as 64
/// voxels along each axis. Nothing when cancelled.
std::optional<DensityHistogram> densityHistogram(const InstanceList& instances, const JobControl& control);

}  // namespace pileus::volume
